// SPDX-License-Identifier: MIT
// C that CasADi has written of Pinocchio's algorithms (measure.py), results dense.
#include <algorithm>
#include <numeric>

#include "implementation.h"

extern "C" {
using Number = long long;
#define QVGEN_PEER(NAME)                                                                          \
  int NAME(const double** argument, double** result, Number* integers, double* work, int memory); \
  int NAME##_work(Number* arguments, Number* results, Number* integers, Number* work);
QVGEN_PEER(peer_id)
QVGEN_PEER(peer_m)
QVGEN_PEER(peer_fd)
QVGEN_PEER(peer_did)
QVGEN_PEER(peer_dfd)
#undef QVGEN_PEER
}

namespace qvgen::benchmark::trees {
namespace {

const Robot* robot = nullptr;
std::vector<double> work;
std::vector<Number> integers;
std::vector<const double*> arguments;
std::vector<double*> results;

std::vector<double> found;

template <auto function, int matrices>
void call(std::size_t k) {
  const State& state = robot->states[k];
  const double** argument = arguments.data();
  argument[0] = state.q.data();
  argument[1] = state.v.data();
  argument[2] = state.a.data();
  for (int j = 0; j < (matrices == 0 ? 1 : matrices); ++j)
    results[static_cast<std::size_t>(j)] =
        found.data() + static_cast<std::size_t>(j) * robot->size * robot->size;
  function(argument, results.data(), integers.data(), work.data(), 0);
}

template <std::size_t matrices>
void copy(double* result) {
  const std::size_t n = robot->size;
  std::copy_n(found.begin(), matrices == 0 ? n : matrices * n * n, result);
}

template <class Sizes>
void reserve(Sizes sizes) {
  Number a = 0, r = 0, i = 0, w = 0;
  sizes(&a, &r, &i, &w);
  const auto grow = [](auto& values, Number count) {
    values.resize(std::max(values.size(), static_cast<std::size_t>(count + 4)));
  };
  grow(arguments, a);
  grow(results, r);
  grow(integers, i);
  grow(work, w);
}

}  // namespace

Implementation of_casadi(const Robot& of) {
  robot = &of;
  for (const auto sizes : {peer_id_work, peer_m_work, peer_fd_work, peer_did_work, peer_dfd_work})
    reserve(sizes);
  found.resize(3 * of.size * of.size);
  std::vector<std::size_t> place(of.size);
  std::iota(place.begin(), place.end(), std::size_t{0});
  return {"CasADi",
          {call<peer_id, 0>, call<peer_m, 1>, call<peer_fd, 0>, call<peer_did, 2>, call<peer_dfd, 3>},
          {copy<0>, copy<1>, copy<0>, copy<2>, copy<3>},
          place};
}

}  // namespace qvgen::benchmark::trees
