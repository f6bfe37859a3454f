// SPDX-License-Identifier: MIT
#include "verify/certificate.h"

#include <gtest/gtest.h>

#include "dag/import.h"
#include "optimise/optimise.h"
#include "symbolic/model.h"
#include "verify/accuracy.h"

namespace {

using namespace qvgen;
using symbolic::Program;
using symbolic::symbol;

Program program_of(const GiNaC::ex& value) {
  Program program;
  program.output("o", value);
  return program;
}

const GiNaC::ex a = symbol("a");
const GiNaC::ex t = symbol("t");

TEST(Certificate, AcceptsAnIdentity) {
  const Program definition = program_of(GiNaC::pow(GiNaC::sin(t / 2), 2) * 2 * a);
  EXPECT_NO_THROW(verify::certify(dag::import(program_of(a - a * GiNaC::cos(t))), definition, 4, "test"));
}

TEST(Certificate, RefusesASmallDifference) {
  const Program definition = program_of(a * GiNaC::cos(t));
  const GiNaC::ex wrong = a * GiNaC::cos(t) + GiNaC::numeric(1, 1000000007) * a;
  EXPECT_THROW(verify::certify(dag::import(program_of(wrong)), definition, 1, "test"),
               verify::CertificateError);
  EXPECT_THROW(verify::certify(dag::import(program_of(-a * GiNaC::cos(t))), definition, 1, "test"),
               verify::CertificateError);
}

TEST(Optimise, PicksTheCheapestFormAndCertifiesIt) {
  const GiNaC::ex b = symbol("b");
  const GiNaC::ex c = symbol("c");
  derive::Quantity quantity{"q",
                            {{"expanded", program_of(a * b + a * c)}, {"factored", program_of(a * (b + c))}},
                            program_of(a * b + a * c)};
  const optimise::Optimised result = optimise::optimise(quantity);
  EXPECT_EQ(result.counts, (dag::OperationCounts{1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(result.forms.size(), 2U);
  EXPECT_GE(result.certified_points, 4);
}

TEST(Optimise, RefusesFormsThatAreNotTheDefinition) {
  derive::Quantity quantity{"q", {{"wrong", program_of(a + 1)}}, program_of(a)};
  EXPECT_THROW(optimise::optimise(quantity), verify::CertificateError);
}

TEST(Accuracy, SeesRoundingAndCancellation) {
  const dag::Function exact = dag::import(program_of(a + a));
  EXPECT_EQ(verify::largest_error_in_ulps(exact, {{"o"}}, 50), 0);
  const dag::Function cancelling =
      dag::import(program_of((a + 1000000) * (a - 1000000) + GiNaC::numeric("1000000000000")));
  EXPECT_GT(verify::largest_error_in_ulps(cancelling, {{"o"}}, 50), 1000);
}

}  // namespace
