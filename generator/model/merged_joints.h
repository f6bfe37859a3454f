// SPDX-License-Identifier: MIT
// Joints that move about or along one line, one directly behind the other, as one joint.
//
// A palletiser may say that a bar turns its forearm back: behind the upper arm a joint about the same line
// takes its turn away, and then the forearm's own follows. Together they are one joint, whose value is the
// sum of theirs.
#pragma once

#include "model/robot.h"

namespace qvgen::model {

/// Returns a robot with followers whose joints on one line are merged: it has the same motors in the same
/// order, and the same poses by them. A joint that leads others and is merged becomes a motor; one whose
/// turns cancel disappears. Inertias, drives of joints, and named frames are left out. A robot that has more
/// motors than its merged joints, joints with limits of their own among the merged ones, or given joints
/// comes as it is.
Robot with_merged_joints(const Robot& robot);

}  // namespace qvgen::model
