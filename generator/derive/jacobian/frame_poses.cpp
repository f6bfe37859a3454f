// SPDX-License-Identifier: MIT
// Poses of several frames share what lies before them: the forms go from the base outward, so that each
// link's rotation is the one before times one turn. Behind parallel axes they turn by the sum of the angles
// at once.
#include "derive/jacobian/frame_poses.h"

#include "derive/jacobian/linkage.h"
#include "derive/kinematics/forward_kinematics.h"
#include "derive/kinematics/orientation.h"
#include "derive/kinematics/position.h"
#include "derive/kinematics/turns.h"
#include "model/frames.h"
#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

std::string frame_entry(std::size_t frame, const std::string& entry) {
  return "f" + std::to_string(frame + 1) + "_" + entry;
}

namespace {

void output(Program& program, std::size_t frame, const Matrix3& r, const Vector& p) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      program.output(frame_entry(frame, "r" + std::to_string(i + 1) + std::to_string(j + 1)), r[i][j]);
  program.output(frame_entry(frame, "px"), p.x);
  program.output(frame_entry(frame, "py"), p.y);
  program.output(frame_entry(frame, "pz"), p.z);
}

Program plain_poses(const model::Robot& robot, const std::vector<model::Frame>& frames) {
  Program program;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Pair pose = pair_product(model::up_to(robot, frames[i]), program);
    output(program, i, to_matrix(pose.q), pose.p);
  }
  return program;
}

Matrix3 rotation_of(const Turn& turn) {
  const Vector x = turned(turn, {1, 0, 0}), y = turned(turn, {0, 1, 0}), z = turned(turn, {0, 0, 1});
  return {{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}};
}

enum class Parallels { one_by_one, at_once };

/// Goes outward along a linkage.
class Outward {
 public:
  Outward(Program& program, const Linkage& linkage, Parallels parallels)
      : program_(program), linkage_(linkage), parallels_(parallels) {}

  void run(std::size_t frame) {
    for (const Linkage::Pivot& pivot : linkage_.pivots) {
      go(pivot.before);
      turn({pivot.axis, pivot.angle});
    }
    go(linkage_.beyond);
    output(program_, frame, program_.let(rotation_ * to_matrix(linkage_.home)), position_);
  }

 private:
  void go(const Linkage::Way& way) {
    Vector offset = way.offset;
    for (const Linkage::Slide& slide : way.slides)
      offset = offset + linkage_.variables[slide.joint] * slide.axis;
    position_ = program_.let(position_ + rotation_ * offset);
  }

  void turn(const Turn& next) {
    const int sign = parallels_ == Parallels::at_once && has_turned_ ? parallel(group_.axis, next.axis) : 0;
    if (sign == 0) {
      before_group_ = rotation_;
      group_ = next;
    } else {
      group_.angle += sign * next.angle;
    }
    has_turned_ = true;
    rotation_ = program_.let(before_group_ * rotation_of(group_));
  }

  Program& program_;
  const Linkage& linkage_;
  Parallels parallels_;
  Matrix3 rotation_ = to_matrix(Quaternion{});
  Matrix3 before_group_ = rotation_;
  Vector position_;
  Turn group_;
  bool has_turned_ = false;
};

Program outward(const model::Robot& robot, const std::vector<model::Frame>& frames, Parallels parallels) {
  Program program;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Linkage way = linkage(model::up_to(robot, frames[i]));
    Outward(program, way, parallels).run(i);
  }
  return program;
}

/// Each frame for itself: positions from the frame to the base take fewer operations where nothing is shared.
Program one_by_one(const model::Robot& robot, const std::vector<model::Frame>& frames) {
  Program program;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto chain = zero_reference_chain(model::up_to(robot, frames[i]));
    if (!chain) return {};
    const Matrix3 matrix = matrix_forms(*chain).front().build(program);
    output(program, i, matrix, position_forms(*chain).front().build(program, {}));
  }
  return program;
}

}  // namespace

Quantity frame_poses(const model::Robot& robot, const std::vector<model::Frame>& frames) {
  Quantity quantity{"frame_poses", {}, plain_poses(robot, frames)};
  quantity.forms.push_back({"outward", outward(robot, frames, Parallels::one_by_one)});
  quantity.forms.push_back({"outward, parallel axes at once", outward(robot, frames, Parallels::at_once)});
  const Program apart = one_by_one(robot, frames);
  if (!apart.outputs().empty()) quantity.forms.push_back({"each for itself", apart});
  return quantity;
}

}  // namespace qvgen::derive
