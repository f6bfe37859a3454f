// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "dag/graph.h"
#include "derive/inverse/plan.h"

namespace qvgen::application {

/// A plan with its programs lowered to graphs and optimised: what is certified and what is emitted.
struct LoweredPlan {
  derive::inverse::Plan plan;
  dag::Function target;
  dag::Function range_test;
  struct Step {
    dag::Function before;
    dag::Function after;
  };
  std::vector<Step> steps;
};

LoweredPlan lower(const derive::inverse::Plan& plan);

}  // namespace qvgen::application
