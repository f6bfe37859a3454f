// SPDX-License-Identifier: MIT
#include "passes/search/search.h"

#include <complex>

#include <gtest/gtest.h>

#include "dag/counts.h"
#include "dag/evaluate.h"
#include "exact/hash.h"
#include "exact/point.h"
#include "passes/search/random.h"

namespace qvgen::passes {
namespace {

using dag::Edge;
using dag::Function;
using dag::Graph;

dag::Angle angle(const std::string& name, long denominator = 1) {
  dag::Angle result;
  result.terms[name] = cln::cl_RA(1) / denominator;
  return result;
}

int operations(const Function& f, const dag::IsFree& is_free = {}) {
  const dag::OperationCounts c = dag::count(f, is_free);
  return c.multiplications + c.additions + 4 * c.divisions + 16 * c.sine_cosines;
}

void expect_same_values(const Function& a, const Function& b) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const exact::ExactPoint point(seed);
    EXPECT_EQ(dag::evaluate<exact::Number>(a, point), dag::evaluate<exact::Number>(b, point));
  }
}

SearchOptions steps(long iterations) {
  SearchOptions options;
  options.iterations = iterations;
  return options;
}

TEST(Search, FactorsACommonFactor) {
  Function f;
  Graph& g = f.graph;
  const Edge a = g.symbol("a");
  f.outputs = {{"y", g.sum({g.product({a, g.symbol("b")}), g.product({a, g.symbol("c")})})}};
  const Function found = search({f}, {}, steps(1000));
  expect_same_values(f, found);
  EXPECT_EQ(operations(found), 2);
}

TEST(Search, TakesTheBestPartOfEachForm) {
  // y = (a + b) c is short in form 1, z = d e + d f in form 2: neither form is best for both.
  const auto form = [](bool first) {
    Function f;
    Graph& g = f.graph;
    const Edge a = g.symbol("a"), b = g.symbol("b"), c = g.symbol("c");
    const Edge d = g.symbol("d"), e = g.symbol("e"), h = g.symbol("h");
    const Edge short_y = g.product({g.sum({a, b}), c});
    const Edge long_y = g.sum({g.product({a, c}), g.product({b, c})});
    const Edge short_z = g.product({g.sum({e, h}), d});
    const Edge long_z = g.sum({g.product({d, e}), g.product({d, h})});
    f.outputs = {{"y", first ? short_y : long_y}, {"z", first ? long_z : short_z}};
    return f;
  };
  SearchOptions options = steps(2000);
  options.closure = false;
  const Function found = search({form(true), form(false)}, {}, options);
  expect_same_values(form(true), found);
  EXPECT_EQ(operations(found), 4);
}

/// c^2 + s^2 = 1 and the double angle come from the values, without a rule.
TEST(Search, KnowsTheLawsOfTheCircle) {
  Function f;
  Graph& g = f.graph;
  const Edge c = g.cosine(angle("q")), s = g.sine(angle("q")), a = g.symbol("a");
  const Edge unit = g.sum({g.product({c, c}), g.product({s, s})});
  f.outputs = {{"y", g.product({unit, a})}};
  EXPECT_EQ(operations(search({f}, {}, steps(100))), 0);
}

TEST(Search, PrefersOneSineToTwo) {
  // cos q and sin q beside cos(q/2) and sin(q/2): one pair less for four operations (2 s s, 1 - , 2 s c).
  Function f;
  Graph& g = f.graph;
  f.outputs = {{"c", g.cosine(angle("q"))},
               {"s", g.sine(angle("q"))},
               {"d", g.cosine(angle("q", 2))},
               {"t", g.sine(angle("q", 2))}};
  const Function found = search({f}, {}, steps(2000));
  expect_same_values(f, found);
  EXPECT_EQ(dag::count(found).sine_cosines, 1);
  CostModel cheap;
  cheap.sine_cosine = 2;
  EXPECT_EQ(dag::count(search({f}, cheap, steps(2000))).sine_cosines, 2);
}

TEST(Search, ArithmeticOnFreeSymbolsCostsNothing) {
  Function f;
  Graph& g = f.graph;
  const Edge m = g.symbol("m"), l = g.symbol("l"), a = g.symbol("a"), b = g.symbol("b");
  f.outputs = {{"y", g.sum({g.product({m, a}), g.product({l, l, a}), g.product({m, l, b})})}};
  SearchOptions options = steps(2000);
  options.is_free_symbol = [](const std::string& name) { return name == "m" || name == "l"; };
  const Function found = search({f}, {}, options);
  expect_same_values(f, found);
  EXPECT_EQ(operations(found, options.is_free_symbol), 3);  // (m + l l) a + (m l) b
}

