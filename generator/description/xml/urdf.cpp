// SPDX-License-Identifier: MIT
#include <algorithm>
#include <deque>
#include <map>

#include "description/names.h"
#include "description/tree/tree.h"
#include "description/xml/reader.h"
#include "description/xml/urdf_composed.h"
#include "description/xml/urdf_numbers.h"

namespace qvgen::description::xml {
namespace {

using tree::Node;

// The first mistakes in the structure of a file are enough: the rest follows from them.
constexpr std::size_t most_reported = 20;

/// Links and joints by name, before any number is read.
class UrdfTree {
 public:
  UrdfTree(Context& context, const Element& root) : context_(&context) {
    if (has_macros(root)) return;
    for (const Element& child : root.children)
      if (child.name == "link") add_link(child);
    for (const Element& child : root.children)
      if (child.name == "joint") is_composed(child) ? add_composed(child) : add_joint(child);
    if (nodes.empty() && reported_ == 0)
      error(root.place, "no links", "a URDF has <link> and <joint> elements");
    find_cycle();
  }

  std::vector<Node> nodes;
  std::vector<const Element*> links;   ///< of each node
  std::vector<const Element*> joints;  ///< the one that holds each node; none for roots
  [[nodiscard]] bool good() const { return reported_ == 0; }

 private:
  /// True if xacro has not been run: links and joints are then left to its macros.
  bool has_macros(const Element& root) {
    const bool are_declared = root.attribute("xmlns:xacro") != nullptr;
    for (const Element& child : root.children) {
      if (child.name.compare(0, 6, "xacro:") != 0) continue;
      if (are_declared) {
        error(child.place, "<" + child.name + "> is a macro of xacro",
              "install xacro, which is run then: pip install xacro");
        return true;
      }
      context_->warning(child.place, "<" + child.name + "> is left out, as by other readers",
                        "macros need xmlns:xacro=\"http://ros.org/wiki/xacro\" in <robot>");
    }
    return false;
  }

  void error(Place place, const std::string& message, const std::string& hint) {
    if (++reported_ <= most_reported) context_->error(place, message, hint);
  }

  /// The text of an attribute that must be there.
  const Attribute* required(const Element& element, const std::string& key) {
    const Attribute* attribute = element.attribute(key);
    if (attribute == nullptr || attribute->value.empty())
      error(element.place, "<" + element.name + "> without '" + key + "'", "add " + key + "=\"...\"");
    return attribute == nullptr || attribute->value.empty() ? nullptr : attribute;
  }

  void add_link(const Element& link) {
    const Attribute* name = required(link, "name");
    if (name == nullptr) return;
    if (!by_name_.emplace(name->value, nodes.size()).second)
      return error(name->place, "the link '" + name->value + "' is there twice",
                   "give each link a name of its own");
    nodes.push_back({name->value, link.place, Node::none, {}, false, false});
    links.push_back(&link);
    joints.push_back(nullptr);
  }

  std::optional<std::size_t> end_of(const Element& joint, const std::string& which) {
    const Element* end = joint.child(which);
    if (end == nullptr) {
      error(joint.place, "a joint without <" + which + ">", "add <" + which + " link=\"...\"/>");
      return std::nullopt;
    }
    const Attribute* link = required(*end, "link");
    if (link == nullptr) return std::nullopt;
    const auto found = by_name_.find(link->value);
    if (found != by_name_.end()) return found->second;
    std::vector<std::string> names;
    if (nodes.size() < 1000)
      for (const Node& node : nodes) names.push_back(node.name);
    const std::string near = nearest(link->value, names);
    error(link->place, "there is no link '" + link->value + "'",
          near.empty() ? "add <link name=\"" + link->value + "\"/>" : "did you mean '" + near + "'?");
    return std::nullopt;
  }

  bool moves(const Element& joint) {
    static const std::vector<std::string> types{"revolute", "continuous", "prismatic", "fixed",
                                                "floating", "planar",     "spherical", unlimited_slide};
    const Attribute* type = required(joint, "type");
    if (type == nullptr) return false;
    if (std::find(types.begin(), types.end(), type->value) == types.end()) {
      const std::string near = nearest(type->value, types);
      // Joints of another format are reported if they are part of the chain.
      if (!near.empty())
        error(type->place, "unknown joint type '" + type->value + "'", "did you mean '" + near + "'?");
    }
    return type->value != "fixed";
  }

