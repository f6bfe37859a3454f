// SPDX-License-Identifier: MIT
#include "derive/inverse/tool_side.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::dot;
using symbolic::Vector;

Screw without_place(const Screw& screw) {
  Screw result = screw;
  result.point = {0, 0, 0};
  return result;
}

ToolSide::ToolSide(Builder& builder, Target& target, const Screw& axis, const Screw& c, Options options)
    : builder_(builder),
      target_(target),
      c_(c),
      options_(options),
      components_{axis.axis, axis.first, axis.second} {
  if (options.c_first) return;
  const std::array<const char*, 3> names = {"seen_axis", "seen_first", "seen_second"};
  for (std::size_t i = 0; i < 3; ++i) seen_[i] = named(names[i], turned_back(components_[i]));
}

Block::Form ToolSide::Image::form(Component n, const Scope& scope) const {
  Block::Form form = block_.form(components_[n], scope);
  form.constant = scope.clean(form.constant + offsets_[n]);
  return form;
}

ex ToolSide::Image::at(Component n, Builder& builder) const {
  const Block::Form f = form(n, builder.scope());
  const Scope::Turn value = builder.value(block_.screw);
  return f.constant + f.coefficients.x * value.cosine + f.coefficients.y * value.sine;
}

Vector ToolSide::turned(const Vector& v) const {
  return options_.back ? target_.direction_source(v) : target_.direction_image(v);
}
Vector ToolSide::turned_back(const Vector& v) const {
  return options_.back ? target_.direction_image(v) : target_.direction_source(v);
}

Vector ToolSide::named(const std::string& name, const Vector& v) {
  return builder_.scope().define(builder_.plan().target, name, builder_.scope().clean(v));
}

/// T e_c^-1 v: the components' own directions are brought to the tool's side, where e_c^-1 v turns.
ToolSide::Image ToolSide::seen_by_tool(const Vector& v) const {
  Image result;
  result.block_ = block_of(without_place(c_), -1, v, builder_.scope());
  result.components_ = seen_;
  return result;
}

ToolSide::Image ToolSide::point(const std::string& name, const Vector& x) {
  const Scope& scope = builder_.scope();
  if (options_.c_first) {
    Image result;
    result.block_ = block_of(c_, -1, named(name, image(x)), scope);
    result.components_ = components_;
    return result;
  }
  Image result = seen_by_tool(scope.clean(x - c_.point));
  const Vector fixed = named(name, image(c_.point));
  for (std::size_t i = 0; i < 3; ++i) result.offsets_[i] = scope.clean(dot(components_[i], fixed));
  return result;
}

ToolSide::Image ToolSide::direction(const std::string& name, const Vector& v) {
  if (!options_.c_first) return seen_by_tool(v);
  Image result;
  result.block_ = block_of(without_place(c_), -1, named(name, turned(v)), builder_.scope());
  result.components_ = components_;
  return result;
}

}  // namespace qvgen::derive::inverse