/// Euler wrist: three half-angle pairs, eight products and four sums as a quaternion; the half-angle sums
/// save all sums.
TEST(Search, FindsTheHalfAngleSumsOfAnEulerWrist) {
  const auto half = [](long f4, long f5, long f6) {
    dag::Angle result;
    if (f4 != 0) result.terms["q4"] = cln::cl_RA(f4) / 2;
    if (f5 != 0) result.terms["q5"] = cln::cl_RA(f5) / 2;
    if (f6 != 0) result.terms["q6"] = cln::cl_RA(f6) / 2;
    return result;
  };
  Function plain;
  {
    Graph& g = plain.graph;
    const auto c = [&](const dag::Angle& a) { return g.cosine(a); };
    const auto s = [&](const dag::Angle& a) { return g.sine(a); };
    const dag::Angle q4 = half(1, 0, 0), q5 = half(0, 1, 0), q6 = half(0, 0, 1);
    const auto form = [&](Edge k, Edge x1, Edge x2, Edge y1, Edge y2, bool minus) {
      const Edge second = g.product({y1, k, y2});
      return g.sum({g.product({x1, k, x2}), minus ? -second : second});
    };
    plain.outputs = {{"w", form(c(q5), c(q4), c(q6), s(q4), s(q6), true)},
                     {"z", form(c(q5), s(q4), c(q6), c(q4), s(q6), false)},
                     {"y", form(s(q5), c(q4), c(q6), s(q4), s(q6), false)},
                     {"x", form(s(q5), s(q4), c(q6), c(q4), s(q6), true)}};
  }
  Function sums;
  {
    Graph& g = sums.graph;
    const dag::Angle plus = half(1, 0, 1), minus = half(1, 0, -1), q5 = half(0, 1, 0);
    sums.outputs = {{"w", g.product({g.cosine(q5), g.cosine(plus)})},
                    {"z", g.product({g.cosine(q5), g.sine(plus)})},
                    {"y", g.product({g.sine(q5), g.cosine(minus)})},
                    {"x", g.product({g.sine(q5), g.sine(minus)})}};
  }
  const Function found = search({plain, sums}, {}, steps(5000));
  expect_same_values(plain, found);
  EXPECT_EQ(operations(found), 4 + 3 * 16);
  const Function alone = search({plain}, {}, steps(20000));
  expect_same_values(plain, alone);
  EXPECT_LE(operations(alone), 12 + 3 * 16);  // 8 products and 4 sums: c5, s5 factored into the inner pair
}

TEST(Search, SuggestionsAreOfferedButNotComputed) {
  Function f;
  Graph& g = f.graph;
  const Edge a = g.symbol("a"), b = g.symbol("b");
  const Edge squares = g.sum({g.product({a, a}), -g.product({b, b})});
  f.outputs = {{"y", squares}, {"?z", g.product({g.sum({a, b}), g.sum({a, -b})})}};
  const Function found = search({f}, {.multiplication = 2}, steps(1000));
  ASSERT_EQ(found.outputs.size(), 1U);
  const dag::OperationCounts counts = dag::count(found);
  EXPECT_EQ(counts.multiplications, 1);
  EXPECT_EQ(counts.additions, 2);
}

TEST(Search, RejectsFormsThatDisagree) {
  const auto form = [](const char* name, const char* symbol) {
    Function f;
    f.outputs = {{name, f.graph.symbol(symbol)}};
    return f;
  };
  EXPECT_THROW(search({form("y", "a"), form("y", "b")}, {}, {}), std::invalid_argument);
  EXPECT_THROW(search({form("y", "a"), form("z", "a")}, {}, {}), std::invalid_argument);
  EXPECT_THROW(search({}, {}, {}), std::invalid_argument);
}

TEST(Search, KeepsOpaqueOperationsApart) {
  Function f;
  Graph& g = f.graph;
  const Edge a = g.symbol("a"), b = g.symbol("b");
  f.outputs = {{"y", g.root(g.sum({a, b}))},
               {"z", g.arctangent(a, b)},
               {"x", g.quotient(a, b)},
               {"w", g.arctangent(-a, b)}};
  const dag::OperationCounts counts = dag::count(search({f}, {}, steps(500)));
  EXPECT_EQ(counts.roots, 1);
  EXPECT_EQ(counts.arctangents, 2);
  EXPECT_EQ(counts.divisions, 1);
}

/// Random complex numbers for symbols, which roots take anything of. No angles, no arctangents.
struct ComplexPoint {
  using Value = std::complex<double>;
  std::uint64_t seed;

