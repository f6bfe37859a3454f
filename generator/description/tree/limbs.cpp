// SPDX-License-Identifier: MIT
#include "description/tree/limbs.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "description/tree/moving_tree.h"

namespace qvgen::description::tree {
namespace {

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool has_word(const std::string& text, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(),
                     [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// True if what moves behind a link is the fingers of its gripper.
bool is_hand(const std::vector<Node>& nodes, const MovingTree& tree, std::size_t link) {
  const auto& branches = tree.next[link];
  constexpr std::size_t longest_finger = 8, longest_unnamed = 2, shortest_arm = 3;
  const std::size_t depth = tree.height[link];
  if (branches.empty() || depth > longest_finger || tree.joints[link] < std::max(shortest_arm, depth))
    return false;
  // Two fingers, or the bars of their linkages in pairs.
  const bool alike = std::all_of(branches.begin(), branches.end(), [&](std::size_t branch) {
    return std::count_if(branches.begin(), branches.end(),
                         [&](std::size_t other) { return tree.height[other] == tree.height[branch]; }) > 1;
  });
  const auto is_named = [&](std::size_t branch) { return is_finger(nodes[branch]); };
  // Motors of a hand are single joints beside its fingers.
  const bool named = std::any_of(branches.begin(), branches.end(), is_named) &&
                     std::all_of(branches.begin(), branches.end(), [&](std::size_t branch) {
                       return is_named(branch) || tree.height[branch] == 0;
                     });
  return named || (alike && depth <= longest_unnamed);
}

/// The moving links from the base to one of them.
std::vector<std::size_t> moving_path(const MovingTree& tree, std::size_t link) {
  std::vector<std::size_t> path;
  for (; link != Node::none; link = tree.before[link]) path.push_back(link);
  std::reverse(path.begin(), path.end());
  return path;
}

Limb::Kind kind_of(const std::vector<Node>& nodes, const std::vector<std::size_t>& path, std::size_t own) {
  std::string names;
  for (std::size_t i = path.size() - own; i < path.size(); ++i)
    names += lower_case(nodes[path[i]].name + " " + nodes[path[i]].joint) + "\n";
  if (own <= 2 && has_word(names, {"wheel", "caster", "castor", "rotor", "propeller"})) return Limb::wheel;
  if (has_word(names, {"leg", "hip", "knee", "ankle", "foot", "thigh", "calf", "shank", "haa", "hfe", "kfe"}))
    return Limb::leg;
  if (own <= 3 && has_word(names, {"head", "neck", "camera", "eye", "gaze"})) return Limb::head;
  return own >= 4 || has_word(names, {"arm", "shoulder", "elbow", "wrist"}) ? Limb::arm : Limb::other;
}

/// Sets what a limb has for itself: the joints behind the last one that another limb has too.
void set_own(const std::vector<Node>& nodes, const MovingTree& tree, std::vector<Limb>& limbs) {
  std::vector<std::size_t> shares(nodes.size(), 0);
  for (const Limb& limb : limbs)
    for (const std::size_t link : moving_path(tree, limb.end)) ++shares[link];
  for (Limb& limb : limbs) {
    const auto path = moving_path(tree, limb.end);
    limb.own = static_cast<std::size_t>(
        std::count_if(path.begin(), path.end(), [&](std::size_t link) { return shares[link] == 1; }));
    limb.kind = kind_of(nodes, path, limb.own);
  }
}

/// Returns the fixed frames of a moving link, itself first, in the order of a walk down the tree.
std::vector<std::size_t> frames_of(const std::vector<Node>& nodes, std::size_t end) {
  std::vector<std::size_t> frames{end};
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (const std::size_t child : nodes[frames[i]].children)
      if (!nodes[child].moves) frames.push_back(child);
  return frames;
}

bool is_sensor(const Node& node) {
  return has_word(lower_case(node.name),
                  {"cam", "sensor", "optical", "imu", "lidar", "laser", "light", "led_", "marker", "inertia",
                   "collision", "visual", "microphone", "depth"});
}

std::size_t common_ancestor(const std::vector<Node>& nodes, const std::vector<std::size_t>& links,
                            std::size_t root) {
  std::vector<std::size_t> count(nodes.size(), 0);
  for (const std::size_t link : links)
    for (std::size_t at = link; at != Node::none; at = at == root ? Node::none : nodes[at].parent)
      ++count[at];
  std::size_t best = links.front();
  for (; best != root && count[best] < links.size();) best = nodes[best].parent;
  return best;
}

/// Names of tips; the first that a file has is meant.
constexpr std::array tip_names{"tool0", "tool",    "tcp",    "tool_link", "ee_link",    "end_effector",
                               "ee",    "link_ee", "flange", "hand_tcp",  "tool_frame", "attachment_site"};
/// Likewise, but too common among other links to be looked for everywhere.
constexpr std::array end_names{
    "end_effector_link", "link_eef", "tcp_link",     "ee_gripper_link", "gripper_tcp",
    "grasping_frame",    "hand",     "gripper_link", "gripper"};

bool ends_with_words(const std::string& name, const std::string& words) {
  if (name.size() <= words.size() || name.substr(name.size() - words.size()) != words) return false;
  return std::isalnum(static_cast<unsigned char>(name[name.size() - words.size() - 1])) == 0;
}

}  // namespace

bool is_finger(const Node& node) {
  const std::string joint = lower_case(node.joint), link = lower_case(node.name);
  if (has_word(joint + " " + link, {"finger", "jaw", "claw", "thumb", "knuckle", "pinch", "mover"}))
    return true;
  if (has_word(joint, {"index", "middle", "_ring_", "little", "pinky"})) return true;
  // A wrist that turns a gripper moves no finger.
  return has_word(joint, {"grip"}) && !has_word(joint, {"roll", "rotat", "wrist", "flex", "pitch", "yaw"});
}

std::size_t carrier_of(const std::vector<Node>& nodes, std::size_t node) {
  while (node != Node::none && !nodes[node].moves) node = nodes[node].parent;
  return node;
}

std::vector<std::size_t> fixed_ends(const std::vector<Node>& nodes, std::size_t end) {
  std::vector<std::size_t> ends;
  for (const std::size_t frame : frames_of(nodes, end)) {
    const auto& children = nodes[frame].children;
    const bool is_end = std::none_of(children.begin(), children.end(), [&](std::size_t child) {
      return !nodes[child].is_marker && !nodes[child].moves;
    });
    if (is_end && !nodes[frame].is_marker) ends.push_back(frame);
  }
  return ends;
}

std::size_t named_tip(const std::vector<Node>& nodes, const std::vector<std::size_t>& among, bool by_end) {
  std::vector<std::string> names(tip_names.begin(), tip_names.end());
  if (by_end) names.insert(names.end(), end_names.begin(), end_names.end());
  for (const std::string& name : names)
    for (const std::size_t node : among)
      if (nodes[node].name == name) return node;
  for (const std::string& name : names)
    for (const std::size_t node : among)
      if (by_end && ends_with_words(lower_case(nodes[node].name), name)) return node;
  return Node::none;
}

std::size_t frame_of(const std::vector<Node>& nodes, std::size_t end) {
  const std::size_t named = named_tip(nodes, frames_of(nodes, end), true);
  if (named != Node::none) return named;
  std::vector<std::size_t> ends = fixed_ends(nodes, end);
  std::erase_if(ends, [&](std::size_t node) { return is_sensor(nodes[node]); });
  return ends.empty() ? end : common_ancestor(nodes, ends, end);
}

std::vector<Limb> limbs_of(const std::vector<Node>& nodes, std::size_t base) {
  const MovingTree tree = moving_tree(nodes, base);
  std::vector<Limb> limbs;
  std::vector<std::size_t> limb_of(nodes.size(), Node::none);
  for (std::size_t leaf = 0; leaf < nodes.size(); ++leaf) {
    if (tree.joints[leaf] == 0 || !nodes[leaf].moves || tree.height[leaf] > 0) continue;
    const auto path = moving_path(tree, leaf);
    const auto hand =
        std::find_if(path.begin(), path.end(), [&](std::size_t link) { return is_hand(nodes, tree, link); });
    const std::size_t end = hand == path.end() ? leaf : *hand;
    if (limb_of[end] == Node::none) {
      limb_of[end] = limbs.size();
      limbs.push_back({end, tree.joints[end], 0, Limb::other, {}});
    }
    if (end != leaf) limbs[limb_of[end]].fingers.push_back(leaf);
  }
  set_own(nodes, tree, limbs);
  return limbs;
}

}  // namespace qvgen::description::tree
