// SPDX-License-Identifier: MIT
#include "model/frames.h"

#include "model/followers.h"

namespace qvgen::model {

std::vector<Frame> link_frames(const Robot& robot) {
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    frames.push_back({"link" + std::to_string(i + 1), i, {}});
  return frames;
}

std::vector<Frame> all_frames(const Robot& robot) {
  std::vector<Frame> frames = link_frames(robot);
  frames.insert(frames.end(), robot.frames.begin(), robot.frames.end());
  return frames;
}

Robot up_to(const Robot& robot, const Frame& frame) {
  Robot chain = in_joints(robot);
  chain.joints.resize(frame.joint + 1);
  chain.tool = frame.placement;
  chain.frames.clear();
  chain.inverse = {};
  chain.ideal.clear();
  return chain;
}

}  // namespace qvgen::model
