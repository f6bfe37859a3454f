// SPDX-License-Identifier: MIT
// A small motion of a frame moves the tool as a joint there would: an axis times the way to the tool for a
// turn, the axis itself for a shift. All frames are computed together (frame_poses.h).
#include "derive/jacobian/geometry_jacobian.h"

#include <map>

#include "derive/jacobian/definition.h"
#include "derive/jacobian/frame_poses.h"
#include "derive/jacobian/quantities.h"
#include "derive/kinematics/forward_kinematics.h"
#include "symbolic/model.h"

namespace qvgen::derive {

using namespace symbolic;
using GiNaC::ex;

namespace {

struct Place {
  Matrix3 rotation;
  Vector position;
};

/// The frames that joints behind the first and the tool sit in, each fixed to the link before.
std::vector<model::Frame> moving_frames(const model::Robot& robot) {
  std::vector<model::Frame> frames;
  for (std::size_t i = 1; i < robot.joints.size(); ++i)
    frames.push_back({"joint" + std::to_string(i + 1), i - 1, robot.joints[i].before});
  frames.push_back({"tool", robot.joints.size() - 1, robot.tool});
  return frames;
}

/// The first joint's frame, which nothing moves.
Place standing(model::Robot robot, Program& program) {
  robot.tool = robot.joints.front().before;
  robot.joints.clear();
  const Pair pair = pair_product(robot, program);
  return {to_matrix(pair.q), pair.p};
}

Place place_of(const std::map<std::string, ex>& outputs, std::size_t frame) {
  Place place;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      place.rotation[i][j] =
          outputs.at(frame_entry(frame, "r" + std::to_string(i + 1) + std::to_string(j + 1)));
  place.position = {outputs.at(frame_entry(frame, "px")), outputs.at(frame_entry(frame, "py")),
                    outputs.at(frame_entry(frame, "pz"))};
  return place;
}

/// Appends the six columns of a frame.
void add_columns(const Place& frame, const Vector& tool, bool is_tool, Program& program,
                 std::vector<Twist>& columns) {
  const Vector way = is_tool ? Vector{} : program.let(tool - frame.position);
  std::array<Vector, 3> axes;
  for (int k = 0; k < 3; ++k)
    axes[static_cast<std::size_t>(k)] = {frame.rotation[0][k], frame.rotation[1][k], frame.rotation[2][k]};
  for (const Vector& axis : axes) columns.push_back({axis, {}});
  for (const Vector& axis : axes)
    columns.push_back({is_tool ? Vector{} : program.let(cross(axis, way)), axis});
}

/// Turns a program of poses into one of columns.
Program with_columns(const Program& poses, const model::Robot& frames) {
  Program program;
  for (const Program::Step& step : poses.steps()) program.append(step);
  std::map<std::string, ex> outputs;
  for (const Program::Output& output : poses.outputs()) outputs[output.name] = program.let(output.value);
  const std::size_t joints = frames.joints.size();
  const Vector tool = place_of(outputs, joints - 1).position;
  std::vector<Twist> columns;
  add_columns(standing(frames, program), tool, false, program, columns);
  for (std::size_t i = 0; i < joints; ++i)
    add_columns(place_of(outputs, i), tool, i + 1 == joints, program, columns);
  const auto entry = [](const Twist& twist, std::size_t row) {
    const Vector& half = row < 3 ? twist.linear : twist.angular;
    return row % 3 == 0 ? half.x : row % 3 == 1 ? half.y : half.z;
  };
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t k = 0; k < columns.size(); ++k)
      program.output(jacobian_entry(row, k), entry(columns[k], row));
  return program;
}

}  // namespace

Quantity geometry_jacobian(const model::Robot& robot, const model::Robot& frames) {
  const Quantity poses = frame_poses(robot, moving_frames(frames));
  Quantity quantity{"geometry_jacobian", {}, with_columns(poses.definition, frames)};
  for (const Form& form : poses.forms)
    quantity.forms.push_back({form.name, with_columns(form.program, frames)});
  return quantity;
}

}  // namespace qvgen::derive
