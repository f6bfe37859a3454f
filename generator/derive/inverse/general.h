// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <qvgen/inverse/general/setup.h>

#include "model/robot.h"

namespace qvgen::derive::inverse {

/// Six joints whose axes have no structure to make use of: the elimination of the runtime, set up for the
/// arm, or the reason why it does not serve. For arms of which `derive` finds nothing.
struct GeneralDerivation {
  bool found = false;
  qvgen::inverse::general::Setup setup;
  std::string reason;
};

GeneralDerivation derive_general(const model::Robot& described);

/// Whether a look at the numbers shows that no three axes in a row meet or are parallel: `derive` need not be
/// asked, whose expressions become long where every angle is a constant of its own.
bool lacks_structure(const model::Robot& described);

/// What is eliminated and how, for people: a line for each elimination, by the joints' variables.
std::vector<std::string> describe_general(const model::Robot& described, const GeneralDerivation& derivation);

}  // namespace qvgen::derive::inverse
