// SPDX-License-Identifier: MIT
#include "passes/search/field.h"

namespace qvgen::passes::search_detail {

Field Field::from(std::uint64_t value) {
  constexpr Wide square = ((((static_cast<Wide>(1) << 64U) % prime) << 64U) % prime);  // R^2
  return raw(reduce(static_cast<Wide>(value % prime) * static_cast<std::uint64_t>(square)));
}

Field Field::root_of_unity() {
  constexpr std::uint64_t generator = 82;  // of the whole multiplicative group
  return from(generator).power((prime - 1) / order);
}

Field Field::power(std::uint64_t exponent) const {
  Field result = from(1);
  for (Field base = *this; exponent != 0; exponent >>= 1U, base = base * base)
    if ((exponent & 1U) != 0) result = result * base;
  return result;
}

}  // namespace qvgen::passes::search_detail
