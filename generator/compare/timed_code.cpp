// SPDX-License-Identifier: MIT
#include "compare/timed_code.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "dag/rebuild.h"
#include "exact/named_constant.h"

namespace qvgen::compare {
namespace {

using dag::Edge;
using dag::Node;
using dag::Op;

std::string literal(double value) {
  const std::string text = fmt::format("{:#.17g}", value);
  return value < 0 ? "(" + text + ")" : text;
}

class Body {
 public:
  Body(const dag::Function& function, const dag::IsFree& is_free)
      : graph_(function.graph), is_free_(is_free) {
    for (const std::uint32_t id : dag::reachable(function)) write(id);
    for (const dag::Output& output : function.outputs)
      line(fmt::format("y[{}] = {};", code_.outputs++, operand(output.value)));
  }
  [[nodiscard]] TimedCode take() { return std::move(code_); }

 private:
  void line(const std::string& text) { code_.body += "  " + text + "\n"; }

  [[nodiscard]] bool is_free_angle(const dag::Angle& angle) const {
    return std::all_of(angle.terms.begin(), angle.terms.end(), [&](const auto& term) {
      return is_free_(term.first) || exact::named_value(term.first);
    });
  }
  [[nodiscard]] bool is_free(const Node& node) const {
    if (node.op == Op::symbol) return is_free_(graph_.symbol_of(node));
    if (node.op == Op::sine || node.op == Op::cosine) return is_free_angle(graph_.angle_of(node));
    return std::all_of(node.operands.begin(), node.operands.end(),
                       [&](Edge edge) { return free_.at(edge.node); });
  }
  std::string input(const std::string& name) {
    auto& names = code_.inputs;
    const auto place = std::find(names.begin(), names.end(), name);
    const std::string variable = fmt::format("x{}", place - names.begin());
    if (place == names.end()) {
      line(fmt::format("const double {} = x[{}];", variable, names.size()));
      names.push_back(name);
    }
    return variable;
  }
  std::string positive(std::uint32_t id) {
    const Node& node = graph_.node(id);
    if (node.op == Op::constant)
      return literal(cln::double_approx(exact::to_float(graph_.constant_of(node), cln::float_format(20))));
    if (node.op == Op::symbol) {
      const std::string& name = graph_.symbol_of(node);
      const auto value = exact::named_value(name);
      return value ? literal(cln::double_approx(*value)) : input(name);
    }
    return free_.at(id) ? input(fmt::format("number {}", id)) : fmt::format("v{}", id);
  }
  std::string operand(Edge edge) { return (edge.negative ? "-" : "") + positive(edge.node); }

  /// Sine and cosine of one angle by one name: compilers make one call of both.
  std::string angle_name(const dag::Angle& angle) {
    const auto [place, is_new] = angles_.emplace(exact::to_string(angle), angles_.size());
    const std::string name = fmt::format("a{}", place->second);
    if (!is_new) return name;
    std::string sum = literal(cln::double_approx(angle.pi) * 3.14159265358979323846);
    for (const auto& [symbol, coefficient] : angle.terms) {
      const auto value = exact::named_value(symbol);
      sum += fmt::format(" + {} * {}", literal(cln::double_approx(coefficient)),
                         value ? literal(cln::double_approx(*value)) : input(symbol));
    }
    line(fmt::format("const double {} = {};", name, sum));
    return name;
  }
  std::string joined(const Node& node, const std::string& sign) {
    std::string text;
    for (const Edge edge : node.operands)
      text += text.empty()                     ? operand(edge)
              : sign == " + " && edge.negative ? " - " + positive(edge.node)
                                               : sign + operand(edge);
    return text;
  }
  std::string value(const Node& node) {
    switch (node.op) {
      case Op::sine:
        return "std::sin(" + angle_name(graph_.angle_of(node)) + ")";
      case Op::cosine:
        return "std::cos(" + angle_name(graph_.angle_of(node)) + ")";
      case Op::sum:
        return joined(node, " + ");
      case Op::product:
        return joined(node, " * ");
      case Op::quotient:
        return operand(node.operands[0]) + " / " + operand(node.operands[1]);
      case Op::root:
        return "std::sqrt(" + operand(node.operands[0]) + ")";
      case Op::arctangent:
        return "std::atan2(" + operand(node.operands[0]) + ", " + operand(node.operands[1]) + ")";
      default:
        return {};
    }
  }
  void write(std::uint32_t id) {
    const Node& node = graph_.node(id);
    free_[id] = node.op == Op::constant || is_free(node);
    if (free_[id] || node.op == Op::symbol) return;
    const std::string text = value(node);
    line(fmt::format("const double v{} = {};", id, text));
  }

  const dag::Graph& graph_;
  const dag::IsFree& is_free_;
  TimedCode code_;
  std::map<std::uint32_t, bool> free_;
  std::map<std::string, std::size_t> angles_;
};

/// Times calls over a table of arguments, so that no call can use what the one before has computed. The order
/// of the functions turns by one each round; batches last some fifty microseconds.
constexpr const char* harness = R"(
static double table[64 * 4096], result[4096], sum;

static double nanoseconds(const Case& c, int calls) {
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < calls; ++i) {
    c.run(table + (i % 64) * c.inputs, result);
    sum += result[0];
  }
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin).count() / calls;
}

static double part(std::vector<double> all, double share) {
  std::sort(all.begin(), all.end());
  return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1) + 0.5)];
}

int main() {
  unsigned state = 1;
  for (double& x : table) x = 6.0 * ((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0 - 3.0;
  std::vector<std::vector<double>> times(count);
  std::vector<int> calls(count);
  for (int k = 0; k < count; ++k) calls[k] = 1 + static_cast<int>(50000 / nanoseconds(cases[k], 64));
  for (int round = 0; round < rounds; ++round)
    for (int i = 0; i < count; ++i) {
      const int k = (round + i) % count;
      times[k].push_back(nanoseconds(cases[k], calls[k]));
    }
  for (const auto& all : times) std::printf("%.6g %.6g %.6g\n", part(all, 0.5), part(all, 0.25), part(all, 0.75));
  return sum == 0.12345 ? 1 : 0;
}
)";

}  // namespace

TimedCode timed_code(const dag::Function& function, const dag::IsFree& is_free) {
  return Body(function, is_free).take();
}

std::string cpp_function(const TimedCode& code, const std::string& name) {
  return fmt::format("__attribute__((noinline)) static void {}(const double* x, double* y) {{\n{}}}\n", name,
                     code.body);
}

std::string timing_program(const std::vector<TimedCode>& codes, int rounds) {
  std::string text =
      "#include <algorithm>\n#include <chrono>\n#include <cmath>\n#include <cstdio>\n#include <vector>\n";
  std::string cases;
  for (std::size_t k = 0; k < codes.size(); ++k) {
    text += cpp_function(codes[k], fmt::format("f{}", k));
    cases += fmt::format("{{f{}, {}}}, ", k, codes[k].inputs.size());
  }
  return text + "struct Case { void (*run)(const double*, double*); int inputs; };\n" +
         fmt::format("static const Case cases[] = {{{}}};\nconstexpr int count = {}, rounds = {};\n", cases,
                     codes.size(), rounds) +
         harness;
}

}  // namespace qvgen::compare
