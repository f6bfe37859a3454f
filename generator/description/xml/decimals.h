// SPDX-License-Identifier: MIT
#pragma once

#include <cln/rational.h>

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// A number as it is written: its exact value and the digits behind its point.
struct Decimal {
  cln::cl_RA value = 0;
  int places = 0;  ///< 1.571 has 3, 1571e-3 too, 2 has none
  int units = 1;   ///< of the last place by which rounding or cutting may have changed it
  Place place;
  std::string text = "0";
};

/// The numbers of an attribute, apart by blanks; reported and empty if one of them is none.
std::optional<std::vector<Decimal>> read_decimals(Context& context, const Attribute& attribute);

/// Likewise, and there are exactly so many of them. An absent attribute gives nothing, without a message.
std::optional<std::vector<Decimal>> read_decimals(Context& context, const Element& element,
                                                  const std::string& key, std::size_t count);
/// One number; absent or wrong: `otherwise`.
Decimal read_decimal(Context& context, const Element& element, const std::string& key,
                     const cln::cl_RA& otherwise);

/// Warns of attributes that nobody reads, most likely a slip of the keyboard.
void warn_of_others(Context& context, const Element& element, const std::vector<std::string>& known);

}  // namespace qvgen::description::xml
