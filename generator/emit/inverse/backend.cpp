// SPDX-License-Identifier: MIT
#include "emit/inverse/backend.h"

namespace qvgen::emit {

using ast::Expression;
using derive::inverse::LoweredPlan;

namespace {

Expression converted_rotor(const Expression& rotor) {
  return ast::rotor(ast::convert(ast::member(rotor, "cosine")), ast::convert(ast::member(rotor, "sine")));
}

}  // namespace

Expression seed_turn(const LoweredPlan& plan, int joint) {
  return converted_rotor(preferred(plan, target(), "turn", joint));
}

Expression seed_slide(const LoweredPlan& plan, int joint) {
  return ast::convert(preferred(plan, target(), "slide", joint));
}

Expression TreeBackend::seed_brief(int joint) const {
  return converted_rotor(preferred(plan_, target(), "brief", joint));
}

Expression TreeBackend::seed_angle(int joint) const {
  return ast::convert(preferred(plan_, target(), "angle", joint));
}

Expression TreeBackend::spread() const {
  const Expression all = ast::member(target(), "preference", {"Preference"}, ast::Reach::pointer);
  return converted_rotor(ast::member(all, "spread"));
}

Expression TreeBackend::sum_of_seeds(const std::vector<derive::inverse::kind::Reach::Seed>& seeds) const {
  Expression product;
  for (const auto& seed : seeds) {
    const Expression turn = seed_turn(seed.joint);
    const Expression factor = seed.sense > 0 ? turn : ast::inverse(turn);
    product = product.kind == Kind::nothing ? factor : ast::turned(product, factor);
  }
  return product;
}

Expression TreeBackend::product_of_lengths(const std::vector<std::string>& unknowns) const {
  ast::Expressions lengths;
  for (const std::string& unknown : unknowns) lengths.push_back(length_place(work(), unknown));
  return lengths.empty() ? number(1) : ast::product(lengths);
}

}  // namespace qvgen::emit