  void add_composed(const Element& joint) {
    if (required(joint, "name") == nullptr || !end_of(joint, "parent") || !end_of(joint, "child")) return;
    made_.push_back(successive_joints(*context_, joint));
    if (made_.back().empty()) ++reported_;
    for (const Element& part : made_.back()) part.name == "link" ? add_link(part) : add_joint(part);
  }

  void add_joint(const Element& joint) {
    const Attribute* name = required(joint, "name");
    const bool is_moving = moves(joint);
    const auto parent = end_of(joint, "parent");
    const auto child = end_of(joint, "child");
    if (name == nullptr || !parent || !child) return;
    if (!joint_names_.emplace(name->value, 0).second)
      return error(name->place, "the joint '" + name->value + "' is there twice",
                   "give each joint a name of its own");
    Node& node = nodes[*child];
    if (joints[*child] != nullptr)
      return error(joint.place, "two joints hold the link '" + node.name + "'",
                   "a link has one parent: cut the loop");
    joints[*child] = &joint;
    node.parent = *parent;
    node.moves = is_moving;
    node.joint = name->value;
    const Attribute* type = joint.attribute("type");
    node.is_free = node.floats = type != nullptr && type->value == "floating";
    nodes[*parent].children.push_back(*child);
  }

  /// A link that is reached from no root hangs on itself.
  void find_cycle() {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (nodes[i].parent == Node::none) open.push_back(i);
    std::vector<bool> reached(nodes.size(), false);
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      reached[node] = true;
      open.insert(open.end(), nodes[node].children.begin(), nodes[node].children.end());
    }
    const auto lost = std::find(reached.begin(), reached.end(), false);
    if (lost == reached.end()) return;
    const Node& node = nodes[static_cast<std::size_t>(lost - reached.begin())];
    error(node.place, "the link '" + node.name + "' hangs on itself, through other links",
          "a URDF is a tree: cut the loop");
  }

  Context* context_;
  std::map<std::string, std::size_t> by_name_, joint_names_;
  std::size_t reported_ = 0;
  std::deque<std::deque<Element>> made_;  ///< in place of planar and spherical joints
};

/// Returns what hangs on a link by fixed joints.
std::vector<const Element*> rigid_links(const UrdfTree& tree, std::size_t link) {
  std::vector<const Element*> result;
  std::vector<std::size_t> open{link};
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    for (const std::size_t child : tree.nodes[node].children) {
      if (tree.nodes[child].moves) continue;
      result.push_back(tree.links[child]);
      open.push_back(child);
    }
  }
  return result;
}

}  // namespace

std::vector<UrdfLink> urdf_chain(Context& context, const Element& root) {
  UrdfTree tree(context, root);
  if (!tree.good()) return {};
  const std::vector<std::string>& held = context.options.fixed;
  for (Node& node : tree.nodes)
    if (std::find(held.begin(), held.end(), node.joint) != held.end()) node.moves = false;
  const auto ends = find_ends(context, tree.nodes, "link");
  const auto path = ends ? path_between(tree.nodes, *ends) : std::nullopt;
  std::vector<UrdfLink> chain;
  for (const std::size_t node : path.value_or(std::vector<std::size_t>{}))
    chain.push_back({tree.links[node], tree.joints[node], tree.nodes[node].moves, rigid_links(tree, node)});
  return chain;
}

model::Mechanism read_urdf(Context& context, const Element& root, const tree::Loops& loops) {
  const UrdfTree tree(context, root);
  if (!tree.good()) return {};
  const Attribute* name = root.attribute("name");
  const std::string title = name == nullptr || name->value.empty() ? "robot" : name->value;
  const UrdfNumbers numbers(context);
  return read_tree(
      context, tree.nodes, "link", title,
      [&](std::size_t node) { return numbers.segment(*tree.links[node], *tree.joints[node]); },
      [&](std::size_t node) { return numbers.body(*tree.links[node]); }, loops);
}

}  // namespace qvgen::description::xml
