// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dag/graph.h"
#include "symbolic/program.h"

namespace qvgen::dag {

/// A derivation as a graph: every named step becomes a shared node. GiNaC's own order of terms, which changes
/// from run to run, is forgotten here: the result depends on the mathematics of the program alone.
/// Throws std::domain_error for what the graph cannot express (an angle that is not linear, say).
Function import(const symbolic::Program& program);

/// The way back: the outputs as GiNaC writes them. Symbols of `known` stand for what it gives.
std::vector<GiNaC::ex> to_symbolic(const Function& function, const std::map<std::string, GiNaC::ex>& known);

}  // namespace qvgen::dag
