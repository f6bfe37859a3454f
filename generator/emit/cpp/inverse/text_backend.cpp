// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/text_backend.h"

#include "derive/inverse/names.h"

namespace qvgen::emit {

namespace names = derive::inverse::names;

using derive::inverse::LoweredPlan;

namespace {

std::string preferred(const Dialect& d, const std::string& what) {
  return d.scalar(d.member("t", "preference->" + what));
}

std::string preferred_rotor(const Dialect& d, const std::string& name) {
  return d.rotor(preferred(d, name + ".cosine"), preferred(d, name + ".sine"));
}

/// An array's entry for a joint, by the joint's place in a row.
std::string entry(const LoweredPlan& plan, const std::string& array, int joint) {
  return array + "[" + std::to_string(plan.plan.places[static_cast<std::size_t>(joint)]) + "]";
}

}  // namespace

std::string length_place(const Dialect& d, const std::string& unknown) {
  return d.member("w", names::length(unknown));
}

std::string preferred_turn(const LoweredPlan& plan, int joint, const Dialect& d) {
  return preferred_rotor(d, entry(plan, "turn", joint));
}

std::string preferred_slide(const LoweredPlan& plan, int joint, const Dialect& d) {
  return preferred(d, entry(plan, "slide", joint));
}

std::string TextBackend::seed_brief(int joint) const {
  return preferred_rotor(d_, entry(plan_, "brief", joint));
}

std::string TextBackend::seed_angle(int joint) const { return preferred(d_, entry(plan_, "angle", joint)); }

std::string TextBackend::spread() const { return preferred_rotor(d_, "spread"); }

std::string TextBackend::sum_of_seeds(const std::vector<derive::inverse::kind::Reach::Seed>& seeds) const {
  std::string product;
  for (const auto& seed : seeds) {
    const std::string turn = seed_turn(seed.joint);
    const std::string factor = seed.sense > 0 ? turn : d_.inverse(turn);
    product = product.empty() ? factor : d_.product(product, factor);
  }
  return product;
}

std::string TextBackend::product_of_lengths(const std::vector<std::string>& unknowns) const {
  std::string product;
  for (const std::string& unknown : unknowns)
    product += (product.empty() ? "" : " * ") + length_place(d_, unknown);
  return product.empty() ? number(1) : product;
}

}  // namespace qvgen::emit
