// SPDX-License-Identifier: MIT
#include "identify/tape.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "dag/evaluate.h"
#include "dag/rebuild.h"
#include "exact/constant_angle.h"
#include "exact/named_constant.h"

namespace qvgen::identify {
namespace {

double radians(const dag::Angle& angle, const Known& known) {
  double sum = exact::Number(angle.pi).to_double() * std::numbers::pi;
  for (const auto& [name, factor] : angle.terms)
    sum += exact::Number(factor).to_double() * value_of_symbol(name, known);
  return sum;
}

/// Leaves of a function without inputs (dag/evaluate.h).
struct Numbers {
  const Known& known;

  [[nodiscard]] double constant(const exact::Number& value) const { return value.to_double(); }
  [[nodiscard]] double symbol(const std::string& name) const { return value_of_symbol(name, known); }
  [[nodiscard]] double sine(const dag::Angle& angle) const { return std::sin(radians(angle, known)); }
  [[nodiscard]] double cosine(const dag::Angle& angle) const { return std::cos(radians(angle, known)); }
  [[nodiscard]] double root(double value) const { return std::sqrt(value); }
  [[nodiscard]] double arctangent(double y, double x) const { return std::atan2(y, x); }
};

}  // namespace

double value_of_symbol(const std::string& name, const Known& known) {
  if (const auto place = known.find(name); place != known.end()) return place->second;
  if (const auto constant = exact::named_value(name)) return exact::Number(*constant).to_double();
  if (const auto angle = exact::constant_angle(name))
    return exact::Number(exact::radians(*angle)).to_double();
  throw std::runtime_error(name + " has no value; write one under [defaults]");
}

std::vector<double> values_of(const dag::Function& function, const Known& known) {
  return dag::evaluate<double>(function, Numbers{known});
}

/// Goes through the graph once: gives every value a slot, and a slot back after the last use of its value.
class Tape::Compiler {
 public:
  Compiler(Tape& tape, const dag::Function& function, const std::vector<std::string>& inputs,
           const Known& known)
      : tape_(tape),
        function_(function),
        graph_(function.graph),
        known_(known),
        order_(dag::reachable(function)) {
    for (const std::string& input : inputs) inputs_.emplace(input, new_slot());
    count_uses();
    slot_.resize(graph_.size());
    for (const std::uint32_t id : order_) compile(id);
    for (const dag::Output& output : function_.outputs)
      tape_.outputs_.push_back(
          {slot_[output.value.node], output.value.negative, graph_.is_zero(output.value)});
  }

 private:
  void count_uses() {
    uses_.resize(graph_.size());
    for (const std::uint32_t id : order_)
      for (const dag::Edge& operand : graph_.node(id).operands) ++uses_[operand.node];
    for (const dag::Output& output : function_.outputs) ++uses_[output.value.node];  // never given back
  }

  std::uint32_t new_slot() { return static_cast<std::uint32_t>(tape_.slots_++); }

  std::uint32_t temporary() {
    if (free_.empty()) return new_slot();
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    return slot;
  }

  std::uint32_t constant(double value) {
    tape_.constants_.emplace_back(new_slot(), value);
    return tape_.constants_.back().first;
  }

  void emit(Kind kind, std::uint32_t to, std::uint32_t a, std::uint32_t b = 0) {
    tape_.instructions_.push_back({kind, to, a, b});
  }

  void compile(std::uint32_t id) {
    const dag::Node& node = graph_.node(id);
    if (node.op == dag::Op::constant)
      slot_[id] = constant(graph_.constant_of(node).to_double());
    else if (node.op == dag::Op::symbol)
      slot_[id] = symbol(graph_.symbol_of(node));
    else
      operation(id, node);
  }

  std::uint32_t symbol(const std::string& name) {
    const auto place = inputs_.find(name);
    return place != inputs_.end() ? place->second : constant(value_of_symbol(name, known_));
  }

  /// The result never has the slot of an operand that is read after it is written: operands go back later.
  void operation(std::uint32_t id, const dag::Node& node) {
    slot_[id] = temporary();
    if (node.op == dag::Op::sine || node.op == dag::Op::cosine)
      emit(node.op == dag::Op::sine ? Kind::sine : Kind::cosine, slot_[id], angle(graph_.angle_of(node)));
    else if (node.op == dag::Op::sum)
      sum(slot_[id], node.operands);
    else if (node.op == dag::Op::product)
      product(slot_[id], node.operands);
    else
      other(slot_[id], node);
    for (const dag::Edge& operand : node.operands) give_back(operand.node);
  }

  void give_back(std::uint32_t id) {
    const dag::Op op = graph_.node(id).op;
    if (--uses_[id] == 0 && op != dag::Op::constant && op != dag::Op::symbol) free_.push_back(slot_[id]);
  }

