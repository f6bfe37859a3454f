// SPDX-License-Identifier: MIT
#include "derive/loops/rods.h"

#include "derive/loops/along_side.h"
#include "symbolic/model.h"

namespace qvgen::derive::loops {
namespace {

using GiNaC::ex;
using symbolic::cross;
using symbolic::dot;
using symbolic::Program;
using symbolic::Vector;
using symbolic::operator*;
using symbolic::operator+;
using symbolic::operator-;

/// A rod between the ends of two sides. Its gap is (w^2 - l^2) / 2 l, where w is the way from the second end
/// to the first one and l the length.
class Rod {
 public:
  Rod(const model::Robot& robot, const Cycle& cycle, bool moves, Program& program)
      : robot_(robot),
        cycle_(cycle),
        program_(program),
        sides_{AlongSide(robot, cycle.sides[0], moves, program),
               AlongSide(robot, cycle.sides[1], moves, program)},
        way_(program.let(sides_[0].end().point - sides_[1].end().point)),
        shrink_(program.let(1 / cycle.length)),
        along_(program.let(shrink_ * way_)) {}

  std::vector<ex> jacobian() {
    std::vector<ex> row(robot_.joints.size(), 0);
    add_side(sides_[0], along_, row);
    add_side(sides_[1], -along_, row);
    if (cycle_.length_joint) row[*cycle_.length_joint] = -(1 + program_.let(dot(along_, along_))) / 2;
    return row;
  }

  /// With the rate r of the length, (|w' - r w / l|^2 + w w'') / l.
  ex bias() {
    const MovingFrame &a = sides_[0].end(), &b = sides_[1].end();
    Vector rate = a.velocity - b.velocity;
    if (cycle_.length_joint)
      rate = rate - symbolic::symbol("rate_" + robot_.joints[*cycle_.length_joint].variable) * along_;
    rate = program_.let(rate);
    return shrink_ * dot(rate, rate) + dot(along_, program_.let(a.acceleration - b.acceleration));
  }

 private:
  /// Adds what the joints of a side do to its end, from the end back to the common link.
  void add_side(const AlongSide& side, const Vector& along, std::vector<ex>& row) {
    Vector arm;
    for (auto joint = side.joints().rbegin(); joint != side.joints().rend(); ++joint) {
      arm = program_.let(joint->to_next + arm);
      const Vector pull = joint->turns ? program_.let(cross(arm, along)) : along;
      row[joint->joint] = dot(joint->axis, pull);
    }
  }

  const model::Robot& robot_;
  const Cycle& cycle_;
  Program& program_;
  std::array<AlongSide, 2> sides_;
  Vector way_;
  ex shrink_;
  Vector along_;
};

}  // namespace

std::vector<ex> jacobian_of_rod(const model::Robot& robot, const Cycle& cycle, Program& program) {
  return Rod(robot, cycle, false, program).jacobian();
}

ex bias_of_rod(const model::Robot& robot, const Cycle& cycle, Program& program) {
  return Rod(robot, cycle, true, program).bias();
}

}  // namespace qvgen::derive::loops
