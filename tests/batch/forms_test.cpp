// SPDX-License-Identifier: MIT
// Which functions have batch forms by lanes as their scalar: all without branches.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "emit/cpp/batch_forms.h"

namespace qvgen::emit {
namespace {

TEST(BatchForms, AreThereForAllButInverseKinematics) {
  std::ifstream file(QVGEN_SOURCE_DIR "/generated/operation_counts.json");
  const nlohmann::json robots = nlohmann::json::parse(file);
  int forms = 0;
  for (const auto& [robot, functions] : robots.items())
    for (const auto& [function, counts] : functions.items()) {
      const bool is_other = function == "missing" || function == "targets" ||
                            function.rfind("inverse_kinematics", 0) == 0 ||
                            function.rfind("arm_angle", 0) == 0;
      EXPECT_NE(batch_form(function).has_value(), is_other) << robot << ": " << function;
      forms += is_other ? 0 : 1;
    }
  EXPECT_GT(forms, 300);
}

}  // namespace
}  // namespace qvgen::emit
