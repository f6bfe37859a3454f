// SPDX-License-Identifier: MIT
// Options choose from a tree of links: a chain or all of it, with some joints held.
#include <algorithm>
#include <set>

#include "description/names.h"
#include "description/tree/tree.h"

namespace qvgen::description::tree {
namespace {

/// Returns the nodes with the joints of --fixed held; those that the file has not are reported.
std::vector<Node> with_fixed_joints(Context& context, std::vector<Node> nodes) {
  const std::set<std::string> fixed(context.options.fixed.begin(), context.options.fixed.end());
  std::set<std::string> found;
  std::vector<std::string> names;
  for (Node& node : nodes) {
    if (node.joint.empty() || !node.moves) continue;
    names.push_back(node.joint);
    if (fixed.count(node.joint) == 0) continue;
    node.moves = false;
    found.insert(node.joint);
  }
  for (const std::string& name : fixed) {
    if (found.count(name) != 0) continue;
    const std::string near = names.size() < many_names ? nearest(name, names) : "";
    context.error({}, "--fixed " + name + ": no joint of that name moves",
                  near.empty() ? "name a joint of the file" : "did you mean '" + near + "'?");
  }
  return nodes;
}

/// The position at zero of a joint that is held.
Segment held(Segment segment) {
  segment.joint.reset();
  return segment;
}

/// Returns the body that a file lets float, else the base.
std::size_t floating_body(Context& context, const std::vector<Node>& nodes, std::size_t base) {
  if (!context.options.base.empty()) return base;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].is_free) found.push_back(i);
  if (found.size() > 1)
    context.error(nodes[found[1]].place,
                  "--floating: '" + nodes[found[0]].name + "' and '" + nodes[found[1]].name + "' are free",
                  "choose one: --base " + nodes[found[0]].name);
  return found.empty() ? base : found.front();
}

model::Mechanism read_whole(Context& context, const std::vector<Node>& nodes, const std::string& kind,
                            const ReadSegment& read, const ReadBody& read_body, const Loops& loops) {
  const auto root = find_base(context, nodes, kind);
  if (!root) return {};
  const bool floats = context.options.floating;
  const std::size_t base = floats ? floating_body(context, nodes, *root) : *root;
  if (context.has_error) return {};
  return read_mechanism(context, nodes, base, kind, read, floats ? read_body : ReadBody{}, loops);
}

}  // namespace

bool takes_loops(const ReadOptions& options) { return options.tip.empty(); }

model::Mechanism read_tree(Context& context, const std::vector<Node>& described, const std::string& kind,
                           const std::string& title, const ReadSegment& read, const ReadBody& read_body,
                           const Loops& loops) {
  model::Mechanism result;
  const std::vector<Node> nodes = with_fixed_joints(context, described);
  if (context.has_error) return result;
  const ReadSegment read_unfixed = [&](std::size_t node) {
    std::optional<Segment> segment = read(node);
    const bool is_held = described[node].moves && !nodes[node].moves;
    return segment && is_held ? held(std::move(*segment)) : segment;
  };
  const bool closes = loops.any && takes_loops(context.options);
  if (loops.any && !closes) loops.leave_out();
  if (!closes && context.options.tips.empty() && !context.options.floating) {
    const auto ends = find_ends(context, nodes, kind);
    if (!ends) return result;
    result.robot.title = title + ", " + nodes[ends->base].name + " to " + nodes[ends->tip].name;
    read_chain(context, nodes, *ends, read_unfixed, result.robot);
    return result;
  }
  result = read_whole(context, nodes, kind, read_unfixed, read_body, closes ? loops : Loops{});
  result.robot.title = title + ", " + result.robot.title;
  return result;
}

}  // namespace qvgen::description::tree
