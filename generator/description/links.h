// SPDX-License-Identifier: MIT
#pragma once

#include "description/entries.h"

namespace qvgen::description {

/// Statement of the whole file about inertial parameters that a joint leaves out.
struct FreeParameters {
  bool inertia = false;
  bool drives = false;
};
FreeParameters read_free_parameters(const Table& root);

/// Reads [floating_base]: the inertia of a base that moves freely, in its own frame. Nothing without it.
std::optional<model::Inertia> read_floating_base(const Table& root, const FreeParameters& free);

/// The keys that a joint has in every form of the description, and `more`.
std::vector<std::string> joint_keys(const std::vector<std::string>& more);
/// type (may be absent: nullopt) and variable, limits, inertia, drive. `other_types` are those that hints may
/// name besides.
std::optional<model::JointType> read_joint_type(const Table& table,
                                                const std::vector<std::string>& other_types = {});
std::string read_variable(const Table& table);
/// Adds the name of a joint variable; reported if it cannot be one.
void add_variable(Context& context, const std::string& name, Place place);
/// The motors that are no joints, [[motor]].
void read_motors(const Table& root, const FreeParameters& free, model::Robot& robot);
void read_link(const Table& table, const FreeParameters& free, model::Joint& joint);

}  // namespace qvgen::description
