// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "derive/inverse/kinds/circle.h"
#include "derive/inverse/kinds/direction.h"
#include "derive/inverse/kinds/length.h"
#include "derive/inverse/kinds/newton.h"
#include "derive/inverse/kinds/quartic.h"
#include "derive/inverse/kinds/wrist.h"

/// The canonical equations, one type for each. A kind says everything about its equation:
///
/// - its inputs, which a step computes before, in its comment; what else the equation depends on as members;
/// - `title` and `solution(joints)`, for people; `joints` are the names of those that the step leaves;
/// - `apply(unknown, backend)`: the call of the runtime's building block that solves it. The backend decides
///   what that means: it is carried out in sixty digits (verify), counted (verify) or written down as source
///   text (emit). A backend has `Number` and gives inputs (`input`, `pair`, `number`, `flag`), what belongs
///   to a branch (`sign`, `branch`), to the target (`tiny`, `tolerance`, `size_square`, `boundary`, `pi`) and
///   to the seed (`seed_turn`, `seed_slide`, ...), carries out calls (`call`, `condition`, `make`) and takes
///   the result by what it is (`turn`, `length`, `two_lengths`, `roots`, `wrist_turns`, ...).
namespace qvgen::derive::inverse {

using Kind =
    std::variant<kind::Linear, kind::Circle, kind::FreeCircle, kind::FoldingCircle, kind::FactoredCircle,
                 kind::Opposite, kind::Pair, kind::ChosenPair, kind::Reach, kind::Half, kind::Root,
                 kind::Line, kind::Beside, kind::Slides, kind::Require, kind::Conic, kind::SlideTurn,
                 kind::TwoTurns, kind::Newton, kind::RightWrist, kind::ObliqueWrist>;

}  // namespace qvgen::derive::inverse
