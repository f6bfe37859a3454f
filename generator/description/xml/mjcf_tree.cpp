// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_tree.h"

namespace qvgen::description::xml {

using tree::Node;

void warn_of_tendons(Context& context, const Element& section) {
  context.warning(section.place, "<tendon> is not read", "add its forces to what the dynamics gives");
}

MjcfTree::MjcfTree(Context& context, const MjcfModel& model) : context_(&context), contents_(context) {
  add({"world", model.root.place, Node::none, {}, false, false}, {});
  for (const Element& child : model.root.children)
    if (child.name == "worldbody") add_children(contents_.of({&child, &model}), 0, 0);
  for (const auto& attached : model.models) warn_of_sections(*attached.second);
}

void MjcfTree::warn_of_sections(const MjcfModel& model) {
  for (const Element& child : model.root.children) {
    if (child.name == "equality" && !child.children.empty())
      context_->warning(child.place, "<equality> is not read: joints move freely",
                        "remove it if that is right");
    if (child.name == "tendon" && !child.children.empty()) warn_of_tendons(*context_, child);
  }
  for (const auto& attached : model.models) warn_of_sections(*attached.second);
}

std::size_t MjcfTree::add(Node node, MjcfPart part) {
  const std::size_t index = nodes.size();
  if (node.parent != Node::none) nodes[node.parent].children.push_back(index);
  nodes.push_back(std::move(node));
  parts.push_back(std::move(part));
  return index;
}

std::string MjcfTree::name_of(const Placed& placed, const std::string& kind) const {
  const std::string name = placed.name();
  return name.empty() ? kind + " " + std::to_string(nodes.size()) : name;
}

void MjcfTree::add_children(const std::vector<Placed>& contents, std::size_t parent, std::size_t depth) {
  for (const Placed& child : contents) {
    const std::string& kind = child.element->name;
    if (kind == "body") add_body(child, parent, depth + 1);
    if (kind == "site") {
      MjcfPart part;
      part.frame = child;
      Node site{name_of(child, "site"), child.element->place, parent, {}, false, true};
      site.has_name = !child.name().empty();
      add(std::move(site), std::move(part));
    }
    if (kind == "composite" || kind == "flexcomp")
      context_->warning(child.element->place, "<" + kind + "> is not read: what it makes is left out",
                        "have MuJoCo save the model: mj_saveLastXML writes plain bodies");
  }
}

std::size_t MjcfTree::add_joints(const Placed& body, MjcfPart& part, std::size_t parent,
                                 const std::string& name) {
  std::size_t holder = parent;
  for (const Placed& child : part.contents) {
    if (child.element->name != "joint" && child.element->name != "freejoint") continue;
    const auto joints = joints_of(*context_, child, name);
    if (joints.empty()) part.held = child;
    for (const MjcfJoint& joint : joints) {
      if (part.joint) {  // the joints of a body follow each other, without links between them
        const std::string before = part.joint->placed.name().empty() ? "a joint" : part.joint->name;
        MjcfPart link;
        std::swap(link.frame, part.frame);
        std::swap(link.joint, part.joint);
        Node node{name + " behind " + before, body.element->place, holder, {}, true, false};
        node.joint = link.joint->placed.name();
        holder = add(std::move(node), std::move(link));
      }
      part.joint = joint;
    }
  }
  return holder;
}

void MjcfTree::add_body(const Placed& body, std::size_t parent, std::size_t depth) {
  if (depth > max_depth) {
    if (!refused_)
      context_->error(body.element->place, "bodies nested more than " + std::to_string(max_depth) + " deep",
                      "a body does not attach one that holds it");
    refused_ = true;
    return;
  }
  const std::string name = name_of(body, "body");
  MjcfPart part;
  part.frame = part.body = body;
  part.contents = contents_.of(body);
  const std::vector<Placed> contents = part.contents;
  const std::size_t holder = add_joints(body, part, parent, name);
  Node node{name, body.element->place, holder, {}, part.joint.has_value(), false};
  if (part.joint) node.joint = part.joint->placed.name();
  node.floats = node.is_free = part.held.has_value();
  node.has_name = !body.name().empty();
  add_children(contents, add(std::move(node), std::move(part)), depth);
}

}  // namespace qvgen::description::xml
