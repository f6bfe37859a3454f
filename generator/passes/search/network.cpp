// SPDX-License-Identifier: MIT
#include "passes/search/network.h"

#include <cmath>

namespace qvgen::passes::search_detail {
namespace {

std::int32_t price(double cost) { return static_cast<std::int32_t>(std::lround(cost * Network::unit)); }

std::int32_t price(dag::Op op, const CostModel& cost) {
  switch (op) {
    case dag::Op::sum:
      return price(cost.addition);
    case dag::Op::product:
      return price(cost.multiplication);
    case dag::Op::quotient:
      return price(cost.division);
    case dag::Op::root:
      return price(cost.root);
    case dag::Op::arctangent:
      return price(cost.arctangent);
    default:
      return 0;
  }
}

Choice choice_of(const Classes& classes, const ENode& node, std::size_t index, const CostModel& cost) {
  Choice choice;
  choice.cost = price(node.op, cost);
  choice.node = static_cast<std::int32_t>(index);
  for (const Ref operand : {node.a, node.b}) {
    if (classes[operand.id].free) continue;
    if (choice.operand_count == 1 && choice.operands[0] == operand.id) continue;
    choice.operands[choice.operand_count++] = operand.id;
  }
  return choice;
}

Choice choice_of(const Leaf& leaf) {
  Choice choice;
  const bool circular = leaf.op == dag::Op::sine || leaf.op == dag::Op::cosine;
  if (circular) choice.angle = static_cast<std::int32_t>(leaf.angle);
  return choice;
}

}  // namespace

Network make_network(const Classes& classes, const AngleTable& angles, const std::vector<Ref>& outputs,
                     const CostModel& cost) {
  Network network;
  for (std::uint32_t id = 0; id < classes.size(); ++id) {
    network.first.push_back(static_cast<std::uint32_t>(network.choices.size()));
    const EClass& entry = classes[id];
    if (entry.free) continue;
    if (entry.leaf) network.choices.push_back(choice_of(*entry.leaf));
    for (std::size_t i = 0; i < entry.nodes.size(); ++i)
      network.choices.push_back(choice_of(classes, entry.nodes[i], i, cost));
  }
  network.first.push_back(static_cast<std::uint32_t>(network.choices.size()));
  for (const bool free : angles.free) network.angle_costs.push_back(free ? 0 : price(cost.sine_cosine));
  for (const Ref output : outputs)
    if (!classes[output.id].free) network.outputs.push_back(output.id);
  return network;
}

}  // namespace qvgen::passes::search_detail
