// SPDX-License-Identifier: MIT
#include <algorithm>

#include "description/tree/tree.h"
#include "description/xml/mjcf_numbers.h"
#include "description/xml/reader.h"

namespace qvgen::description::xml {
namespace {

using tree::Node;

/// What holds a node: the frame of its body first, then its joints, each a node of its own; or a site.
struct Part {
  const Element* frame = nullptr;  ///< body or site whose frame is applied before the joint
  std::optional<Element> joint;    ///< with its defaults
  const Element* body = nullptr;   ///< the body whose inertia this node has
};

class MjcfTree {
 public:
  MjcfTree(Context& context, const Element& root) : context_(&context), defaults_(context, root) {
    add({"world", root.place, Node::none, {}, false, false}, {});
    for (const Element& child : root.children) {
      if (child.name == "worldbody") add_children(child, 0, "");
      if (child.name == "include")
        context.error(child.place, "<include> is not followed", "put the other file's content here");
      if (child.name == "equality" && !child.children.empty())
        context.warning(child.place, "<equality> is not read: joints move freely",
                        "remove it if that is right");
      if (child.name == "tendon" && !child.children.empty())
        context.warning(child.place, "<tendon> is not read", "add its forces to what the dynamics gives");
    }
  }

  std::vector<Node> nodes;
  std::vector<Part> parts;

 private:
  std::size_t add(Node node, Part part) {
    const std::size_t index = nodes.size();
    if (node.parent != Node::none) nodes[node.parent].children.push_back(index);
    nodes.push_back(std::move(node));
    parts.push_back(std::move(part));
    return index;
  }

  static std::string name_of(const Element& element, const std::string& otherwise) {
    const Attribute* name = element.attribute("name");
    return name == nullptr || name->value.empty() ? otherwise : name->value;
  }

  void add_children(const Element& element, std::size_t parent, const std::string& childclass) {
    for (const Element& child : element.children) {
      if (child.name == "body") add_body(child, parent, childclass);
      if (child.name == "site")
        add({name_of(child, "site " + std::to_string(nodes.size())),
             child.place,
             parent,
             {},
             false,
             true,
             !name_of(child, "").empty()},
            {&child, std::nullopt, nullptr});
      if (child.name == "frame" || child.name == "replicate" || child.name == "composite" ||
          child.name == "attach")
        context_->error(child.place, "<" + child.name + "> is not read",
                        "have MuJoCo save the model: mj_saveLastXML writes plain bodies");
    }
  }

  void add_body(const Element& body, std::size_t parent, const std::string& around) {
    const Attribute* own = body.attribute("childclass");
    const std::string childclass = own == nullptr ? around : own->value;
    const std::string name = name_of(body, "body " + std::to_string(nodes.size()));
    Part part{&body, std::nullopt, nullptr};
    std::size_t holder = parent;
    for (const Element& child : body.children) {
      if (child.name != "joint" && child.name != "freejoint") continue;
      if (part.joint) {  // the joints of a body follow each other, without links between them
        holder = add(
            {name + " behind " + name_of(*part.joint, "a joint"), body.place, holder, {}, true, false}, part);
        part.frame = nullptr;
      }
      part.joint = child.name == "joint" ? defaults_.completed(child, childclass) : child;
    }
    part.body = &body;
    const bool moves = part.joint.has_value();
    add_children(
        body, add({name, body.place, holder, {}, moves, false, !name_of(body, "").empty()}, std::move(part)),
        childclass);
  }

  Context* context_;
  JointDefaults defaults_;
};

}  // namespace

model::Robot read_mjcf(Context& context, const Element& root) {
  model::Robot robot;
  const MjcfNumbers numbers(context, read_settings(context, root));
  const MjcfTree tree(context, root);
  if (context.has_error) return robot;
  const auto ends = find_ends(context, tree.nodes, "body");
  if (!ends) return robot;
  const Attribute* name = root.attribute("model");
  const std::string title = name == nullptr || name->value.empty() ? "robot" : name->value;
  robot.name = tree::robot_identifier(title);
  robot.title = title + ", " + tree.nodes[ends->base].name + " to " + tree.nodes[ends->tip].name;
  const auto read = [&](std::size_t node) -> std::optional<tree::Segment> {
    const Part& part = tree.parts[node];
    std::optional<tree::Segment> segment = tree::Segment{};
    if (part.joint) {
      const Attribute* own = part.joint->attribute("name");
      segment = numbers.joint(*part.joint, own == nullptr ? tree.nodes[node].name : own->value);
    }
    if (!segment) return std::nullopt;
    if (part.frame != nullptr) segment->before = tree::folded(numbers.frame(*part.frame), segment->before);
    if (part.body != nullptr) segment->body = numbers.body(*part.body);
    return segment;
  };
  read_chain(context, tree.nodes, *ends, read, robot);
  return robot;
}

}  // namespace qvgen::description::xml
