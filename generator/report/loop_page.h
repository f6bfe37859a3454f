// SPDX-License-Identifier: MIT
// The page of a mechanism with closed loops: drawn where its loops close, its derivation, and the linkage to
// be moved by its motors and dragged at its tips, with all assemblies.
#pragma once

#include "model/mechanism.h"
#include "pipeline/robot_output.h"

namespace qvgen::report {

/// Returns the page NAME.html, a single file, and the mechanism's entry of the common pages.
pipeline::RobotOutput loop_page(const model::Mechanism& mechanism);

}  // namespace qvgen::report
