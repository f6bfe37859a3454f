// SPDX-License-Identifier: MIT
// Motors of an MJCF that act on fixed tendons.
//
// A fixed tendon's length is a sum of multiples of joints, and its motor's force acts on them by these
// multiples: the length is the motor's value. Where lengths, together with the joints that have actuators of
// their own, are as many as the joints and tell them apart, joints follow lengths exactly. So a wrist with
// two tendons, a + b and a - b, has a = 1/2 m1 + 1/2 m2 and b = 1/2 m1 - 1/2 m2. Beside loops a length is an
// equation among others, so that fewer lengths than joints serve as well.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <cln/rational.h>

#include "description/xml/element.h"

namespace qvgen::description::xml {

using JointSum = std::map<std::string, cln::cl_RA>;  ///< factors by names

/// Tendons with actuators that have joints in common, and these joints, which follow none.
struct TendonGroup {
  std::vector<std::string> tendons;
  std::set<std::string> joints;
  /// Joints as sums of lengths and of other joints; empty if the lengths do not tell them.
  std::map<std::string, JointSum> relations;
};

/// Returns the groups of tendons, whose lengths are sums of joints, in the order of their names. `driven`:
/// joints with actuators of their own. `beside_loops`: joints may be more than lengths tell, for loops tell
/// them too.
std::vector<TendonGroup> tendon_groups(const std::map<std::string, JointSum>& lengths,
                                       const std::set<std::string>& driven, bool beside_loops);

/// Elements of <actuator> by what they act on: `key` is "tendon" or "joint". The first of each.
std::map<std::string, const Element*> actuators_of(const Element& root, const std::string& key);

}  // namespace qvgen::description::xml
