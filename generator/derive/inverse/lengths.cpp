// SPDX-License-Identifier: MIT
#include "derive/inverse/lengths.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "derive/inverse/names.h"
#include "derive/inverse/schedule.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;
using symbolic::Program;

namespace {

struct Names {
  explicit Names(const Step& step)
      : cosine(symbolic::symbol(names::cosine(step.unknown))),
        sine(symbolic::symbol(names::sine(step.unknown))) {}
  [[nodiscard]] bool in(const ex& value) const { return value.has(cosine) || value.has(sine); }
  [[nodiscard]] bool have(const GiNaC::symbol& name) const {
    return name.is_equal(cosine) || name.is_equal(sine);
  }
  [[nodiscard]] bool are_read_by(const Step& step) const {
    const std::vector<std::string> names = reads(step);
    return std::find(names.begin(), names.end(), cosine.get_name()) != names.end() ||
           std::find(names.begin(), names.end(), sine.get_name()) != names.end();
  }

  GiNaC::symbol cosine, sine;
};

/// A value that is linear in cos φ and sin φ and reads them as r alone, if it does.
std::optional<ex> by_length(const ex& value, const Step& step, const Names& names, const Scope& scope) {
  const ex expanded = value.expand();
  const ex a = expanded.coeff(names.cosine, 1);
  const ex b = expanded.coeff(names.sine, 1);
  const ex rest = (expanded - a * names.cosine - b * names.sine).expand();
  if (names.in(rest) || names.in(a) || names.in(b)) return std::nullopt;
  const ex x = step.input("x");
  const ex y = step.input("y");
  if (scope.is_zero(a * x + b * y)) return rest;
  const ex factor = (x.is_zero() ? b / y : a / x).normal();
  if (!Scope::is_number(factor) || !scope.is_zero(a - factor * x) || !scope.is_zero(b - factor * y))
    return std::nullopt;
  return rest + factor * symbolic::symbol(names::result);
}

/// Rewrites a step's results by its direction's length wherever the direction itself was read.
std::optional<Program> by_length(const Step& step, const Names& names, const Scope& scope) {
  Program program;
  for (const Program::Step& value : step.after.steps()) {
    const bool is_plain = names.have(value.name) || !names.in(value.value);
    const std::optional<ex> written = is_plain ? value.value : by_length(value.value, step, names, scope);
    if (!written) return std::nullopt;
    program.output(value.name, *written);
  }
  return program;
}

kind::Direction* direction_of(Step& step) {
  if (auto* const opposite = std::get_if<kind::Opposite>(&step.kind)) return opposite;
  return std::get_if<kind::Pair>(&step.kind);
}

/// True if the direction itself, not its length alone, decides what exists on a later step: next to noise it
/// has to be doubted, as no direction is that is left as long as it is.
bool decides_later(const Plan& plan, const Step& direction) {
  std::set<std::string> uncertain{names::cosine(direction.unknown), names::sine(direction.unknown)};
  for (const Step& step : plan.steps) {
    const std::vector<std::string> read = reads(step);
    const bool follows = std::any_of(read.begin(), read.end(),
                                     [&](const std::string& name) { return uncertain.count(name) > 0; });
    if (&step == &direction || !follows) continue;
    if (step.branches > 1 && step.wrist() == nullptr) return true;
    for (const Program::Step& value : step.after.steps()) uncertain.insert(value.name.get_name());
  }
  return false;
}

/// A wrist with oblique axes reads cosines and sines.
void halves_of_unit_length(Plan& plan) {
  for (Step& step : plan.steps)
    if (auto* const half = std::get_if<kind::Half>(&step.kind)) half->of_any_length = false;
}

}  // namespace

void spare_lengths(Plan& plan, const Scope& scope) {
  if (plan.has_oblique_wrist()) return halves_of_unit_length(plan);
  if (plan.quartic()) return;
  for (Step& step : plan.steps) {
    kind::Direction* const direction = direction_of(step);
    if (direction == nullptr) continue;
    const Names names(step);
    const bool halves_alone = std::all_of(plan.steps.begin(), plan.steps.end(), [&](const Step& other) {
      return &other == &step || other.is<kind::Half>() || !names.are_read_by(other);
    });
    if (!halves_alone || decides_later(plan, step)) continue;
    const std::optional<Program> after = by_length(step, names, scope);
    if (!after) continue;
    direction->unit = false;
    direction->length_known = !direction->length.is_zero();
    if (direction->length_known) step.before.output("length", direction->length);
    step.after = *after;
    for (Step& other : plan.steps)
      if (auto* const half = std::get_if<kind::Half>(&other.kind);
          half != nullptr && names.are_read_by(other))
        half->lengths.push_back(step.unknown);
  }
}

}  // namespace qvgen::derive::inverse