  std::uint32_t angle(const dag::Angle& angle) {
    Angle result;
    result.constant = exact::Number(angle.pi).to_double() * std::numbers::pi;
    for (const auto& [name, factor] : angle.terms) {
      const double times = exact::Number(factor).to_double();
      if (const auto place = inputs_.find(name); place != inputs_.end())
        result.terms.emplace_back(place->second, times);
      else
        result.constant += times * value_of_symbol(name, known_);
    }
    tape_.angles_.push_back(std::move(result));
    return static_cast<std::uint32_t>(tape_.angles_.size() - 1);
  }

  void sum(std::uint32_t to, const std::vector<dag::Edge>& operands) {
    const dag::Edge &a = operands[0], &b = operands[1];
    if (a.negative == b.negative)
      emit(a.negative ? Kind::minus_sum : Kind::add, to, slot_[a.node], slot_[b.node]);
    else
      emit(Kind::subtract, to, slot_[(a.negative ? b : a).node], slot_[(a.negative ? a : b).node]);
    for (std::size_t i = 2; i < operands.size(); ++i)
      emit(operands[i].negative ? Kind::subtract : Kind::add, to, to, slot_[operands[i].node]);
  }

  void product(std::uint32_t to, const std::vector<dag::Edge>& operands) {
    emit(Kind::multiply, to, slot_[operands[0].node], slot_[operands[1].node]);
    for (std::size_t i = 2; i < operands.size(); ++i) emit(Kind::multiply, to, to, slot_[operands[i].node]);
    bool negative = false;
    for (const dag::Edge& operand : operands) negative ^= operand.negative;
    if (negative) emit(Kind::negate, to, to);
  }

  /// Slot of a value with its sign; a negative one gets a slot that is never given back.
  std::uint32_t signed_slot(dag::Edge edge) {
    if (!edge.negative) return slot_[edge.node];
    const std::uint32_t slot = new_slot();
    emit(Kind::negate, slot, slot_[edge.node]);
    return slot;
  }

  void other(std::uint32_t to, const dag::Node& node) {
    const std::uint32_t a = signed_slot(node.operands[0]);
    if (node.op == dag::Op::root) return emit(Kind::root, to, a);
    emit(node.op == dag::Op::quotient ? Kind::divide : Kind::arctangent, to, a,
         signed_slot(node.operands[1]));
  }

  Tape& tape_;
  const dag::Function& function_;
  const dag::Graph& graph_;
  const Known& known_;
  std::vector<std::uint32_t> order_, slot_, free_;
  std::vector<std::uint32_t> uses_;
  std::map<std::string, std::uint32_t> inputs_;
};

Tape::Tape(const dag::Function& function, const std::vector<std::string>& inputs, const Known& known) {
  Compiler(*this, function, inputs, known);
}

std::vector<double> Tape::workspace() const {
  std::vector<double> values(slots_ * block);
  for (const auto& [slot, value] : constants_) std::fill_n(values.data() + slot * block, block, value);
  return values;
}

void Tape::turn(const Angle& angle, bool sine, const double* values, double* to) const {
  std::fill_n(to, block, angle.constant);
  for (const auto& [slot, factor] : angle.terms)
    for (std::size_t i = 0; i < block; ++i) to[i] += factor * values[slot * block + i];
  for (std::size_t i = 0; i < block; ++i) to[i] = sine ? std::sin(to[i]) : std::cos(to[i]);
}

namespace {

template <class Operation>
void each(double* to, const double* a, const double* b, const Operation& operation) {
  for (std::size_t i = 0; i < Tape::block; ++i) to[i] = operation(a[i], b[i]);
}

}  // namespace

void Tape::run(const Instruction& instruction, double* values) const {
  double* to = values + instruction.to * block;
  if (instruction.kind == Kind::sine || instruction.kind == Kind::cosine)
    return turn(angles_[instruction.a], instruction.kind == Kind::sine, values, to);
  const double* a = values + instruction.a * block;
  const double* b = values + instruction.b * block;
  switch (instruction.kind) {
    case Kind::add:
      return each(to, a, b, [](double x, double y) { return x + y; });
    case Kind::subtract:
      return each(to, a, b, [](double x, double y) { return x - y; });
    case Kind::minus_sum:
      return each(to, a, b, [](double x, double y) { return -x - y; });
    case Kind::multiply:
      return each(to, a, b, [](double x, double y) { return x * y; });
    case Kind::divide:
      return each(to, a, b, [](double x, double y) { return x / y; });
    case Kind::negate:
      return each(to, a, a, [](double x, double) { return -x; });
    case Kind::root:
      return each(to, a, a, [](double x, double) { return std::sqrt(x); });
    default:
      return each(to, a, b, [](double x, double y) { return std::atan2(x, y); });
  }
}

void Tape::run(std::vector<double>& workspace) const {
  for (const Instruction& instruction : instructions_) run(instruction, workspace.data());
}

void Tape::copy(const std::vector<double>& workspace, std::size_t output, std::size_t count,
                double* to) const {
  const Output& from = outputs_[output];
  const double sign = from.negative ? -1 : 1;
  for (std::size_t i = 0; i < count; ++i) to[i] = sign * workspace[from.slot * block + i];
}

}  // namespace qvgen::identify
