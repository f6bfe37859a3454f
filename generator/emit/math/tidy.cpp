// SPDX-License-Identifier: MIT
#include "emit/math/tidy.h"

#include "dag/import.h"
#include "derive/jacobian/circle_polynomial.h"
#include "emit/math/notation.h"
#include "passes/pass.h"
#include "symbolic/program.h"
#include "verify/certificate.h"

namespace qvgen::emit {
namespace {

symbolic::Program program_of(const GiNaC::ex& value) {
  symbolic::Program program;
  program.output("value", value);
  return program;
}

dag::Function simplified(const GiNaC::ex& written, const GiNaC::ex& meant) {
  const dag::Function function = passes::simplify(dag::import(program_of(written)));
  verify::certify(function, program_of(meant), 2, "a formula written otherwise");
  return function;
}

std::size_t length(const dag::Function& function) {
  return formula(function.graph, function.outputs.front().value, Notation::text).size();
}

}  // namespace

dag::Function tidy(const GiNaC::ex& value) { return simplified(value, value); }

bool has_whole_angles(const GiNaC::ex& value) {
  for (auto it = value.preorder_begin(); it != value.preorder_end(); ++it) {
    if (!GiNaC::is_a<GiNaC::function>(*it)) continue;
    const GiNaC::ex angle = it->op(0);
    for (auto part = angle.preorder_begin(); part != angle.preorder_end(); ++part)
      if (GiNaC::is_a<GiNaC::symbol>(*part) && !angle.coeff(*part, 1).info(GiNaC::info_flags::integer))
        return false;
  }
  return true;
}

dag::Function tidy_in_sums(const GiNaC::ex& value) {
  const dag::Function plain = tidy(value);
  if (!has_whole_angles(value)) return plain;
  try {
    derive::CirclePolynomials circles;
    const dag::Function sums = simplified(circles.written_out(value), value);
    return length(sums) < length(plain) ? sums : plain;
  } catch (const derive::TooManyTerms&) {
    return plain;
  }
}

}  // namespace qvgen::emit
