// SPDX-License-Identifier: MIT
// Lanes of NEON against single calls: kinematics and dynamics, whose sines are libm's in single calls, within
// rounding; inverse kinematics, which rounds alike everywhere, by its bits. Without GoogleTest, which Debian
// has for the machine that builds alone.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <qvgen/batch/inverse.h>
#include <qvgen/robots/stranger/batch.h>
#include <qvgen/robots/stranger_wrist/batch.h>

namespace {

using qvgen::Batch;
namespace arm = qvgen::robots::stranger;
namespace wrist = qvgen::robots::stranger_wrist;

bool all_well = true;

void expect(bool condition, const char* what) {
  if (!condition) std::printf("%s\n", what);
  all_well = all_well && condition;
}

template <class T>
std::vector<T> numbers(std::size_t count) {
  static std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-3, 3);
  std::vector<T> result(count);
  for (T& each : result) each = static_cast<T>(number(random));
  return result;
}

/// True if the numbers are as good as the same.
template <class T, class Single>
bool is_near(const std::vector<T>& rows, std::size_t count, std::size_t k, const Single& single,
             double bound) {
  const auto size = static_cast<std::size_t>(single.size());
  const T most =
      static_cast<T>(bound) * std::numeric_limits<T>::epsilon() * single.template lpNorm<Eigen::Infinity>();
  for (std::size_t i = 0; i < size; ++i)
    if (!(std::abs(rows[i * count + k] - single[static_cast<int>(i)]) <= most)) return false;
  return true;
}

template <class T>
void compare_functions(std::size_t count) {
  const auto q = numbers<T>(arm::dof * count), qd = numbers<T>(arm::dof * count),
             third = numbers<T>(arm::dof * count);
  const auto in = [&](const std::vector<T>& rows) { return Batch<const T>(rows.data(), count); };
  std::vector<T> pose(7 * count), torque(arm::dof * count), rate(arm::dof * count);
  arm::forward_kinematics(in(q), Batch<T>(pose.data(), count));
  arm::inverse_dynamics(in(q), in(qd), in(third), Batch<T>(torque.data(), count));
  arm::forward_dynamics(in(q), in(qd), in(third), Batch<T>(rate.data(), count));
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = [&](const std::vector<T>& rows) {
      arm::JointVector<T> result;
      for (int i = 0; i < arm::dof; ++i) result[i] = rows[static_cast<std::size_t>(i) * count + k];
      return result;
    };
    const qvgen::Pose<T> single = arm::forward_kinematics<T>(at(q));
    Eigen::Matrix<T, 7, 1> seven;
    seven << single.orientation.w(), single.orientation.vec(), single.position;
    expect(is_near(pose, count, k, seven, 16), "forward_kinematics");
    expect(is_near(torque, count, k, arm::inverse_dynamics<T>(at(q), at(qd), at(third)), 64),
           "inverse_dynamics");
    expect(is_near(rate, count, k, arm::forward_dynamics<T>(at(q), at(qd), at(third)), 64 * 300),
           "forward_dynamics");
  }
}

void compare_solutions(std::size_t count) {
  constexpr std::size_t capacity = wrist::Solutions::max_size, rows = capacity * wrist::dof;
  const auto q = numbers<double>(wrist::dof * count);
  std::vector<double> poses(7 * count), found(rows * count), single(rows * count);
  wrist::forward_kinematics(Batch<const double>(q.data(), count), Batch<double>(poses.data(), count));
  const Batch<const double> in(poses.data(), count);
  std::vector<int> counts(count), single_counts(count);
  std::vector<qvgen::Status> status(count), single_status(count);
  const auto places = [count](auto& joints, auto& sizes, auto& states) {
    return qvgen::BatchOfSolutions{
        {joints.data(), count}, {sizes.data(), count}, {states.data(), count}, {}, {}};
  };
  wrist::inverse_kinematics(in, places(found, counts, status));
  const auto one = [&](std::size_t k) { return wrist::inverse_kinematics(qvgen::batch::pose_at(in, k)); };
  qvgen::batch::one_by_one(count, places(single, single_counts, single_status), one);
  expect(counts == single_counts && status == single_status, "numbers of solutions");
  for (std::size_t k = 0; k < count; ++k) expect(counts[k] > 0, "a pose that the arm has taken");
  for (std::size_t i = 0; i < found.size(); ++i)
    expect(std::memcmp(&found[i], &single[i], sizeof found[i]) == 0 ||
               (std::isnan(found[i]) && std::isnan(single[i])),
           "solutions");
}

}  // namespace

int main() {
  expect(qvgen::widest_instruction_set() == qvgen::InstructionSet::neon, "no NEON");
  for (std::size_t count : {1U, 2U, 3U, 4U, 5U, 7U, 64U, 133U}) {
    compare_functions<double>(count);
    compare_functions<float>(count);
    compare_solutions(count);
  }
  if (all_well) std::puts("as single calls");
  return all_well ? 0 : 1;
}
