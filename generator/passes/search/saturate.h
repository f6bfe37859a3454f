// SPDX-License-Identifier: MIT
#pragma once

#include "passes/search/classes.h"
#include "passes/search/fingerprint.h"
#include "passes/search/load.h"

namespace qvgen::passes::search_detail {

/// sin and cos of a + b, a - b and 2a from those of a and b, wherever all of them are leaves of the forms.
void relate_angles(Classes& classes, const AngleTable& angles, const Fingerprint& fingerprint);

/// a b + a c = a (b + c): the right-hand side as new classes, one multiplication less if the products have no
/// other use.
void factor(Classes& classes, std::uint32_t limit);

/// f (g x) = (f g) x and f (g x + y) = (f g) x + f y for free f and g: the product f g costs nothing.
void gather_free_factors(Classes& classes, std::uint32_t limit);

/// 1/b as a class where several quotients have the denominator b.
void share_reciprocals(Classes& classes);

/// Every class that happens to be the sum, difference or product of two others gets that node.
void close(Classes& classes);

}  // namespace qvgen::passes::search_detail
