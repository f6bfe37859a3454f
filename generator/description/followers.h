// SPDX-License-Identifier: MIT
#pragma once

#include "description/document.h"
#include "model/mechanism.h"

namespace qvgen::description {

/// `follows`, `ratio` and `offset` of a joint in a TOML description; nothing where it follows none.
void read_follower(const Table& table, model::JointType type);

/// True if the joint follows a sum, and not another joint alone.
bool follows_sum(const Table& table);

/// Ties the followers that the context has met to the joints that lead them; `names` are those of all joints,
/// as the file has them. Offsets go into the frames, and limits to the only leader: it stays where its
/// followers are within theirs. A joint with several leaders keeps its limits. Mistakes are reported.
void tie_followers(Context& context, const std::vector<std::string>& names, model::Robot& robot);

/// Returns the followers that the context has met as relations between joints that have values of their own,
/// as loops need them. Limits go to an only leader likewise; mistakes are reported.
std::vector<model::Gear> gears_of(Context& context, const std::vector<std::string>& names,
                                  model::Robot& robot);

/// True if a joint that the context has met follows by powers of another: then each has a value of its own.
bool follow_powers(const Context& context);

/// Names the joints that follow none as driven ones, if no closures hold joints.
void drive_leaders(model::Mechanism& mechanism);

/// Makes motors joints behind the others, which carry nothing: so a mechanism with loops has them.
void make_motors_joints(Context& context, model::Robot& robot);

}  // namespace qvgen::description
