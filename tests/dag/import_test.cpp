// SPDX-License-Identifier: MIT
#include "dag/import.h"

#include <gtest/gtest.h>

#include "dag/counts.h"
#include "dag/evaluate.h"
#include "symbolic/evaluate.h"
#include "symbolic/model.h"

namespace {

using namespace qvgen;
using GiNaC::ex;
using symbolic::Program;
using symbolic::symbol;

dag::Function import_one(const ex& value) {
  Program program;
  program.output("o", value);
  return dag::import(program);
}

/// The structural hash of the first output, which must not depend on GiNaC's order of terms.
std::uint64_t key(const dag::Function& function) {
  return function.graph.node(function.outputs[0].value).key;
}

TEST(Import, KeepsTheValue) {
  const ex a = symbol("a");
  const ex b = symbol("b");
  const ex t = symbol("t");
  const std::vector<ex> cases{a + 2 * b - 3,
                              a * b / (a + b),
                              GiNaC::pow(a, 3) - 1 / (b * b),
                              GiNaC::sin(t / 2) * GiNaC::cos(t) + GiNaC::sqrt(ex(3)) * a,
                              GiNaC::sin(GiNaC::Pi / 3 - t),
                              -(a - b) * (a - b) / (2 * GiNaC::cos(t))};
  for (const ex& value : cases) {
    Program program;
    program.output("o", value);
    const dag::Function function = dag::import(program);
    for (std::uint64_t seed = 1; seed < 5; ++seed) {
      const exact::ExactPoint point(seed);
      EXPECT_EQ(dag::evaluate<exact::Number>(function, point), evaluate(program, point)) << value;
    }
  }
}

TEST(Import, ForgetsTheOrderOfTerms) {
  const ex a = symbol("a");
  const ex b = symbol("b");
  const ex c = symbol("c");
  EXPECT_EQ(key(import_one(a * b + c - a)), key(import_one(-a + c + b * a)));
}

TEST(Import, SharesNamedSteps) {
  Program program;
  const ex shared = program.let(symbol("a") + symbol("b"));
  program.output("x", shared * symbol("c"));
  program.output("y", shared * symbol("d"));
  const dag::OperationCounts counts = dag::count(dag::import(program));
  EXPECT_EQ(counts.additions, 1);
  EXPECT_EQ(counts.multiplications, 2);
}

TEST(Import, RefusesWhatCannotBeGenerated) {
  const ex a = symbol("a");
  EXPECT_THROW(import_one(GiNaC::sin(a * a)), std::domain_error);
  EXPECT_THROW(import_one(GiNaC::exp(a)), std::domain_error);
  EXPECT_THROW(import_one(GiNaC::pow(a, symbol("b"))), std::domain_error);
  EXPECT_THROW(import_one(GiNaC::pow(a, GiNaC::numeric(1, 3))), std::domain_error);
}

}  // namespace
