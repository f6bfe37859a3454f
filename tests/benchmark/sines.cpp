// SPDX-License-Identifier: MIT
// Sines and cosines of the angles of one call, which are half or more of its time: one vector pass against
// libm.
#include <array>
#include <cmath>
#include <random>

#include <qvgen/sine_cosine.h>

#include "suite.h"

namespace {

template <std::size_t Count, class Function>
void measure(const std::string& name, Function function) {
  comparison::add_benchmark(name, [function](benchmark::State& state) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> angle(-3.14159, 3.14159);
    std::array<std::array<double, Count>, 256> angles{};
    for (auto& row : angles) {
      for (double& entry : row) entry = angle(random);
    }
    std::size_t i = 0;
    for (auto _ : state) {
      auto result = function(angles[i]);
      benchmark::DoNotOptimize(result);
      i = (i + 1) % angles.size();
    }
  });
}

template <std::size_t Count>
qvgen::SineCosine<double, static_cast<int>(Count)> vector_pass(const std::array<double, Count>& angles) {
  return std::apply([](auto... a) { return qvgen::sines_and_cosines<double>(a...); }, angles);
}

template <std::size_t Count>
qvgen::SineCosine<double, static_cast<int>(Count)> libm(const std::array<double, Count>& angles) {
  qvgen::SineCosine<double, static_cast<int>(Count)> result;
  for (std::size_t i = 0; i < Count; ++i) {
    result.sine[i] = std::sin(angles[i]);
    result.cosine[i] = std::cos(angles[i]);
  }
  return result;
}

template <std::size_t Count>
void add() {
  const std::string name = "sines and cosines/" + std::to_string(Count) + " angles/";
  measure<Count>(name + "libm", [](const auto& angles) { return libm<Count>(angles); });
  measure<Count>(name + "qvgen", [](const auto& angles) { return vector_pass<Count>(angles); });
}

const bool added = [] {
  comparison::add_setup([] {
    add<1>();
    add<2>();
    add<4>();
    add<6>();
    add<7>();
    add<12>();
  });
  return true;
}();

}  // namespace
