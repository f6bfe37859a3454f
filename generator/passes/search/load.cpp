// SPDX-License-Identifier: MIT
#include "passes/search/load.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "dag/counts.h"

namespace qvgen::passes::search_detail {
namespace {

constexpr std::size_t all_orders = 4;

Ref binary(Classes& classes, dag::Op op, Ref a, Ref b) {
  return op == dag::Op::sum ? classes.sum(a, b) : classes.product(a, b);
}

/// Every subset of the operands becomes a class with every split into two.
Ref combine_few(Classes& classes, dag::Op op, const std::vector<Ref>& operands) {
  const unsigned full = (1U << operands.size()) - 1;
  std::vector<Ref> subset(full + 1);
  for (unsigned mask = 1; mask <= full; ++mask) {
    const unsigned lowest = mask & (~mask + 1);
    if (mask == lowest) subset[mask] = operands[static_cast<std::size_t>(std::countr_zero(mask))];
    for (unsigned part = (mask - 1) & mask; part != 0; part = (part - 1) & mask)
      if ((part & lowest) == 0) subset[mask] = binary(classes, op, subset[mask ^ part], subset[part]);
  }
  return subset[full];
}

}  // namespace

Ref combine(Classes& classes, dag::Op op, const std::vector<Ref>& operands) {
  if (operands.size() <= all_orders) return combine_few(classes, op, operands);
  std::vector<Ref> groups;
  for (std::size_t begin = 0; begin < operands.size(); begin += all_orders) {
    const auto first = operands.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last =
        operands.begin() + static_cast<std::ptrdiff_t>(std::min(operands.size(), begin + all_orders));
    groups.push_back(combine_few(classes, op, {first, last}));
  }
  return combine(classes, op, groups);
}

std::uint32_t AngleTable::index(const dag::Angle& angle, bool is_free) {
  const auto place = std::find(angles.begin(), angles.end(), angle);
  if (place == angles.end()) {
    angles.push_back(angle);
    free.push_back(is_free);
    return static_cast<std::uint32_t>(angles.size() - 1);
  }
  return static_cast<std::uint32_t>(place - angles.begin());
}

Loader::Loader(Classes& classes, Fingerprint& fingerprint, AngleTable& angles,
               std::function<bool(const std::string&)> is_free)
    : classes_(classes), fingerprint_(fingerprint), angles_(angles), is_free_symbol_(std::move(is_free)) {}

std::map<std::string, Ref> Loader::load(const dag::Function& form) {
  done_.assign(form.graph.size(), std::nullopt);
  std::map<std::string, Ref> outputs;
  for (const dag::Output& output : form.outputs) outputs[output.name] = visit(form.graph, output.value);
  return outputs;
}

Ref Loader::visit(const dag::Graph& graph, dag::Edge edge) {
  std::optional<Ref>& known = done_[edge.node];
  if (!known) {
    const dag::Node& node = graph.node(edge);
    const Ref made = node.operands.empty() ? make_leaf(graph, node) : make(graph, node);
    done_[edge.node] = made;
    return made.signed_by(edge.negative);
  }
  return known->signed_by(edge.negative);
}

Ref Loader::make(const dag::Graph& graph, const dag::Node& node) {
  std::vector<Ref> operands;
  for (const dag::Edge operand : node.operands) operands.push_back(visit(graph, operand));
  switch (node.op) {
    case dag::Op::sum:
    case dag::Op::product:
      return combine(classes_, node.op, operands);
    case dag::Op::quotient:
      return classes_.quotient(operands[0], operands[1]);
    default:
      break;
  }
  const Ref a = operands.front();
  const Ref b = operands.back();
  const char* name = node.op == dag::Op::root ? "root" : "arctangent";
  return classes_.opaque(node.op, a, b, fingerprint_.opaque(name, classes_.value(a), classes_.value(b)));
}

Ref Loader::make_leaf(const dag::Graph& graph, const dag::Node& node) {
  if (node.op == dag::Op::constant) {
    const exact::Number& number = graph.constant_of(node);
    return classes_.leaf({node.op, number, {}, 0, false}, fingerprint_.number(number), true);
  }
  if (node.op == dag::Op::symbol) {
    const std::string& name = graph.symbol_of(node);
    return classes_.leaf({node.op, {}, name, 0, false}, fingerprint_.symbol(name),
                         is_free_symbol_ && is_free_symbol_(name));
  }
  const dag::Angle& angle = graph.angle_of(node);
  const CosineSine values = fingerprint_.circular(angle);
  const bool free = dag::is_free(angle, is_free_symbol_);
  const std::uint32_t index = angles_.index(angle, free);
  return classes_.leaf({node.op, {}, {}, index, false},
                       node.op == dag::Op::sine ? values.sine : values.cosine, free);
}

}  // namespace qvgen::passes::search_detail
