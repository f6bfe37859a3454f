// SPDX-License-Identifier: MIT
// The pose of the target in the tracker's frame, and its derivative by every parameter: each parameter is an
// elementary motion, so its column is that of a joint, axis x (end - point) for a turn and the axis for a
// shift.
#pragma once

#include "calibrate/geometry.h"
#include "calibrate/parameter.h"

namespace qvgen::calibrate {

/// Velocity of the target per unit of a parameter, seen from the tracker.
template <class S>
struct Column {
  Vec<S> linear{}, angular{};
};

/// One set of joint values; followers have theirs.
template <class S>
struct Posture {
  std::vector<S> values;            ///< a slide's, m
  std::vector<CosSin<S>> circular;  ///< a turn's
  std::vector<S> loads =
      {};  ///< shares of the greatest load that gravity puts on each joint; empty: not asked for
};

template <class S>
struct Model {
  Geometry<S> geometry;
  std::vector<Parameter> parameters;
  std::vector<std::vector<std::size_t>> of_gap;  ///< indices of parameters, in the order of their motions
};

template <class S>
struct Frames {
  Rigid<S> tracker;               ///< base -> tracker
  std::vector<Rigid<S>> targets;  ///< each, in the tool's frame
};

template <class S>
struct Prediction {
  Rigid<S> pose;
  std::vector<Column<S>> columns;  ///< of all parameters; zero for surfaces and other targets
};

/// Sorts parameters by gap.
std::vector<std::vector<std::size_t>> by_gap(const std::vector<Parameter>& parameters, std::size_t gaps);

/// Walks along the chain. `amount(index)` is the value of a parameter; the field has zeros.
template <class S, class Amount>
class Walk {
 public:
  Walk(const Model<S>& model, const Posture<S>& posture, const Frames<S>& frames, const S& one, Amount amount)
      : model_(model), posture_(posture), frames_(frames), one_(one), amount_(amount) {}

  Prediction<S> to(std::size_t target) {
    const std::size_t gaps = model_.geometry.gaps.size();
    target_ = target;
    records_.resize(model_.parameters.size());
    at_ = frames_.tracker;
    err(0, identity(one_).axes);
    for (std::size_t i = 0; i < gaps; ++i) {
      const Gap<S>& gap = model_.geometry.gaps[i];
      at_ = at_ * gap.way;
      err(i + 1, gap.directions);
      if (i + 1 < gaps) at_ = at_ * motion(i, gap.directions[2]);
    }
    at_ = at_ * frames_.targets[target];
    err(gaps + 1, identity(one_).axes);
    return finish();
  }

 private:
  struct Record {
    bool met = false, turns = false;
    Vec<S> axis{}, point{};
  };

  Rigid<S> motion(std::size_t joint, const Vec<S>& axis) const {
    if (!model_.geometry.joints[joint].revolute) return shift(posture_.values[joint] * axis, one_);
    const CosSin<S>& value = posture_.circular[joint];
    return turn(axis, value.cosine, value.sine, one_);
  }

  /// Goes through the errors of a gap.
  void err(std::size_t gap, const std::array<Vec<S>, 3>& directions) {
    for (const std::size_t index : model_.of_gap[gap]) {
      const Parameter& each = model_.parameters[index];
      const bool elsewhere =
          (each.kind == Kind::target_shift || each.kind == Kind::target_turn) && each.object != target_;
      if (elsewhere) continue;
      Vec<S> axis = directions[each.direction];
      records_[index] = {true, each.turn, turned(at_, weighed(each, axis)), at_.position};
      at_ = amount_(index, each, axis, weight(each), at_);
    }
  }

  [[nodiscard]] S weight(const Parameter& each) const {
    if (each.kind == Kind::eccentric_cosine) return posture_.circular[each.gap - 1].cosine;
    if (each.kind == Kind::bend) return posture_.loads[each.gap - 1];
    return each.kind == Kind::eccentric_sine ? posture_.circular[each.gap - 1].sine : one_;
  }
  [[nodiscard]] Vec<S> weighed(const Parameter& each, const Vec<S>& axis) const {
    return weight(each) * axis;
  }

  Prediction<S> finish() const {
    Prediction<S> result{at_, std::vector<Column<S>>(records_.size())};
    for (std::size_t i = 0; i < records_.size(); ++i) {
      const Record& record = records_[i];
      if (!record.met) continue;
      if (record.turns)
        result.columns[i] = {cross(record.axis, at_.position - record.point), record.axis};
      else
        result.columns[i].linear = record.axis;
    }
    return result;
  }

  const Model<S>& model_;
  const Posture<S>& posture_;
  const Frames<S>& frames_;
  S one_;
  Amount amount_;
  Rigid<S> at_;
  std::vector<Record> records_;
  std::size_t target_ = 0;
};

/// Returns the prediction in the field, with all errors zero.
Prediction<Field> predict(const Model<Field>& model, const Posture<Field>& posture,
                          const Frames<Field>& frames, std::size_t target);
/// Returns the prediction with these values of all parameters.
Prediction<double> predict(const Model<double>& model, const Posture<double>& posture,
                           const Frames<double>& frames, std::size_t target,
                           const std::vector<double>& values);

/// Returns the posture of joint values (rad, m), one for each joint that follows none.
Posture<double> posture_of(const Geometry<double>& geometry, const double* q);
/// Returns a random posture of the field; the same seed gives the same.
Posture<Field> random_posture(const Geometry<Field>& geometry, std::uint64_t seed);

}  // namespace qvgen::calibrate
