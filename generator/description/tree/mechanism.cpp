// SPDX-License-Identifier: MIT
// A whole tree of links: which tips are meant, and the joints of all limbs together.
#include <algorithm>

#include "description/named_frames.h"
#include "description/names.h"
#include "description/tree/limbs.h"
#include "description/tree/loops.h"
#include "description/tree/moving_tree.h"
#include "description/tree/rods.h"
#include "description/tree/tree_reader.h"

namespace qvgen::description::tree {
namespace {

using Nodes = std::vector<Node>;

/// Returns what people mean by the end of each link behind which nothing moves, in the order of the file.
std::vector<std::size_t> all_tips(const Nodes& nodes, std::size_t base) {
  const MovingTree tree = moving_tree(nodes, base);
  std::vector<std::size_t> tips;
  for (std::size_t node = 0; node < nodes.size(); ++node)
    if (tree.joints[node] > 0 && nodes[node].moves && tree.height[node] == 0)
      tips.push_back(frame_of(nodes, node));
  return tips;
}

/// Returns the tip that an option names; reported if it is none.
std::optional<std::size_t> named_tip(Context& context, const Nodes& nodes, std::size_t base,
                                     const std::string& name, const std::string& kind) {
  const auto tip = find_node(context, nodes, name, "--tips", kind);
  if (!tip) return std::nullopt;
  const std::string told = "--tips " + name + ": the " + kind;
  const auto path = path_between(nodes, {base, *tip});
  if (!path)
    context.error({}, told + " does not hang on " + nodes[base].name, "choose another --base, or other tips");
  else if (std::none_of(path->begin(), path->end(), [&](std::size_t node) { return nodes[node].moves; }))
    context.error({}, told + " does not move against " + nodes[base].name, "leave it out");
  else
    return tip;
  return std::nullopt;
}

std::vector<std::size_t> named_tips(Context& context, const Nodes& nodes, std::size_t base,
                                    const std::string& kind) {
  std::vector<std::size_t> tips;
  for (const std::string& name : context.options.tips) {
    const auto tip = named_tip(context, nodes, base, name, kind);
    if (!tip) continue;
    if (std::find(tips.begin(), tips.end(), *tip) != tips.end())
      context.error({}, "--tips names " + name + " twice", "name each tip once");
    tips.push_back(*tip);
  }
  return tips;
}

/// Returns the links between the base and the tips, parents first, as the file orders them.
std::vector<std::size_t> links_to(const Nodes& nodes, std::size_t base,
                                  const std::vector<std::size_t>& tips) {
  std::vector<bool> is_meant(nodes.size(), false);
  for (const std::size_t tip : tips)
    for (std::size_t node = tip; node != base && !is_meant[node]; node = nodes[node].parent)
      is_meant[node] = true;
  std::vector<std::size_t> order, open{base};
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    if (node != base) order.push_back(node);
    for (auto child = nodes[node].children.rbegin(); child != nodes[node].children.rend(); ++child)
      if (is_meant[*child]) open.push_back(*child);
  }
  return order;
}

bool is_too_large(Context& context, const Nodes& nodes, std::size_t base,
                  const std::vector<std::size_t>& order) {
  const auto moving =
      std::count_if(order.begin(), order.end(), [&](std::size_t node) { return nodes[node].moves; });
  const std::string where = " behind " + nodes[base].name;
  if (moving > static_cast<long>(max_joints_of_tree))
    context.error(nodes[base].place, std::to_string(moving) + " joints" + where + " move",
                  "a robot has at most " + std::to_string(max_joints_of_tree) +
                      ": hold some with --fixed, or name fewer --tips");
  else if (order.size() > most_links)
    context.error(nodes[base].place, std::to_string(order.size()) + " links" + where,
                  "a robot has at most " + std::to_string(most_links));
  else
    return false;
  return true;
}

}  // namespace

model::Mechanism read_mechanism(Context& context, const Nodes& all, std::size_t base, const std::string& kind,
                                const ReadSegment& read_any, const ReadBody& read_body, const Loops& loops) {
  model::Mechanism result;
  const auto [nodes, closures, read, points] =
      loops.any ? take_rods(context, all, read_any, loops, loops.read(all)) : WithoutRods{all, {}, read_any};
  const auto& named = context.options.tips;
  const bool every = named.empty() || named == std::vector<std::string>{every_tip};
  const std::vector<std::size_t> tips =
      every ? all_tips(nodes, base) : named_tips(context, nodes, base, kind);
  if (context.has_error) return result;
  if (tips.empty())
    context.error(nodes[base].place, "nothing moves behind " + nodes[base].name,
                  "a robot has at least one revolute, continuous or prismatic joint");
  const std::vector<std::size_t> order = links_to(nodes, base, with_closures(nodes, base, closures, tips));
  if (tips.empty() || is_too_large(context, nodes, base, order)) return result;
  TreeReader reader(context, nodes, read, Node::none);
  if (read_body) {
    const auto ends = points.find(base);
    const Body body = read_body(base);
    result.robot.floating_base =
        reader.read_base(base, ends == points.end() ? body : joined(body, ends->second), order);
  }
  reader.read(order, result.robot);
  for (const std::size_t tip : tips) {
    model::Frame frame = reader.place_of(tip);
    frame.name = frame_identifier(frame.name, result.tips);
    result.tips.push_back(std::move(frame));
  }
  close_loops(context, nodes, reader, loops, closures, result);
  if (result.loops.empty()) reader.tie(result.robot);
  result.robot.title = tips.size() == 1 ? nodes[base].name + " to " + nodes[tips.front()].name
                                        : std::to_string(tips.size()) + " limbs from " + nodes[base].name;
  return result;
}

}  // namespace qvgen::description::tree
