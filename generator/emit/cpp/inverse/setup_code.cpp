// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/setup_code.h"

#include <cmath>

#include <fmt/format.h>

namespace qvgen::emit {
namespace {

using namespace inverse::elimination;

/// Collects lines of text that are not too long to read.
class Initialiser {
 public:
  void open(const std::string& comment = "") {
    token("{");
    if (!comment.empty()) {
      lines_.back() += "  // " + comment;
      start_line();
    }
  }
  void close() { token("}"); }
  void comma() { lines_.back() += ","; }
  /// Entries are of order one: what is this small is the rounding of a zero.
  void number(double x) { token(std::abs(x) < 1e-18 ? "0" : fmt::format("{}", x)); }
  void integer(int x) { token(std::to_string(x)); }
  void text(const std::string& x) { token(x); }
  void truth(bool x) { token(x ? "true" : "false"); }
  void start_line() { lines_.emplace_back(); }

  template <class Range, class Each>
  void list(const Range& range, const Each& each) {
    open();
    bool first = true;
    for (const auto& x : range) {
      if (!first) comma();
      first = false;
      each(x);
    }
    close();
  }
  template <class Range>
  void numbers(const Range& range) {
    list(range, [this](double x) { number(x); });
  }

  [[nodiscard]] std::vector<std::string> lines() const { return lines_; }

 private:
  void token(const std::string& text) {
    constexpr std::size_t longest = 118;
    if (lines_.back().size() + text.size() + 2 > longest) start_line();
    std::string& line = lines_.back();
    const bool apart = !line.empty() && line.back() == ',';
    line += (apart ? " " : "") + text;
  }

  std::vector<std::string> lines_{""};
};

void add(Initialiser& to, const Motion& motion) {
  to.open();
  to.numbers(motion.rotation);
  to.comma();
  to.numbers(motion.translation);
  to.close();
}

void add(Initialiser& to, const Chain& chain) {
  to.open("chain: into the first axis's frame, links, slides, size, reach");
  add(to, chain.to_base);
  to.comma();
  to.list(chain.links, [&](const Motion& link) { add(to, link); });
  to.comma();
  to.list(chain.slides, [&](bool slide) { to.truth(slide); });
  to.comma();
  to.number(chain.size);
  to.comma();
  to.number(chain.reach);
  to.close();
}

void add(Initialiser& to, const Description& arm) {
  to.open("axes and tool at the zero pose");
  to.list(arm.axes, [&](const inverse::Screw<double>& screw) {
    to.open();
    to.truth(screw.revolute);
    to.comma();
    to.numbers(screw.axis);
    to.comma();
    to.numbers(screw.point);
    to.close();
  });
  to.comma();
  add(to, arm.tool);
  to.close();
}

const char* name_of(Pair pair) {
  switch (pair) {
    case Pair::skew:
      return "inverse::elimination::Pair::skew";
    case Pair::repeats:
      return "inverse::elimination::Pair::repeats";
    case Pair::confuses:
      return "inverse::elimination::Pair::confuses";
    default:
      return "inverse::elimination::Pair::slides";
  }
}

template <std::size_t rows>
void add(Initialiser& to, const double (&table)[rows][15]) {
  to.start_line();
  to.list(table, [&](const auto& row) { to.numbers(row); });
}

void add(Initialiser& to, const Elimination& e) {
  to.start_line();
  to.open(
      "elimination: direction, shift, joints, slides, links, pair, equations, their derivatives, pair "
      "values");
  to.truth(e.backwards);
  to.comma();
  to.integer(e.shift);
  to.comma();
  to.list(e.joint, [&](int joint) { to.integer(joint); });
  to.comma();
  to.list(e.slide, [&](bool slide) { to.truth(slide); });
  to.comma();
  to.list(e.link, [&](const Motion& link) { add(to, link); });
  to.comma();
  to.text(name_of(e.pair));
  const auto table = [&](const auto& values, bool is_there) {
    to.comma();
    if (is_there)
      add(to, values);
    else
      to.text("{}");
  };
  const bool has_pair = e.pair != Pair::slides;
  table(e.equations, has_pair);
  table(e.derived, has_pair && e.pair != Pair::skew);
  table(e.pair_values, has_pair);
  to.close();
}

/// Adds the choices that are set up for a pose in doubt, if there are any.
void add(Initialiser& to, const Choices& further) {
  if (further.count == 0) return to.text("{}");
  to.start_line();
  to.open("set up for a pose in doubt: how many, whether backwards, and where they begin");
  to.integer(further.count);
  to.comma();
  to.open();
  for (int i = 0; i < further.count; ++i) {
    if (i > 0) to.comma();
    to.open();
    to.truth(further.choice[i].backwards);
    to.comma();
    to.integer(further.choice[i].shift);
    to.close();
  }
  to.close();
  to.close();
}

}  // namespace

std::vector<std::string> setup_lines(const Setup& setup) {
  Initialiser to;
  to.open();
  add(to, setup.chain);
  to.comma();
  to.start_line();
  add(to, setup.description);
  to.comma();
  to.integer(setup.count);
  to.comma();
  to.open();
  for (int i = 0; i < setup.count; ++i) {
    if (i > 0) to.comma();
    add(to, setup.eliminations[i]);
  }
  to.close();
  to.comma();
  add(to, setup.further);
  to.close();
  return to.lines();
}

}  // namespace qvgen::emit
