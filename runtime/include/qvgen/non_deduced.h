// SPDX-License-Identifier: MIT
#pragma once

namespace qvgen {

namespace detail {
template <class T>
struct Identity {
  using type = T;
};
}  // namespace detail

/// T in a parameter that does not take part in template argument deduction, so that `9.81` can be given for a
/// float or an automatic differentiation type (std::type_identity_t of C++20).
template <class T>
using NonDeduced = typename detail::Identity<T>::type;

}  // namespace qvgen
