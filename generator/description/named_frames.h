// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "description/document.h"

namespace qvgen::description {

/// Most frames that a description may name.
inline constexpr std::size_t most_frames = 64;

/// Reads [[frame]]: frames that are fixed to a link, by the variable of the joint that moves it.
void read_named_frames(const Table& root, model::Robot& robot);

/// Reads the tables of that key, each of which is a frame as in [[frame]].
std::vector<model::Frame> read_frame_tables(const Table& root, const std::string& key,
                                            const model::Robot& robot);

/// Makes the name of a frame from any text: in lower case, different from those of `frames` and from the
/// links'.
std::string frame_identifier(const std::string& text, const std::vector<model::Frame>& frames);

}  // namespace qvgen::description
