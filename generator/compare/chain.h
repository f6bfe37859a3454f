// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "compare/library.h"

/// Shared parts of the algorithms of several quantities.
namespace qvgen::compare {

inline dag::Angle variable(const std::string& name) { return {{{name, 1}}, 0}; }
inline dag::Angle half(const std::string& name) { return cln::cl_RA(1) / 2 * variable(name); }

/// A product of motions; the first factor is taken as it is.
template <class Motion>
class Chain {
 public:
  void append(const Motion& motion) {
    if (product_)
      product_.emplace(*product_ * motion);
    else
      product_.emplace(motion);
  }
  [[nodiscard]] bool empty() const { return !product_; }
  [[nodiscard]] const Motion& value() const { return product_.value(); }

 private:
  std::optional<Motion> product_;
};

/// Entries of identities: general numbers to a library.
Vector zero(Recorder& recorder);
Matrix identity(Recorder& recorder);
Quaternion identity_quaternion(Recorder& recorder);

}  // namespace qvgen::compare
