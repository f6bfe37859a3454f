// SPDX-License-Identifier: MIT
#include "description/xml/urdf_origin.h"

#include "description/xml/decimals.h"

namespace qvgen::description::xml {

std::array<double, 3> read_triple(Context& context, const Element* element, const std::string& key,
                                  const std::array<double, 3>& otherwise) {
  if (element == nullptr) return otherwise;
  const auto numbers = read_decimals(context, *element, key, 3);
  if (!numbers) return otherwise;
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result.at(i) = cln::double_approx((*numbers)[i].value);
  return result;
}

UrdfOrigin read_origin(Context& context, const Element& element) {
  const Element* origin = element.child("origin");
  return {read_triple(context, origin, "xyz", {}), read_triple(context, origin, "rpy", {})};
}

}  // namespace qvgen::description::xml
