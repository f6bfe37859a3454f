// SPDX-License-Identifier: MIT
#include <algorithm>

#include "description/names.h"
#include "description/tree/tree.h"

namespace qvgen::description::tree {
namespace {

std::string list(const std::vector<Node>& nodes, const std::vector<std::size_t>& which) {
  static constexpr std::size_t shown = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, which.size()); ++i)
    text += (i == 0 ? "" : ", ") + nodes[which[i]].name;
  if (which.size() > shown) text += " and " + std::to_string(which.size() - shown) + " more";
  return text;
}

/// For each node, whether something moves behind it.
std::vector<bool> carrying(const std::vector<Node>& nodes) {
  std::vector<bool> carries(nodes.size(), false);
  for (const Node& node : nodes)
    for (std::size_t before = node.moves ? node.parent : Node::none; before != Node::none && !carries[before];
         before = nodes[before].parent)
      carries[before] = true;
  return carries;
}

/// The root of all links, or the only one behind which links move: the others are scenery.
std::optional<std::size_t> only_root(Context& context, const std::vector<Node>& nodes,
                                     const std::string& kind) {
  const std::vector<bool> carries = carrying(nodes);
  std::vector<std::size_t> roots, moving, others;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent != Node::none) continue;
    roots.push_back(i);
    (carries[i] ? moving : others).push_back(i);
  }
  if (roots.size() == 1) return roots.front();
  if (moving.size() == 1) {
    context.warning(
        nodes[others.front()].place,
        "nothing moves behind " + list(nodes, others) + ", apart from the other " + kind + "s: left out",
        "join them to " + nodes[moving.front()].name + ", or choose with --base");
    return moving.front();
  }
  context.error(nodes[roots[1]].place, "the " + kind + "s hang on more than one root: " + list(nodes, roots),
                "join them, or say which with --base");
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> find_node(Context& context, const std::vector<Node>& nodes,
                                     const std::string& name, const std::string& option,
                                     const std::string& kind) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].name == name) return i;
    if (i < many_names) names.push_back(nodes[i].name);
  }
  const std::string near = nearest(name, names);
  context.error({}, option + " " + name + ": there is no " + kind + " of that name",
                near.empty() ? "name a " + kind + " of the file" : "did you mean '" + near + "'?");
  return std::nullopt;
}

std::optional<std::size_t> find_base(Context& context, const std::vector<Node>& nodes,
                                     const std::string& kind) {
  const std::string& base = context.options.base;
  return base.empty() ? only_root(context, nodes, kind) : find_node(context, nodes, base, "--base", kind);
}

std::optional<Ends> find_ends(Context& context, const std::vector<Node>& nodes, const std::string& kind) {
  const ReadOptions& options = context.options;
  const auto base =
      options.base.empty() ? std::nullopt : find_node(context, nodes, options.base, "--base", kind);
  const auto tip = options.tip.empty() ? std::nullopt : find_node(context, nodes, options.tip, "--tip", kind);
  if ((!options.base.empty() && !base) || (!options.tip.empty() && !tip)) return std::nullopt;
  Ends ends;
  if (base) {
    ends.base = *base;
  } else if (tip) {
    for (ends.base = *tip; nodes[ends.base].parent != Node::none;) ends.base = nodes[ends.base].parent;
  } else if (const auto root = only_root(context, nodes, kind)) {
    ends.base = *root;
  } else {
    return std::nullopt;
  }
  const auto end = tip ? tip : likely_tip(context, nodes, ends.base);
  if (!end) return std::nullopt;
  ends.tip = *end;
  if (path_between(nodes, ends)) return ends;
  const std::string names = nodes[ends.tip].name + " does not hang on " + nodes[ends.base].name;
  const bool swapped = path_between(nodes, {ends.tip, ends.base}).has_value();
  context.error({}, names,
                swapped ? "swap --base and --tip" : "choose a --tip that joints connect with the --base");
  return std::nullopt;
}

std::optional<std::vector<std::size_t>> path_between(const std::vector<Node>& nodes, Ends ends) {
  std::vector<std::size_t> path;
  for (std::size_t node = ends.tip; node != ends.base; node = nodes[node].parent) {
    if (node == Node::none) return std::nullopt;
    path.push_back(node);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace qvgen::description::tree