  static Value constant(const exact::Number& value) { return value.to_double(); }
  [[nodiscard]] Value symbol(const std::string& name) const {
    search_detail::Random random(seed + exact::hash(name));
    const auto part = [&] { return 0.5 + random.below(1U << 20) / static_cast<double>(1U << 20); };
    const double real = part();
    return {real, part()};
  }
  static Value root(const Value& value) { return std::sqrt(value); }
  static Value sine(const dag::Angle& /*angle*/) { throw std::domain_error("no angles here"); }
  static Value cosine(const dag::Angle& angle) { return sine(angle); }
  static Value arctangent(const Value& y, const Value& /*x*/) { return y; }
};

void expect_same_complex_values(const Function& a, const Function& b, std::uint64_t seed) {
  const auto of_a = dag::evaluate<std::complex<double>>(a, ComplexPoint{seed});
  const auto of_b = dag::evaluate<std::complex<double>>(b, ComplexPoint{seed});
  ASSERT_EQ(of_a.size(), of_b.size());
  for (std::size_t i = 0; i < of_a.size(); ++i)
    EXPECT_LT(std::abs(of_a[i] - of_b[i]), 1e-9 * (1 + std::abs(of_a[i]))) << "seed " << seed;
}

/// Two random sums, and their product in two forms.
struct ProductOfSums {
  Edge factored, expanded;
};
ProductOfSums product_of_sums(Graph& g, search_detail::Random& random) {
  const std::vector<Edge> symbols = {g.symbol("a"), g.symbol("b"), g.symbol("c"), g.symbol("d")};
  const auto any = [&] {
    const Edge edge = symbols[random.below(4)];
    return random.chance(64) ? -edge : edge;
  };
  const std::vector<Edge> left = {any(), g.constant(exact::Number(3)), any()};
  const std::vector<Edge> right = {g.constant(exact::Number::root(2 + random.below(50))), any()};
  std::vector<Edge> products;
  for (const Edge l : left)
    for (const Edge r : right) products.push_back(g.product({l, r}));
  return {g.product({g.sum(left), g.sum(right)}), g.sum(products)};
}

/// Roots of one value written in two ways are one root; those of its negative, of its double and of itself
/// are others.
TEST(Search, TakesOneRootOfEachValue) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    search_detail::Random random(seed);
    Function f;
    Graph& g = f.graph;
    const auto [factored, expanded] = product_of_sums(g, random);
    const Edge root = g.root(factored);
    f.outputs = {{"y", g.product({root, g.symbol("a")})}, {"z", g.sum({g.root(expanded), g.symbol("b")})}};
    const Function one = search({f}, {}, steps(300));
    EXPECT_EQ(dag::count(one).roots, 1) << "seed " << seed;
    expect_same_complex_values(f, one, seed);
    const Edge twice = g.product({g.constant(exact::Number(2)), expanded});
    f.outputs.insert(f.outputs.end(), {{"x", g.root(-expanded)}, {"w", g.root(twice)}, {"v", g.root(root)}});
    const Function others = search({f}, {}, steps(300));
    EXPECT_EQ(dag::count(others).roots, 4) << "seed " << seed;
    expect_same_complex_values(f, others, seed);
  }
}

/// A random expression over a few symbols and sines, its nodes reused at random.
Function random_function(std::uint64_t seed) {
  search_detail::Random random(seed);
  Function f;
  Graph& g = f.graph;
  std::vector<Edge> pool = {
      g.symbol("a"),      g.symbol("b"),           g.symbol("c"),         g.cosine(angle("q")),
      g.sine(angle("q")), g.cosine(angle("q", 2)), g.sine(angle("q", 2)), g.constant(exact::Number(2))};
  const auto any = [&] {
    const Edge edge = pool[random.below(static_cast<std::uint32_t>(pool.size()))];
    return random.chance(64) ? -edge : edge;
  };
  for (int i = 0; i < 30; ++i) {
    std::vector<Edge> operands = {any(), any()};
    if (random.chance(100)) operands.push_back(any());
    pool.push_back(random.chance(128) ? g.sum(operands) : g.product(operands));
  }
  for (std::size_t i = 0; i < 4; ++i)
    f.outputs.push_back({"y" + std::to_string(i), pool[pool.size() - 1 - i]});
  return f;
}

TEST(Search, KeepsValuesNeverCostsMoreAndRepeatsItselfOnRandomExpressions) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Function f = random_function(seed);
    const Function found = search({f}, {}, steps(3000));
    expect_same_values(f, found);
    EXPECT_LE(operations(found), operations(f)) << "seed " << seed;
    const Function again = search({f}, {}, steps(3000));
    ASSERT_EQ(found.graph.size(), again.graph.size());
    for (std::uint32_t id = 0; id < found.graph.size(); ++id)
      EXPECT_EQ(found.graph.node(id).key, again.graph.node(id).key);
  }
}

}  // namespace
}  // namespace qvgen::passes
