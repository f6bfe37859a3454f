// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <qvgen/pack.h>

#include "arm_benchmarks.h"

namespace comparison {

/// Positions, rates and accelerations (or forces) of four configurations.
template <class Arm>
struct Four {
  typename Arm::template Joints<qvgen::Pack> q, qd, qdd, torque;
};

template <class Arm>
std::vector<Four<Arm>> fours(const std::vector<typename Arm::template Joints<double>>& q) {
  std::vector<Four<Arm>> result(q.size() / qvgen::Pack::size);
  for (std::size_t i = 0; i < q.size(); ++i) {
    Four<Arm>& four = result[i / qvgen::Pack::size];
    const int lane = static_cast<int>(i % qvgen::Pack::size);
    const auto &qd = q[(i + 85) % q.size()], &qdd = q[(i + 170) % q.size()];
    const auto torque = Arm::template inverse<double>(q[i], qd, qdd);
    for (Eigen::Index k = 0; k < q[i].size(); ++k) {
      four.q[k].set(lane, q[i][k]);
      four.qd[k].set(lane, qd[k]);
      four.qdd[k].set(lane, qdd[k]);
      four.torque[k].set(lane, torque[k]);
    }
  }
  return result;
}

/// Largest difference of a lane from the same call in double, relative to the largest component.
template <class Arm>
double disagreement_of_lanes(const std::vector<Four<Arm>>& all) {
  using Joints = typename Arm::template Joints<double>;
  double worst = 0;
  const auto compare = [&](const auto& packs, const auto& numbers, int lane) {
    const double size = 1 + numbers.cwiseAbs().maxCoeff();
    for (Eigen::Index k = 0; k < numbers.size(); ++k)
      worst = std::max(worst, std::abs(packs(k)[lane] - numbers(k)) / size);
  };
  for (const Four<Arm>& four : all)
    for (int lane = 0; lane < qvgen::Pack::size; ++lane) {
      const auto of = [&](const auto& packs) -> Joints {
        return packs.unaryExpr([&](const qvgen::Pack& p) { return p[lane]; });
      };
      const Joints q = of(four.q), qd = of(four.qd), torque = of(four.torque);
      compare(Arm::inverse(four.q, four.qd, four.qdd), torque, lane);
      compare(Arm::mass(four.q), Arm::mass(q), lane);
      const Joints found = of(Arm::forward(four.q, four.qd, four.torque));
      compare(four.torque, Arm::template inverse<double>(q, qd, found), lane);
    }
  return worst;
}

/// As `measure`, per configuration.
template <class Function>
void measure_fours(const std::string& name, std::size_t count, Function function) {
  add_benchmark(name, [function, count](benchmark::State& state) mutable {
    std::size_t i = 0;
    while (state.KeepRunningBatch(qvgen::Pack::size)) {
      auto result = function(i);
      benchmark::DoNotOptimize(result);
      i = (i + 1) % count;
    }
  });
  add_counted(name, [function, count]() mutable {
    for (std::size_t i = 0; i < counted_calls / qvgen::Pack::size; ++i) {
      auto result = function(i % count);
      benchmark::DoNotOptimize(result);
    }
  });
}

template <class Arm>
bool add_arm_batches() {
  add_setup([] {
    const std::string robot = Arm::name;
    const auto all = std::make_shared<std::vector<Four<Arm>>>(
        fours<Arm>(configurations<typename Arm::template Joints<double>>(load_robot(robot))));
    require_agreement(robot + " in packs", disagreement_of_lanes<Arm>(*all) / 100);  // 1e-10
    const auto at = [all](std::size_t i) -> const Four<Arm>& { return (*all)[i]; };
    measure_fours("inverse dynamics/" + robot + "/qvgen by fours", all->size(),
                  [=](std::size_t i) { return Arm::inverse(at(i).q, at(i).qd, at(i).qdd); });
    measure_fours("mass matrix/" + robot + "/qvgen by fours", all->size(),
                  [=](std::size_t i) { return Arm::mass(at(i).q); });
    measure_fours("forward dynamics/" + robot + "/qvgen by fours", all->size(),
                  [=](std::size_t i) { return Arm::forward(at(i).q, at(i).qd, at(i).torque); });
  });
  return true;
}

}  // namespace comparison
