// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/columns/signature.h"

namespace qvgen::emit::octave {

using columns::Input;
using columns::Output;
using columns::Signature;

/// C of the MEX file that calls the functions of those signatures by their names; `headers` declare them.
std::string gateway(const blocks::Unit& unit, const std::vector<Signature>& signatures,
                    const std::vector<std::string>& headers);

}  // namespace qvgen::emit::octave
