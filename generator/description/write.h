// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "model/dh_table.h"
#include "model/mechanism.h"

namespace qvgen::description {

/// The robot as a TOML description with [[joint]] tables; reading it gives the same model again. Joints whose
/// link frame is turned behind the motion cannot be written so: std::invalid_argument.
std::string write_text(const model::Robot& robot);

/// Likewise a robot whose joints branch, with its tips.
std::string write_text(const model::Mechanism& mechanism);

/// The robot as a TOML description with a table of Denavit and Hartenberg, without its inertias, which stand
/// in other link frames. Reading it gives the same forward kinematics.
std::string write_dh_text(const model::Robot& robot, const model::DhTable& table);

/// A description to be edited, of joints by their letters (R, P; "RRP"), with an Euler wrist behind them or
/// none, each a link longer than the one before. Nothing if a letter is neither.
std::optional<std::string> write_template(const std::string& name, const std::string& letters,
                                          bool euler_wrist);

}  // namespace qvgen::description
