// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_frames.h"

#include "description/xml/mjcf_numbers.h"
#include "model/arithmetic.h"

namespace qvgen::description::xml {

model::Displacement MjcfFrames::around(const std::shared_ptr<const Around>& frame) {
  if (frame == nullptr) return {};
  const auto known = known_.find(frame);
  if (known != known_.end()) return known->second;
  return known_[frame] = tree::folded(around(frame->outer), own(*frame));
}

model::Displacement MjcfFrames::frame(const Placed& placed) {
  const MjcfNumbers numbers(*context_, placed.model->settings, snap_);
  return tree::folded(around(placed.around), numbers.frame(placed.completed(*context_)));
}

model::Displacement MjcfFrames::own(const Around& frame) {
  if (frame.element->name == "replicate") return copy(frame);
  return MjcfNumbers(*context_, frame.model->settings, snap_).frame(*frame.element);
}

/// As MuJoCo: copy i is turned by i times the Euler angles, and displaced from the one before by the offset,
/// in that one's frame.
model::Displacement MjcfFrames::copy(const Around& frame) {
  const MjcfNumbers numbers(*context_, frame.model->settings, snap_);
  const Element& replicate = *frame.element;
  std::vector<model::Vector3>& offsets = offsets_[&replicate];
  if (offsets.empty()) offsets.emplace_back();
  while (static_cast<long>(offsets.size()) <= frame.copy) {
    const auto turns = numbers.turns_of_copy(replicate, static_cast<long>(offsets.size()) - 1);
    const model::Vector3 offset = numbers.offset_of_copies(replicate);
    offsets.push_back(model::add(offsets.back(), tree::turned(turns, offset)));
  }
  return {numbers.turns_of_copy(replicate, frame.copy), offsets.at(static_cast<std::size_t>(frame.copy))};
}

}  // namespace qvgen::description::xml
