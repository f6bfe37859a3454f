// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "cli/commands.h"
#include "pipeline/robot_output.h"

/// How a command exits by what robots lack. A check of the generator that has failed is the tool's fault and
/// has a code of its own, above all others; it costs the part that it is of, and the rest is written.
namespace qvgen::cli {

/// The code with the larger number: a defect of the tool counts most.
inline ExitCode worse(ExitCode a, ExitCode b) { return std::max(a, b); }

/// `internal_error` if a certificate has failed, else `success`: what cannot be derived is no failure.
inline ExitCode verdict_of(const std::vector<pipeline::Missing>& missing) {
  const bool is_refuted = std::any_of(missing.begin(), missing.end(), [](const pipeline::Missing& each) {
    return each.kind == pipeline::Missing::Kind::refuted;
  });
  return is_refuted ? internal_error : success;
}

}  // namespace qvgen::cli
