// SPDX-License-Identifier: MIT
#include "verify/same_pose.h"

#include <cln/float.h>

#include "derive/kinematics/forward_kinematics.h"
#include "exact/constant_angle.h"
#include "exact/named_constant.h"
#include "exact/point.h"
#include "symbolic/model.h"
#include "verify/certificate.h"

namespace qvgen::verify {
namespace {

using GiNaC::ex;

constexpr int points = 2;
constexpr long digits = 70;
constexpr double tolerance = 1e-34;

/// GiNaC's number of digits is a global of the process: set while a pose is computed, and put back.
class Digits {
 public:
  Digits() : before_(GiNaC::Digits) { GiNaC::Digits = digits; }
  ~Digits() { GiNaC::Digits = before_; }
  Digits(const Digits&) = delete;
  Digits& operator=(const Digits&) = delete;

 private:
  long before_;
};

/// Values of the symbols at a random point.
class DecimalPoint : public GiNaC::map_function {
 public:
  DecimalPoint(int seed, const canonical::Definitions& definitions)
      : point_(static_cast<std::uint64_t>(seed)), definitions_(definitions) {}

  void set(const std::string& name, const ex& value) { known_[symbolic::symbol(name)] = value; }
  void set(const ex& symbol, const ex& value) { known_[symbol] = value; }
  [[nodiscard]] ex random(const std::string& name) const {
    return GiNaC::numeric(point_.symbol(name).rational());
  }

  ex operator()(const ex& e) override {
    if (!GiNaC::is_a<GiNaC::symbol>(e)) return e.map(*this);
    const auto place = known_.find(e);
    if (place != known_.end()) return place->second;
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(e).get_name();
    const auto definition = definitions_.find(name);
    ex value;
    if (const auto constant = exact::named_value(name))
      value = GiNaC::numeric(*constant);
    else if (definition != definitions_.end())
      value = (*this)(symbolic::to_symbolic(definition->second)).evalf();
    else
      value = GiNaC::abs(random(name));
    known_[e] = value;
    return value;
  }

 private:
  exact::ExactPoint point_;
  const canonical::Definitions& definitions_;
  GiNaC::exmap known_;
};

std::vector<GiNaC::numeric> values(const symbolic::Program& program, DecimalPoint point) {
  for (const auto& step : program.steps()) point.set(step.name, point(step.value).evalf());
  std::vector<GiNaC::numeric> result;
  for (const auto& output : program.outputs())
    result.push_back(GiNaC::ex_to<GiNaC::numeric>(point(output.value).evalf()));
  return result;
}

}  // namespace

void certify_same_pose(const model::Robot& described, const canonical::Arm& arm) {
  const Digits restored;
  const symbolic::Program expected = derive::plain_transform(described);
  const symbolic::Program found = derive::plain_transform(arm.robot);
  for (int k = 1; k <= points; ++k) {
    DecimalPoint at(k, arm.robot.definitions);
    DecimalPoint canonical_at(k, arm.robot.definitions);
    for (std::size_t i = 0; i < arm.phases.size(); ++i) {
      const std::string& variable = arm.robot.joints[i].variable;
      const ex value = at.random(variable);
      at.set(variable, value);
      canonical_at.set(
          variable, (arm.is_reversed(i) ? -value : value) + GiNaC::numeric(*exact::radians(arm.phases[i])));
    }
    const auto wanted = values(expected, at);
    const auto has = values(found, canonical_at);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const double off = GiNaC::abs(wanted[i] - has[i]).to_double();
      const double size = 1 + GiNaC::abs(wanted[i]).to_double();
      if (!(off <= tolerance * size))
        throw CertificateError("forward kinematics: " + expected.outputs()[i].name +
                               " of the canonical arm differs from the description's");
    }
  }
}

}  // namespace qvgen::verify
