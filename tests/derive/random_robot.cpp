// SPDX-License-Identifier: MIT
#include "random_robot.h"

#include <array>
#include <random>

#include <fmt/format.h>

namespace qvgen::test {
namespace {

class Writer {
 public:
  explicit Writer(std::uint32_t seed) : random_(seed) {}

  std::string description() {
    std::string joints;
    const bool table = below(4) == 0;
    const int count = 1 + below(7);
    for (int i = 0; i < count; ++i) joints += table ? row(i) : joint(i);
    std::string text = "name = \"random\"\ntitle = \"random arm\"\n";
    if (table) text += fmt::format("convention = \"{}\"\n", below(2) == 0 ? "standard" : "modified");
    if (symbols_ > 0) text += "[defaults]\n";
    for (int i = 0; i < symbols_; ++i) text += fmt::format("l{} = {}\n", i, 0.15 + 0.1 * i);
    return text + joints;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }

  std::string length() {
    switch (below(5)) {
      case 0:
        return fmt::format("\"l{}\"", symbols_++);
      case 1:
        return fmt::format("\"-l{}\"", symbols_++);
      case 2:
        return fmt::format("\"{}/7\"", 1 + below(6));
      default:
        return "0";
    }
  }

  std::string axis() {
    static constexpr std::array<const char*, 8> axes{"\"+x\"",
                                                     "\"-x\"",
                                                     "\"+y\"",
                                                     "\"-y\"",
                                                     "\"+z\"",
                                                     "\"-z\"",
                                                     "[\"3/5\", 0, \"4/5\"]",
                                                     "[\"2/7\", \"-3/7\", \"6/7\"]"};
    return axes[static_cast<std::size_t>(below(below(3) == 0 ? 8 : 6))];
  }

  std::string joint(int i) {
    const bool revolute = below(3) != 0;
    std::string text = fmt::format("[[joint]]\ntype = \"{}\"\naxis = {}\nvariable = \"q{}\"\n",
                                   revolute ? "revolute" : "prismatic", axis(), i);
    text += fmt::format("origin = [{}, {}, {}]\n", length(), length(), length());
    if (revolute) text += fmt::format("link = [{}, {}, {}]\n", length(), length(), length());
    if (below(4) == 0)
      text += fmt::format("rpy = [\"{} deg\", 0, \"{} deg\"]\n", 30 * below(12), 90 * below(4));
    return text;
  }

  std::string row(int i) {
    const bool revolute = below(3) != 0;
    const std::string variable = fmt::format("q{}", i);
    return fmt::format(
        "[[dh]]\ntype = \"{}\"\nvariable = \"{}\"\ntheta = \"{}\"\nd = {}\na = {}\nalpha = \"{} deg\"\n",
        revolute ? "revolute" : "prismatic", variable,
        revolute ? variable : fmt::format("{} deg", 90 * below(4)),
        revolute ? length() : "\"" + variable + "\"", length(), 90 * below(4));
  }

  std::mt19937 random_;
  int symbols_ = 0;
};

}  // namespace

std::string random_description(std::uint32_t seed) { return Writer(seed).description(); }

}  // namespace qvgen::test
