// SPDX-License-Identifier: MIT
// Intervals of the given joint within limits: the margin sampled, refined next to its zeros, bisected.
#include <qvgen/inverse/given_joint.h>

namespace qvgen {

double GivenIntervals::nearest(double wanted) const {
  double best = wanted;
  double least = std::numeric_limits<double>::infinity();
  for (const GivenInterval& each : *this) {
    const double value = std::min(std::max(wanted, each.from), each.to);
    if (!(std::abs(value - wanted) < least)) continue;
    least = std::abs(value - wanted);
    best = value;
  }
  return best;
}

namespace inverse::given_joint {
namespace {

constexpr int coarse_steps = 192;
constexpr int most_halvings = 7;
/// Calls after which no stretch is looked into further. Those of bisecting come on top, `most_bisections` for
/// each end of an interval that there is room for.
constexpr int most_calls = 4000;
constexpr int most_bisections = 60;
/// Rates change between samples: a zero may be nearer than they say, by this factor.
constexpr double nearer = 3;

struct Sample {
  double at;
  double margin;
  double way;  ///< see Margin
};

bool is_inside(const Sample& sample) { return sample.margin >= 0; }

/// Walks along the range from left to right and closes an interval at each change of sign.
class Walk {
 public:
  Walk(const Function& function, double lower) : function_(function), last_(sample(lower)) {
    if (is_inside(last_)) from_ = lower;
  }

  void go_to(double at) { refine(last_, sample(at), 0); }

  GivenIntervals finish() {
    if (is_inside(last_)) close(last_.at);
    if (found_.status != Status::incomplete && !found_.empty()) found_.status = Status::solved;
    return found_;
  }

 private:
  Sample sample(double at) {
    const Margin margin = function_.margin(function_.functions, at);
    ++calls_;
    if (margin.is_incomplete) found_.status = Status::incomplete;
    if (margin.value > found_.widest_margin) {
      found_.widest_margin = margin.value;
      found_.widest_margin_at = at;
    }
    return {at, margin.value, margin.way};
  }

  /// True if a margin may change its sign between two samples, by the rates at either.
  static bool is_doubtful(const Sample& a, const Sample& b) {
    return std::min(a.way, b.way) < nearer * (b.at - a.at);
  }

  void refine(Sample a, Sample b, int halvings) {
    const bool same_side = is_inside(a) == is_inside(b);
    // A change of sign is looked into as well, a little: it may be three.
    const int most = same_side ? most_halvings : 2;
    const bool is_wanted = halvings < most && is_doubtful(a, b);
    if (is_wanted && calls_ >= most_calls) found_.status = Status::incomplete;
    if (is_wanted && calls_ < most_calls) {
      const Sample middle = sample(0.5 * (a.at + b.at));
      refine(a, middle, halvings + 1);
      refine(middle, b, halvings + 1);
      return;
    }
    step(a, b);
  }

  void step(Sample a, Sample b) {
    last_ = b;
    const bool is_full = found_.size() == GivenIntervals::max_size;
    if (is_full && is_inside(b)) found_.status = Status::incomplete;
    if (is_full || is_inside(a) == is_inside(b)) return;
    const double end = bisected(a, b);
    if (is_inside(b))
      from_ = end;
    else
      close(end);
  }

  /// The end on the inner side.
  double bisected(Sample a, Sample b) {
    for (int i = 0; i < most_bisections; ++i) {
      const double middle = 0.5 * (a.at + b.at);
      if (middle <= a.at || middle >= b.at) break;
      const Sample next = sample(middle);
      (is_inside(next) == is_inside(a) ? a : b) = next;
    }
    return is_inside(a) ? a.at : b.at;
  }

  void close(double to) {
    if (!found_.append({from_, to})) found_.status = Status::incomplete;
  }

  const Function& function_;
  GivenIntervals found_;
  int calls_ = 0;
  Sample last_;
  double from_ = 0;
};

}  // namespace

GivenIntervals intervals(const Function& function, double lower, double upper) {
  Walk walk(function, lower);
  for (int i = 1; i <= coarse_steps; ++i)
    walk.go_to(i == coarse_steps ? upper : lower + (upper - lower) * i / coarse_steps);
  return walk.finish();
}

}  // namespace inverse::given_joint
}  // namespace qvgen
