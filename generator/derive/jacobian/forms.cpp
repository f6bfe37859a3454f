// SPDX-License-Identifier: MIT
#include "derive/jacobian/forms.h"

#include "derive/jacobian/axes_in_motion.h"
#include "derive/jacobian/rates.h"
#include "derive/kinematics/turns.h"
#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

ex rate_symbol(const Linkage& linkage, std::size_t joint) {
  return symbol(rate_name(GiNaC::ex_to<GiNaC::symbol>(linkage.variables[joint]).get_name()));
}

Frames::RateOf rates_of(const Linkage& linkage) {
  return [&linkage](std::size_t joint) { return rate_symbol(linkage, joint); };
}

MovingTwist times(const ex& s, const MovingTwist& t) { return {s * t.linear, s * t.angular}; }
MovingTwist plus(const MovingTwist& a, const MovingTwist& b) {
  return {a.linear + b.linear, a.angular + b.angular};
}

MovingTwist let(Program& program, const MovingTwist& t) {
  const auto name = [&](const Moving& v) {
    return Moving{program.let(v.value), program.let(v.rate), program.let(v.second)};
  };
  return {name(t.linear), name(t.angular)};
}

/// All columns in the target's frame by way of the middle frame.
std::vector<MovingTwist> gathered(Frames& frames, const std::vector<Frames::Column>& columns,
                                  std::size_t middle, Target target) {
  std::vector<MovingTwist> result;
  for (const Frames::Column& column : columns) {
    const MovingTwist met = frames.move(column.twist, column.frame, middle);
    result.push_back(target == Target::base ? frames.move(met, middle, 0)
                                            : frames.to_tool(frames.move(met, middle, frames.last())));
  }
  return result;
}

}  // namespace

std::size_t frame_count(const model::Robot& robot) {
  Program unused;
  const Linkage arm = linkage(robot);
  return Frames(unused, arm).last() + 1;
}

namespace {

Columns values(const std::vector<MovingTwist>& twists) {
  Columns columns;
  for (const MovingTwist& each : twists) columns.push_back({each.linear.value, each.angular.value});
  return columns;
}

/// Axes and vectors to the tool point are turned into the base frame, the cross products are made there.
Columns crossed_in_base(Program& program, Frames& frames) {
  Columns result;
  for (const Frames::Column& column : frames.columns()) {
    const MovingTwist twist = frames.move(column.twist, column.frame, 0);
    const Vector reach = frames.move(Moving{column.reach, {}, {}}, column.frame, 0).value;
    const Vector& axis = twist.angular.value;
    const bool slides = axis.x.is_zero() && axis.y.is_zero() && axis.z.is_zero();
    result.push_back({slides ? twist.linear.value : program.let(cross(axis, reach)), axis});
  }
  return result;
}

}  // namespace

std::vector<ColumnsForm> columns_by_frames(const model::Robot& robot, Target target) {
  std::vector<ColumnsForm> forms;
  for (std::size_t middle = 0; middle < frame_count(robot); ++middle) {
    const auto build = [=](Program& program) {
      const Linkage arm = linkage(robot);
      Frames frames(program, arm);
      return values(gathered(frames, target == Target::base ? frames.columns() : frames.columns_behind(),
                             middle, target));
    };
    forms.push_back({"by way of frame " + std::to_string(middle), build});
  }
  if (target == Target::base)
    forms.push_back({"cross products in the base frame", [=](Program& program) {
                       const Linkage arm = linkage(robot);
                       Frames frames(program, arm);
                       return crossed_in_base(program, frames);
                     }});
  return forms;
}

MovingTwist twist_by_frames(Program& program, const model::Robot& robot, std::size_t middle,
                            bool with_rates) {
  const Linkage arm = linkage(robot);
  Frames frames(program, arm, with_rates ? rates_of(arm) : Frames::RateOf{});
  std::vector<MovingTwist> local(frames.last() + 1);
  for (std::size_t i = 0; i < frames.columns().size(); ++i) {
    const Frames::Column& column = frames.columns()[i];
    local[column.frame] = plus(local[column.frame], times(rate_symbol(arm, i), column.twist));
  }
  MovingTwist from_base;
  for (std::size_t k = 0; k < middle; ++k)
    from_base = frames.move(let(program, plus(from_base, local[k])), k, k + 1);
  MovingTwist sum;
  for (std::size_t k = frames.last(); k > middle; --k)
    sum = frames.move(let(program, plus(sum, local[k])), k, k - 1);
  sum = let(program, plus(plus(from_base, local[middle]), sum));
  return frames.move(sum, middle, 0);
}

Matrix3 orientation_by_frames(Program& program, const model::Robot& robot) {
  const Linkage arm = linkage(robot);
  Frames frames(program, arm);
  const Matrix3 home = to_matrix(arm.home);
  Matrix3 result;
  for (std::size_t j = 0; j < 3; ++j) {
    const Moving axis{{home[0][j].expand(), home[1][j].expand(), home[2][j].expand()}, {}, {}};
    const Vector v = frames.move(axis, frames.last(), 0).value;
    result[0][j] = v.x;
    result[1][j] = v.y;
    result[2][j] = v.z;
  }
  return result;
}

Moving position_in_motion(Program& program, const model::Robot& robot) {
  const Linkage arm = linkage(robot);
  return Frames(program, arm, rates_of(arm)).position();
}

Columns column_rates_by_frames(Program& program, const model::Robot& robot, std::size_t middle) {
  const Linkage arm = linkage(robot);
  Frames frames(program, arm, rates_of(arm));
  Columns columns;
  for (const MovingTwist& each : gathered(frames, frames.columns(), middle, Target::base))
    columns.push_back({each.linear.rate, each.angular.rate});
  return columns;
}

Columns column_rates_by_axes(Program& program, const model::Robot& robot, std::size_t frame) {
  const Linkage arm = linkage(robot);
  return AxesInMotion(program, arm, frame, rates_of(arm), AxesInMotion::Order::first).column_rates();
}

Twist acceleration_by_axes(Program& program, const model::Robot& robot, std::size_t frame) {
  const Linkage arm = linkage(robot);
  return AxesInMotion(program, arm, frame, rates_of(arm), AxesInMotion::Order::second).acceleration();
}

}  // namespace qvgen::derive
