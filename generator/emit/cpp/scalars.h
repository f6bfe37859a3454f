// SPDX-License-Identifier: MIT
// The scalar types that generated C++ is compiled for. -DQVGEN_NO_FLOAT leaves float out: a quarter to a
// third of the time.
#pragma once

#include <nlohmann/json.hpp>

namespace qvgen::emit {

/// Returns template values of each type: its name, and whether QVGEN_NO_FLOAT leaves it out. Float is the
/// last one, so that an #endif behind all of them ends what is left out.
inline nlohmann::json scalars() {
  return {{{"scalar", "double"}, {"is_float", false}}, {{"scalar", "float"}, {"is_float", true}}};
}

}  // namespace qvgen::emit
