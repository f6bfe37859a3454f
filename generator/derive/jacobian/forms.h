// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "derive/jacobian/definition.h"
#include "derive/jacobian/frames.h"

namespace qvgen::derive {

using Columns = std::vector<Twist>;

struct ColumnsForm {
  std::string name;
  std::function<Columns(symbolic::Program&)> build;
};

/// The three methods of the textbooks (Jacobian lecture, section 5.4), base frame, as they stand there:
/// link velocities propagated from joint to joint in the links' frames and turned into the base frame at the
/// end (v' = R^T (v + omega x P), omega' = R^T omega + qd z); cross products z_i x (p - p_i) of axes and
/// vectors in the base frame; differentiation of position and quaternion.
std::vector<ColumnsForm> textbook_methods(const model::Robot& robot);

enum class Target { base, tool };

/// Further ways, with parallel neighbours merged and all in full angles: each column is made in the frame
/// where its axis is a constant, all columns are turned into one frame in the middle and from there to the
/// target.
std::vector<ColumnsForm> columns_by_frames(const model::Robot& robot, Target target);

/// The tool's twist for all joint rates, summed up on the way from both ends to a frame in the middle.
MovingTwist twist_by_frames(symbolic::Program& program, const model::Robot& robot, std::size_t middle,
                            bool with_rates);
/// The tool's axes turned from frame to frame into the base frame, as the columns of a matrix.
symbolic::Matrix3 orientation_by_frames(symbolic::Program& program, const model::Robot& robot);
/// The tool's position with its time derivatives, differentiated turn by turn from the tip to the base.
Moving position_in_motion(symbolic::Program& program, const model::Robot& robot);
std::size_t frame_count(const model::Robot& robot);

/// The columns' time derivatives.
Columns column_rates_by_frames(symbolic::Program& program, const model::Robot& robot, std::size_t middle);

/// Returns the rates of the columns, and the tool's acceleration at constant joint rates, by axes and vectors
/// written out in one frame.
Columns column_rates_by_axes(symbolic::Program& program, const model::Robot& robot, std::size_t frame);
Twist acceleration_by_axes(symbolic::Program& program, const model::Robot& robot, std::size_t frame);

}  // namespace qvgen::derive
