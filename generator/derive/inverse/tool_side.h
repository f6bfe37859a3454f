// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "derive/inverse/block.h"
#include "derive/inverse/target.h"

namespace qvgen::derive::inverse {

/// The joint as it turns directions instead of points.
Screw without_place(const Screw& screw);

/// Points and directions as the pose and one joint c place them: G = e_c^-1 T or T e_c^-1, T the tool's
/// displacement (its inverse for an arm that is read backwards), in the components along and across an axis.
class ToolSide {
 public:
  enum Component { along, first, second };

  struct Options {
    bool back = false;     ///< T^-1 in place of T
    bool c_first = false;  ///< e_c^-1 T, else T e_c^-1
  };

  ToolSide(Builder& builder, Target& target, const Screw& axis, const Screw& c, Options options);

  /// G x as it depends on the angle of c.
  class Image {
   public:
    [[nodiscard]] Block::Form form(Component n, const Scope& scope) const;
    /// At the solved value of c.
    [[nodiscard]] GiNaC::ex at(Component n, Builder& builder) const;

   private:
    friend class ToolSide;
    Block block_;
    std::array<symbolic::Vector, 3> components_;
    std::array<GiNaC::ex, 3> offsets_{0, 0, 0};
  };

  Image point(const std::string& name, const symbolic::Vector& x);
  Image direction(const std::string& name, const symbolic::Vector& v);

 private:
  [[nodiscard]] symbolic::Vector image(const symbolic::Vector& x) const {
    return options_.back ? target_.source(x) : target_.image(x);
  }
  [[nodiscard]] symbolic::Vector turned(const symbolic::Vector& v) const;
  [[nodiscard]] symbolic::Vector turned_back(const symbolic::Vector& v) const;
  symbolic::Vector named(const std::string& name, const symbolic::Vector& v);
  [[nodiscard]] Image seen_by_tool(const symbolic::Vector& v) const;

  Builder& builder_;
  Target& target_;
  Screw c_;
  Options options_;
  std::array<symbolic::Vector, 3> components_;
  std::array<symbolic::Vector, 3> seen_;  ///< these in T's own frame, for T e_c^-1
};

}  // namespace qvgen::derive::inverse
