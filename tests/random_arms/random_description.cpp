// SPDX-License-Identifier: MIT
#include "random_description.h"

#include <random>
#include <vector>

namespace qvgen::test {
namespace {

class Writer {
 public:
  enum class Moved { alone, by_others, by_motors };
  Writer(std::uint32_t seed, bool with_inertia, Moved moved = Moved::alone)
      : random_(seed + 1), with_inertia_(with_inertia), moved_(moved) {
    joints_ = moved == Moved::alone ? 1 + below(8) : 2 + below(5);
    plain_ = below(4) == 0;  // right angles and simple offsets alone
  }

  std::string write(std::uint32_t seed) {
    const int form = below(4);
    std::string body = form == 0 ? screws() : form == 1 ? joint_tables() : link_table();
    std::string text = "name = \"arm_" + std::to_string(seed) + "\"\ntitle = \"random arm\"\n";
    if (form >= 2) text += form == 2 ? "convention = \"standard\"\n" : "convention = \"modified\"\n";
    for (const char* frame : {"base", "tool"})
      if (form != 0 && below(3) == 0) text += constant_frame(frame);
    return text + body + motors_;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }
  std::string pick(const std::vector<std::string>& from) {
    return from[static_cast<std::size_t>(below(static_cast<int>(from.size())))];
  }

  static std::string quoted(const std::string& text) { return "\"" + text + "\""; }
  static std::string vector(const std::string& x, const std::string& y, const std::string& z) {
    return "[" + quoted(x) + ", " + quoted(y) + ", " + quoted(z) + "]";
  }

  std::string decimal() { return (below(2) == 0 ? "-0." : "0.") + std::to_string(100 + below(900)); }

  std::string length() {
    const std::string number = std::to_string(below(9) + 1);
    const std::string symbol = "l" + number;
    if (plain_) return pick({"0", "0", "0.3", symbol, "-" + symbol});
    switch (below(9)) {
      case 0:
      case 1:
      case 2:
        return "0";
      case 3:
        return decimal();
      case 4:
        return symbol;
      case 5:
        return "-" + symbol + "/3";
      case 6:
        return symbol + "/h1";
      case 7:
        return "sqrt(" + symbol + "^2 + h1^2)";
      default:
        return pick({"0.3*cos(10 deg)", "sqrt(3)/10", "1/3", "0.25*sin(0.4)"});
    }
  }

  std::string angle() {
    if (plain_) return pick({"0", "0", "90 deg", "-90 deg", "180 deg"});
    switch (below(7)) {
      case 0:
        return "0";
      case 1:
        return pick({"90 deg", "-90 deg"});
      case 2:
        return pick({"30 deg", "-45 deg", "60 deg", "120 deg", "-150 deg"});
      case 3:
        return pick({"1.5708", "-1.5708", "0.1", "3.1416", "-0.7854"});
      case 4:
        return decimal();
      case 5:
        return pick({"79.35 deg", "-79.35 deg", "0.0057 deg", "55 deg"});
      default:
        return pick({"0", "90 deg", "-90 deg", "pi", "pi/2"});
    }
  }

  std::string axis() {
    const std::vector<std::string> along = {"\"+x\"", "\"-x\"", "\"+y\"", "\"-y\"", "\"+z\"", "\"-z\""};
    if (plain_ || below(3) > 0) return pick(along);
    return pick({"[\"1/sqrt(3)\", \"1/sqrt(3)\", \"1/sqrt(3)\"]", "[0.6, 0, 0.8]",
                 "[\"1/sqrt(2)\", 0, \"-1/sqrt(2)\"]", "[0, \"sin(0.3)\", \"cos(0.3)\"]",
                 "[\"1/2\", 0, \"sqrt(3)/2\"]"});
  }

  std::string inertia() {
    if (!with_inertia_) return "";
    return "mass = 2.5\ncentre_of_mass = [0.05, -0.01, 0.1]\ninertia = [0.02, 0.03, 0.025, 0.001, 0.002, "
           "-0.003]\n";
  }

  std::string head(int i, bool slides) {
    const std::string variable = (slides ? "d" : "theta") + std::to_string(i + 1);
    return "type = " + std::string(slides ? "\"prismatic\"" : "\"revolute\"") + "\nvariable = \"" + variable +
           "\"\n" + inertia() + follows(i, slides, variable);
  }

  /// The second joint follows the first, others one before them now and then.
  std::string follows(int i, bool slides, const std::string& variable) {
    if (moved_ == Moved::by_motors) return follows_motors(i, variable);
    if (moved_ == Moved::alone) return "";
    if (i == 0 || (i > 1 && below(3) > 0)) {
      leaders_.push_back(variable);
      return "";
    }
    const std::string offset = below(2) == 0 ? "0" : slides ? decimal() : angle();
    return "follows = " + quoted(pick(leaders_)) +
           "\nratio = " + quoted(pick({"-1", "1", "2/3", "1.06", "-0.5", "-7/3"})) +
           "\noffset = " + quoted(offset) +
           "\nviscous_friction = 0.3\ncoulomb_friction = 0.2\nrotor_inertia = 0.01\n";
  }

