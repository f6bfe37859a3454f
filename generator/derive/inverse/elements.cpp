// SPDX-License-Identifier: MIT
#include "derive/inverse/elements.h"

namespace qvgen::derive::inverse {
namespace {

constexpr int first_of_vector = 5;

}  // namespace

Elements element_along(const Screw& axis, const symbolic::Vector& direction, const Scope& scope) {
  const symbolic::Vector own = scope.clean(symbolic::rotate(symbolic::inverse(axis.frame), direction));
  Elements elements{axis.joint, {}};
  int index = first_of_vector;
  for (const GiNaC::ex& component : {own.x, own.y, own.z}) {
    if (!scope.is_zero(component)) elements.indices.push_back(index);
    ++index;
  }
  return elements.indices.size() == 1 ? elements : Elements{};
}

Elements elements_across(const Screw& axis, const Scope& scope) {
  const Elements along = element_along(axis, axis.axis, scope);
  if (along.indices.empty()) return {};
  Elements across = vector_elements(axis);
  std::erase(across.indices, along.indices.front());
  return across;
}

Elements vector_elements(const Screw& axis) { return {axis.joint, {5, 6, 7}}; }
Elements quaternion_elements(const Screw& axis) { return {axis.joint, {1, 2, 3, 4}}; }

}  // namespace qvgen::derive::inverse
