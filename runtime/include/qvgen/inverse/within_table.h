// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/constants.h>
#include <qvgen/inverse/tolerances.h>

/// Numbers of joint limits that rows are compared with. Serves code that may not include Eigen; see within.h.
namespace qvgen {

/// How far outside its limits a joint still counts as on them, rad or m: rounding moves a joint that stands
/// on its limit to either side. Such a joint is returned on the limit itself.
inline constexpr double limit_tolerance = inverse::tolerance::on_limit;

namespace inverse {

using constant::whole_turn;

/// A number for each joint, zeros behind the last.
template <int size>
struct WithinTable {
  double lower[size], upper[size], seed[size];
  double middle[size];    ///< the value next to which the representative is looked for
  double turn[size];      ///< 2 pi, of a slide 0
  double per_turn[size];  ///< its inverse, or 0
};

/// Puts the rows that are inside, their representatives next to the seed, one behind the other, with the
/// squares of their distances from the seed, and returns how many there are. Rows are eight numbers long, six
/// or seven of which are joints. There has to be room for all rows.
using RowsWithin = int (*)(const WithinTable<8>& table, int dof, const double* rows, int count, double* kept,
                           double* squares);

/// The form for the widest registers that this machine has; null if there is none.
RowsWithin widest_rows_within();

}  // namespace inverse
}  // namespace qvgen
