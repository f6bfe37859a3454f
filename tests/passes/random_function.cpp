// SPDX-License-Identifier: MIT
#include "random_function.h"

#include <random>

namespace qvgen::test {

using dag::Angle;
using dag::Edge;

dag::Function random_function(std::uint32_t seed, int operations) {
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  dag::Function function;
  dag::Graph& g = function.graph;
  const Angle theta{{{"theta", 1}}, 0};
  const Angle half{{{"theta", cln::cl_RA(1) / 2}}, 0};
  std::vector<Edge> pool{g.symbol("a"),
                         g.symbol("b"),
                         g.symbol("c"),
                         g.sine(theta),
                         g.cosine(theta),
                         g.sine(half),
                         g.cosine(half),
                         g.constant(1),
                         g.constant(2),
                         g.constant(exact::Number(cln::cl_RA(-3) / 7)),
                         g.constant(exact::Number::root(2))};
  const auto pick = [&] {
    const Edge edge = pool[below(pool.size())];
    return below(2) == 0 ? edge : -edge;
  };
  for (int i = 0; i < operations; ++i) {
    std::vector<Edge> operands;
    for (std::size_t n = 2 + below(3); n > 0; --n) operands.push_back(pick());
    switch (below(8)) {
      case 0:
        pool.push_back(g.product({operands[0], operands[0]}));
        break;
      case 1:
        pool.push_back(
            g.quotient(operands[0], g.sum({g.constant(5), g.product({operands[1], operands[1]})})));
        break;
      case 2:
      case 3:
      case 4:
        pool.push_back(g.product(operands));
        break;
      default:
        pool.push_back(g.sum(operands));
        break;
    }
  }
  for (int i = 0; i < 4; ++i)
    function.outputs.push_back(
        {"o" + std::to_string(i), pool[pool.size() - 1 - static_cast<std::size_t>(i)]});
  return function;
}

}  // namespace qvgen::test
