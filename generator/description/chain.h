// SPDX-License-Identifier: MIT
#pragma once

#include "description/links.h"

/// The forms in which a file may give its chain. Each fills in the joints (and what of the base and tool
/// frames its own form implies) and reports its own mistakes.
namespace qvgen::description {

/// [[joint]]: axis, origin, link.
void read_joints(const Table& root, const FreeParameters& free, model::Robot& robot);
/// [[dh]]: rows of a Denavit-Hartenberg table, `convention` standard or modified.
void read_dh_table(const Table& root, const FreeParameters& free, model::Robot& robot);
/// [[screw]] and [home]: axes through points at the zero configuration, and the tool's pose there.
void read_screws(const Table& root, const FreeParameters& free, model::Robot& robot);

}  // namespace qvgen::description
