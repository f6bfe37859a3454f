// SPDX-License-Identifier: MIT
#pragma once

#include "description/tree/tree.h"
#include "description/xml/mjcf_joints.h"

namespace qvgen::description::xml {

/// Part that holds a node: the frame of its body first, then its joints, each a node of its own; or a site.
struct MjcfPart {
  std::optional<Placed> frame;     ///< body or site whose frame is applied before the joint
  std::optional<MjcfJoint> joint;  ///< none: fixed
  std::optional<Placed> held;      ///< a free joint that is read as fixed
  std::optional<Placed> body;      ///< the body whose inertia this node has
  std::vector<Placed> contents;    ///< of that body
};

/// Bodies and sites of an MJCF by name, before any number is read. What ties joints together is read by
/// mjcf_couplings.h in the model's own file, and left out with a warning in attached ones.
class MjcfTree {
 public:
  MjcfTree(Context& context, const MjcfModel& model);
  std::vector<tree::Node> nodes;
  std::vector<MjcfPart> parts;

 private:
  std::size_t add(tree::Node node, MjcfPart part);
  void add_children(const std::vector<Placed>& contents, std::size_t parent, std::size_t depth);
  void add_body(const Placed& body, std::size_t parent, std::size_t depth);
  [[nodiscard]] std::string name_of(const Placed& placed, const std::string& kind) const;
  /// The joints that the body has, each behind the one before; returns the node of the last but one.
  std::size_t add_joints(const Placed& body, MjcfPart& part, std::size_t parent, const std::string& name);
  void warn_of_sections(const MjcfModel& model);

  Context* context_;
  MjcfContents contents_;
  bool refused_ = false;
};

/// Says that the tendons of a section are left out.
void warn_of_tendons(Context& context, const Element& section);

}  // namespace qvgen::description::xml