  std::string new_motor(int i) {
    const std::string name = "m" + std::to_string(i + 1);
    motors_ += "\n[[motor]]\nvariable = \"" + name + "\"\nrotor_inertia = " + pick({"0.02", "0.3"}) +
               "\nviscous_friction = 0.1\ncoulomb_friction = 0.2\n";
    return name;
  }

  std::string factor() { return pick({"", "1/2 ", "2/3 ", "1.06 ", "3 ", "7/3*"}); }

  /// Joint i of a pair has half the sum, the next one half the difference, of their motors; of others the
  /// last motor or none is among those that the joint follows.
  std::string follows_motors(int i, const std::string& variable) {
    const std::string own = "m" + std::to_string(i + 1), before = "m" + std::to_string(i);
    std::string sum;
    if (second_of_pair_) {
      new_motor(i);
      sum = "(" + before + " - " + own + ")/2 - 20 deg";
      second_of_pair_ = false;
    } else if (i + 1 < joints_ && below(3) == 0) {
      new_motor(i);
      sum = "1/2 " + own + " + 0.5 m" + std::to_string(i + 2);
      second_of_pair_ = true;
    } else if (i > 0 && below(4) > 0) {
      sum = (below(2) == 0 ? "-" : "") + factor() + new_motor(i);
      for (const std::string& other : leaders_)
        if (below(2) == 0) sum += (below(2) == 0 ? " + " : " - ") + factor() + other;
    }
    leaders_.push_back(sum.empty() ? variable : own);
    if (sum.find(' ') == std::string::npos && !sum.empty()) sum += " + 0.3 rad";
    return sum.empty() ? "" : "follows = " + quoted(sum) + "\nviscous_friction = 0.3\nrotor_inertia = 0.01\n";
  }

  std::string joint_tables() {
    std::string text;
    for (int i = 0; i < joints_; ++i) {
      const bool slides = below(5) == 0;
      text += "\n[[joint]]\n" + head(i, slides) + "axis = " + axis() + "\n";
      if (below(2) == 0) text += "origin = " + vector(length(), length(), length()) + "\n";
      if (below(2) == 0) text += "rpy = " + vector(angle(), angle(), angle()) + "\n";
      if (below(2) == 0) text += "link = " + vector(length(), length(), length()) + "\n";
    }
    return text;
  }

  std::string link_table() {
    std::string text;
    for (int i = 0; i < joints_; ++i) {
      const bool slides = below(5) == 0;
      text += "\n[[dh]]\n" + head(i, slides);
      const std::string variable = (slides ? "d" : "theta") + std::to_string(i + 1);
      const std::string offset = angle();
      if (slides)
        text += "d = " + quoted(variable) + "\ntheta = " + quoted(angle()) + "\n";
      else
        text += "d = " + quoted(length()) +
                "\ntheta = " + quoted(variable + (offset == "0" ? "" : " + " + offset)) + "\n";
      text += "a = " + quoted(length()) + "\nalpha = " + quoted(angle()) + "\n";
    }
    return text;
  }

  std::string screws() {
    std::string text;
    for (int i = 0; i < joints_; ++i) {
      const bool slides = below(5) == 0;
      text += "\n[[screw]]\n" + head(i, slides) + "axis = " + axis() + "\n";
      if (!slides) text += "point = " + vector(length(), length(), length()) + "\n";
    }
    return text + "\n[home]\ntranslation = " + vector(length(), length(), length()) + "\n";
  }

  std::string constant_frame(const std::string& name) {
    return "[" + name + "]\ntranslation = " + vector(length(), "0.1", length()) +
           "\nrpy = " + vector(angle(), angle(), angle()) + "\n";
  }

  std::mt19937 random_;
  bool with_inertia_;
  Moved moved_;
  bool second_of_pair_ = false;
  std::string motors_;
  std::vector<std::string> leaders_;
  int joints_ = 1;
  bool plain_ = false;
};

}  // namespace

std::string random_description(std::uint32_t seed) { return Writer(seed, false).write(seed); }
std::string random_description_with_inertia(std::uint32_t seed) { return Writer(seed, true).write(seed); }
std::string random_description_with_followers(std::uint32_t seed) {
  return Writer(seed, true, Writer::Moved::by_others).write(seed);
}

std::string random_description_with_motors(std::uint32_t seed) {
  return Writer(seed, true, Writer::Moved::by_motors).write(seed);
}

}  // namespace qvgen::test
