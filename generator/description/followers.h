// SPDX-License-Identifier: MIT
#pragma once

#include "description/document.h"

namespace qvgen::description {

/// `follows`, `ratio` and `offset` of a joint in a TOML description; nothing where it follows none.
void read_follower(const Table& table, model::JointType type);

/// True if the joint follows a sum, and not another joint alone.
bool follows_sum(const Table& table);

/// Ties the followers that the context has met to the joints that lead them; `names` are those of all joints,
/// as the file has them. Offsets go into the frames, and limits to the only leader: it stays where its
/// followers are within theirs. A joint with several leaders keeps its limits. Mistakes are reported.
void tie_followers(Context& context, const std::vector<std::string>& names, model::Robot& robot);

}  // namespace qvgen::description
