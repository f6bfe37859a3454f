// SPDX-License-Identifier: MIT
// Inverse kinematics in C behind the types of the C++ ones: sets are read by the same code for all functions
// of a robot, rows by the same for all robots.
#pragma once

#include <array>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robot_under_test.h"

namespace qvgen::test {

/// The functions in C by the names that the C++ ones are registered under.
inline std::map<std::string, InverseFunctions>& inverses_in_c() {
  static std::map<std::string, InverseFunctions> all;
  return all;
}

inline bool add_inverse_in_c(const std::string& name, const InverseFunctions& functions) {
  return inverses_in_c().emplace(name, functions).second;
}

/// Names of arms whose C++ is not compiled.
inline std::set<std::string>& in_c_alone() {
  static std::set<std::string> all;
  return all;
}

/// Registers an arm whose laws are held by its functions in C.
inline bool add_inverse_in_c_alone(InverseUnderTest arm) {
  return in_c_alone().insert(arm.name).second && add_inverse(std::move(arm));
}

/// A solution next to a seed within limits, by the same names.
using NearWithin = Found (*)(const Pose<double>& pose, double given, const Eigen::VectorXd& seed,
                             const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);
inline std::map<std::string, NearWithin>& near_within_in_c() {
  static std::map<std::string, NearWithin> all;
  return all;
}

inline bool add_near_within_in_c(const std::string& name, NearWithin call) {
  return near_within_in_c().emplace(name, call).second;
}

/// Every representative of a pose's solutions in C within limits, as C and as C++ goes through them.
struct Representatives {
  std::vector<Row> c, cxx;
};
using RepresentativesOf = Representatives (*)(const Pose<double>&, double given, const Eigen::VectorXd& lower,
                                              const Eigen::VectorXd& upper);
inline std::map<std::string, RepresentativesOf>& representatives_in_c() {
  static std::map<std::string, RepresentativesOf> all;
  return all;
}

inline bool add_representatives_in_c(const std::string& name, RepresentativesOf call) {
  return representatives_in_c().emplace(name, call).second;
}

/// Returns what C++ goes through of solutions within limits, each joint's kind as a robot's `is_revolute` has
/// it.
std::vector<Row> representatives_in_cxx(const std::vector<Row>& rows, const Eigen::VectorXd& lower,
                                        const Eigen::VectorXd& upper, const bool* is_revolute);

/// So many of a hundred sets near singular poses, from a seed, may be others than those of C++. More where
/// the sines of seeds are the C++ library's own, and not libm's.
inline int& most_others() {
  static int most = 3;
  return most;
}

inline std::array<double, 4> wxyz(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }

inline Row row_of(const double* q, int dof, int branch, int continuum) {
  return {Eigen::Map<const Eigen::VectorXd>(q, dof), branch, continuum != 0};
}

/// A C set of solutions, `count` as it was returned beside it.
template <class Solutions>
Found found_of(const Solutions& set, int count, int dof) {
  Found found{
      static_cast<Status>(set.status), {}, {set.effort.passes, set.effort.steps, set.effort.used_up != 0}};
  if (count != set.count) throw std::logic_error("a count is not that of its set");
  for (int i = 0; i < count; ++i)
    found.rows.push_back(row_of(set.rows[i].q, dof, set.rows[i].branch, set.rows[i].continuum));
  return found;
}

/// `call` fills in a C set of solutions.
template <class Solutions, class Call>
Found found_in_c(int dof, const Call& call) {
  Solutions set;
  std::memset(static_cast<void*>(&set), 0x7f, sizeof set);
  const int count = call(&set);
  return found_of(set, count, dof);
}

inline void replace_values(char* numbers, const char* const* names, std::size_t count,
                           const reference::Values& values) {
  for (std::size_t i = 0; i < count; ++i)
    if (const auto value = values.find(names[i]); value != values.end())
      std::memcpy(numbers + i * sizeof(double), &value->second, sizeof(double));
}

/// Constants of the description but for those that are given by name.
template <class Geometry, std::size_t count>
Geometry geometry_in_c(Geometry geometry, const std::array<const char*, count>& names,
                       const reference::Values& values) {
  replace_values(reinterpret_cast<char*>(&geometry), names.data(), count, values);
  return geometry;
}

}  // namespace qvgen::test
