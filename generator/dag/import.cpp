// SPDX-License-Identifier: MIT
#include "dag/import.h"

#include <map>
#include <sstream>
#include <stdexcept>

#include "dag/evaluate.h"
#include "dag/rebuild.h"
#include "symbolic/evaluate.h"
#include "symbolic/model.h"

namespace qvgen::dag {
namespace {

using GiNaC::ex;

[[noreturn]] void refuse(const std::string& what, const ex& expression) {
  std::ostringstream text;
  text << what << ": " << expression;
  throw std::domain_error(text.str());
}

/// Imports expressions into one graph, each only once.
class Importer {
 public:
  explicit Importer(Graph& graph) : graph_(graph) {}

  void bind(const GiNaC::symbol& name, Edge value) { known_[name] = value; }

  Edge edge(const ex& expression) {
    const auto place = known_.find(expression);
    if (place != known_.end()) return place->second;
    const Edge made = make(expression);
    known_.emplace(expression, made);
    return made;
  }

 private:
  Edge make(const ex& e) {
    if (GiNaC::is_a<GiNaC::numeric>(e)) return graph_.constant(symbolic::to_rational(e));
    if (GiNaC::is_a<GiNaC::symbol>(e)) return graph_.symbol(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
    if (e.is_equal(GiNaC::Pi)) return graph_.symbol("pi");
    if (GiNaC::is_a<GiNaC::add>(e)) return graph_.sum(operands(e));
    if (GiNaC::is_a<GiNaC::mul>(e)) return product(e);
    if (GiNaC::is_a<GiNaC::power>(e)) return power(e.op(0), e.op(1));
    if (GiNaC::is_a<GiNaC::function>(e)) return function(e);
    refuse("cannot be generated", e);
  }

  std::vector<Edge> operands(const ex& e) {
    std::vector<Edge> edges;
    for (const ex& operand : e) edges.push_back(edge(operand));
    return edges;
  }

  /// A product with its negative powers gathered into one denominator.
  Edge product(const ex& e) {
    std::vector<Edge> above;
    std::vector<Edge> below;
    for (const ex& factor : e) {
      const bool divides =
          GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::negative);
      if (divides)
        below.push_back(power(factor.op(0), -factor.op(1)));
      else
        above.push_back(edge(factor));
    }
    const Edge numerator = graph_.product(std::move(above));
    return below.empty() ? numerator : graph_.quotient(numerator, graph_.product(std::move(below)));
  }

  Edge power(const ex& base, const ex& exponent) {
    if (!GiNaC::is_a<GiNaC::numeric>(exponent))
      refuse("exponent is not a number", GiNaC::pow(base, exponent));
    const GiNaC::numeric n = GiNaC::ex_to<GiNaC::numeric>(exponent);
    if (n.is_negative()) return graph_.quotient(graph_.constant(1), power(base, -exponent));
    const GiNaC::numeric doubled = n * 2;
    if (!doubled.is_integer()) refuse("exponent is neither whole nor half", GiNaC::pow(base, exponent));
    const Edge root = n.is_integer() ? edge(base) : graph_.root(edge(base));
    return graph_.product(
        std::vector<Edge>(static_cast<std::size_t>((n.is_integer() ? n : doubled).to_int()), root));
  }

  Edge function(const ex& e) {
    if (GiNaC::is_the_function<GiNaC::sin_SERIAL>(e)) return graph_.sine(symbolic::to_angle(e.op(0)));
    if (GiNaC::is_the_function<GiNaC::cos_SERIAL>(e)) return graph_.cosine(symbolic::to_angle(e.op(0)));
    if (GiNaC::is_the_function<GiNaC::atan2_SERIAL>(e))
      return graph_.arctangent(edge(e.op(0)), edge(e.op(1)));
    refuse("function cannot be generated", e);
  }

  Graph& graph_;
  std::map<ex, Edge, GiNaC::ex_is_less> known_;
};

/// Leaves of a graph as GiNaC writes them.
struct SymbolicLeaves {
  const std::map<std::string, ex>& known;

  [[nodiscard]] ex constant(const exact::Number& value) const { return GiNaC::numeric(value.rational()); }
  [[nodiscard]] ex symbol(const std::string& name) const {
    const auto place = known.find(name);
    return place != known.end() ? place->second : ex(symbolic::symbol(name));
  }
  static ex argument(const Angle& angle) {
    ex sum = GiNaC::numeric(angle.pi) * GiNaC::Pi;
    for (const auto& [name, coefficient] : angle.terms)
      sum += GiNaC::numeric(coefficient) * symbolic::symbol(name);
    return sum;
  }
  [[nodiscard]] ex sine(const Angle& angle) const { return GiNaC::sin(argument(angle)); }
  [[nodiscard]] ex cosine(const Angle& angle) const { return GiNaC::cos(argument(angle)); }
  [[nodiscard]] ex root(const ex& value) const { return GiNaC::sqrt(value); }
  [[nodiscard]] ex arctangent(const ex& y, const ex& x) const { return GiNaC::atan2(y, x); }
};

}  // namespace

Function import(const symbolic::Program& program) {
  Function function;
  Importer importer(function.graph);
  for (const auto& step : program.steps()) importer.bind(step.name, importer.edge(step.value));
  for (const auto& output : program.outputs())
    function.outputs.push_back({output.name, importer.edge(output.value)});
  return rebuild(function);
}

std::vector<ex> to_symbolic(const Function& function, const std::map<std::string, ex>& known) {
  return evaluate<ex>(function, SymbolicLeaves{known});
}

}  // namespace qvgen::dag
