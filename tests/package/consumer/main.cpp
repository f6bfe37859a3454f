// SPDX-License-Identifier: MIT
#include <cstdio>

#include <qvgen/robots/rrp.h>

#include "parts.h"

namespace {

bool robots_work() {
  namespace arm = qvgen::robots::rrp;
  const arm::JointVector<double> q = arm::JointVector<double>::Constant(0.3);
  const qvgen::Pose<double> tool = arm::forward_kinematics(q);
  std::printf("rrp at 0.3: %.6f %.6f %.6f\n", tool.position.x(), tool.position.y(), tool.position.z());
  return is_valid(tool);
}

}  // namespace

int main() {
  bool good = runtime_works() && robots_work();
#ifdef CONSUMER_HAS_VECTOR_FILE
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    good = good && vector_file_works();
  }
#endif
  std::puts(good ? "good" : "bad");
  return good ? 0 : 1;
}
