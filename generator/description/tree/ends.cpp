// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "description/names.h"
#include "description/tree/tree.h"

namespace qvgen::description::tree {
namespace {

/// What tips are called, by makers and by ROS-Industrial; the first that a file has is meant.
constexpr std::array tip_names{"tool0", "tool",    "tcp",    "tool_link", "ee_link",    "end_effector",
                               "ee",    "link_ee", "flange", "hand_tcp",  "tool_frame", "attachment_site"};

/// Beyond this many names a list helps nobody, and looking for the nearest one takes too long.
constexpr std::size_t many = 1000;

std::string list(const std::vector<Node>& nodes, const std::vector<std::size_t>& which) {
  static constexpr std::size_t shown = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, which.size()); ++i)
    text += (i == 0 ? "" : ", ") + nodes[which[i]].name;
  if (which.size() > shown) text += " and " + std::to_string(which.size() - shown) + " more";
  return text;
}

std::optional<std::size_t> find(Context& context, const std::vector<Node>& nodes, const std::string& name,
                                const std::string& option, const std::string& kind) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].name == name) return i;
    if (i < many) names.push_back(nodes[i].name);
  }
  const std::string near = nearest(name, names);
  context.error({}, option + " " + name + ": there is no " + kind + " of that name",
                near.empty() ? "name a " + kind + " of the file" : "did you mean '" + near + "'?");
  return std::nullopt;
}

std::optional<std::size_t> only_root(Context& context, const std::vector<Node>& nodes,
                                     const std::string& kind) {
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].parent == Node::none) roots.push_back(i);
  if (roots.size() == 1) return roots.front();
  context.error(nodes[roots[1]].place, "the " + kind + "s hang on more than one root: " + list(nodes, roots),
                "join them, or say which with --base");
  return std::nullopt;
}

/// Nodes that a moving joint separates from the base, in the order of the file.
std::vector<std::size_t> moved_by(const std::vector<Node>& nodes, std::size_t base) {
  std::vector<std::size_t> result;
  std::vector<std::pair<std::size_t, bool>> open{{base, false}};
  while (!open.empty()) {
    const auto [node, moves] = open.back();
    open.pop_back();
    if (moves) result.push_back(node);
    for (const std::size_t child : nodes[node].children)
      open.emplace_back(child, moves || nodes[child].moves);
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool is_leaf(const std::vector<Node>& nodes, std::size_t node) {
  const auto& children = nodes[node].children;
  return !nodes[node].is_marker && std::all_of(children.begin(), children.end(),
                                               [&](std::size_t child) { return nodes[child].is_marker; });
}

std::optional<std::size_t> likely_tip(Context& context, const std::vector<Node>& nodes, std::size_t base,
                                      const std::string& kind) {
  const auto moved = moved_by(nodes, base);
  if (moved.empty()) {
    context.error(nodes[base].place, "no joint between " + nodes[base].name + " and the tips moves",
                  "an arm has at least one revolute, continuous or prismatic joint");
    return std::nullopt;
  }
  for (const std::string name : tip_names)
    for (const std::size_t node : moved)
      if (nodes[node].name == name) return node;
  std::vector<std::size_t> leaves;
  std::copy_if(moved.begin(), moved.end(), std::back_inserter(leaves),
               [&](std::size_t node) { return is_leaf(nodes, node); });
  if (leaves.size() == 1) return leaves.front();
  context.error({}, "the chain may end at " + list(nodes, leaves), "say at which " + kind + " with --tip");
  return std::nullopt;
}

}  // namespace

std::optional<Ends> find_ends(Context& context, const std::vector<Node>& nodes, const std::string& kind) {
  const ReadOptions& options = context.options;
  const auto base = options.base.empty() ? std::nullopt : find(context, nodes, options.base, "--base", kind);
  const auto tip = options.tip.empty() ? std::nullopt : find(context, nodes, options.tip, "--tip", kind);
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
  const auto end = tip ? tip : likely_tip(context, nodes, ends.base, kind);
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
