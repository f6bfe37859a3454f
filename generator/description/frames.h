// SPDX-License-Identifier: MIT
#pragma once

#include "description/entries.h"

namespace qvgen::description {

/// An axis: "+x" ... "-z", or three constant entries of exact length 1.
std::optional<model::Vector3> read_axis(Context& context, const toml::node& node);

/// The keys that a constant rotation may have: `rpy` or `turns`.
std::vector<model::Turn> read_turns(const Table& table);
/// A turn about a coordinate axis (0, 1, 2); nothing for the angle 0.
std::vector<model::Turn> coordinate_turn(std::size_t axis, const model::Expression& angle);

/// [base], [tool], [home]: translation, and rpy or turns.
model::Displacement read_frame(const Table& root, const std::string& key);

}  // namespace qvgen::description
