// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_loops.h"

#include <algorithm>

#include "description/loops.h"
#include "description/names.h"
#include "description/xml/mjcf_numbers.h"

namespace qvgen::description::xml {
namespace {

using tree::Closure;
using tree::folded;
using tree::Node;

/// Reads the loops' elements.
class LoopReader {
 public:
  LoopReader(Context& context, const MjcfModel& model, const MjcfTree& tree, MjcfFrames& frames)
      : context_(&context), model_(&model), tree_(&tree), frames_(&frames) {}

  std::vector<Closure> closures(const std::vector<Element>& elements) {
    std::vector<Closure> result;
    if (elements.size() > most_loops) {
      context_->error(
          elements[most_loops].place, std::to_string(elements.size()) + " loops are too many",
          "a robot has at most " + std::to_string(most_loops) + "; --tip reads a chain without them");
      return result;
    }
    for (const Element& element : elements)
      if (const auto closure = closure_of(element)) result.push_back(*closure);
    return result;
  }

 private:
  std::optional<Closure> closure_of(const Element& element) {
    const bool by_sites = element.attribute("site1") != nullptr;
    const auto first = node_of(element, by_sites ? "site1" : "body1", by_sites, false);
    const auto second = node_of(element, by_sites ? "site2" : "body2", by_sites, !by_sites);
    if (!first || !second) return std::nullopt;
    Closure closure;
    closure.type = element.name == "weld" ? model::LoopType::weld : model::LoopType::ball;
    closure.nodes = {*first, *second};
    closure.place = element.place;
    if (by_sites) return closure;
    return closure.type == model::LoopType::weld ? welded(element, closure) : connected(element, closure);
  }

  /// The node that an attribute names; the world if it may lack.
  std::optional<std::size_t> node_of(const Element& element, const std::string& key, bool is_site,
                                     bool may_lack) {
    const Attribute* name = element.attribute(key);
    const std::string kind = is_site ? "site" : "body";
    if (name == nullptr) {
      if (may_lack) return 0;
      context_->error(element.place, "<" + element.name + "> without '" + key + "'",
                      "name the " + kind + " that it ties: " + key + "=\"...\"");
      return std::nullopt;
    }
    std::vector<std::string> others;
    for (std::size_t i = 0; i < tree_->nodes.size(); ++i) {
      const Node& node = tree_->nodes[i];
      if (node.is_marker != is_site || !node.has_name) continue;
      if (node.name == name->value) return i;
      if (others.size() < tree::many_names) others.push_back(node.name);
    }
    const std::string near = nearest(name->value, others);
    context_->error(name->place, "there is no " + kind + " '" + name->value + "'",
                    near.empty() ? "name a " + kind + " of the file" : "did you mean '" + near + "'?");
    return std::nullopt;
  }

  std::optional<Closure> connected(const Element& element, Closure closure) {
    const Attribute* written = element.attribute("anchor");
    if (written == nullptr) {
      context_->error(element.place, "<connect> without 'anchor'",
                      "give the point in the frame of 'body1': anchor=\"x y z\"");
      return std::nullopt;
    }
    const auto anchor = displacement("pos", *written, written->value);
    if (!anchor) return std::nullopt;
    closure.frames[0] = *anchor;
    closure.frames[1] = folded(relative(closure.nodes[1], closure.nodes[0]), *anchor);
    return closure;
  }

  std::optional<Closure> welded(const Element& element, Closure closure) {
    if (const Attribute* written = element.attribute("relpose")) {
      const auto numbers = read_decimals(*context_, *written);
      if (!numbers || numbers->size() != 7) {
        if (numbers)
          context_->error(written->place, "'relpose' has " + std::to_string(numbers->size()) + " numbers",
                          "give seven: a position and a quaternion w x y z");
        return std::nullopt;
      }
      const bool is_given = std::any_of(numbers->begin() + 3, numbers->end(),
                                        [](const Decimal& number) { return !cln::zerop(number.value); });
      if (is_given) {
        closure.frames[0] = pose(*written, *numbers);
        return closure;
      }
    }
    closure.frames[0] = relative(closure.nodes[0], closure.nodes[1]);
    return closure;
  }

  /// A position and a quaternion, as bodies have them.
  model::Displacement pose(const Attribute& written, const std::vector<Decimal>& numbers) {
    const auto words = [&](std::size_t from, std::size_t to) {
      std::string text;
      for (std::size_t i = from; i < to; ++i) text += (text.empty() ? "" : " ") + numbers[i].text;
      return text;
    };
    Element frame{"body", written.place, {}, {}};
    frame.attributes = {{"pos", words(0, 3), written.place}, {"quat", words(3, 7), written.place}};
    return MjcfNumbers(*context_, model_->settings).frame(frame);
  }

  std::optional<model::Displacement> displacement(const std::string& key, const Attribute& written,
                                                  const std::string& value) {
    const auto numbers = read_decimals(*context_, written);
    if (!numbers) return std::nullopt;
    if (numbers->size() != 3) {
      context_->error(written.place,
                      "'" + written.name + "' has " + std::to_string(numbers->size()) + " numbers",
                      "give three: " + written.name + "=\"x y z\"");
      return std::nullopt;
    }
    Element frame{"body", written.place, {}, {}};
    frame.attributes = {{key, value, written.place}};
    return MjcfNumbers(*context_, model_->settings).frame(frame);
  }

  /// Nodes from the world, left out, to a node.
  [[nodiscard]] std::vector<std::size_t> way_to(std::size_t node) const {
    std::vector<std::size_t> way;
    for (; tree_->nodes[node].parent != Node::none; node = tree_->nodes[node].parent) way.push_back(node);
    std::reverse(way.begin(), way.end());
    return way;
  }

  /// Place of a node as seen from another one, in the file's pose.
  model::Displacement relative(std::size_t from, std::size_t to) {
    const std::vector<std::size_t> first = way_to(from), second = way_to(to);
    const auto apart = std::mismatch(first.begin(), first.end(), second.begin(), second.end());
    const auto place = [&](auto begin, auto end) {
      model::Displacement frame;
      for (; begin != end; ++begin)
        if (const auto& own = tree_->parts[*begin].frame) frame = folded(frame, frames_->frame(*own));
      return frame;
    };
    return folded(tree::inverse(place(apart.first, first.end())), place(apart.second, second.end()));
  }

  Context* context_;
  const MjcfModel* model_;
  const MjcfTree* tree_;
  MjcfFrames* frames_;
};

/// Names of bodies that a program moves: what is tied to them follows it, and is no loop.
std::set<std::string> bodies_that_are_carried(const MjcfTree& tree) {
  std::set<std::string> names;
  for (const MjcfPart& part : tree.parts)
    if (part.body && text_of(*part.body->element, "mocap") == "true") names.insert(part.body->name());
  return names;
}

/// Joints that actuators of a file drive; `by_lengths`: those that tendons drive.
tree::JointNames driven_joints(const Element& root, const std::set<std::string>& by_lengths) {
  tree::JointNames driven{{by_lengths.begin(), by_lengths.end()}, {}};
  for (const Element& section : root.children) {
    if (section.name != "actuator") continue;
    driven.place = section.place;
    for (const Element& actuator : section.children)
      for (const char* key : {"joint", "jointinparent"})
        if (const Attribute* joint = actuator.attribute(key)) driven.names.push_back(joint->value);
  }
  return driven;
}

}  // namespace

bool is_loop(const Element& equality) {
  return (equality.name == "connect" || equality.name == "weld") && text_of(equality, "active") != "false";
}

tree::Loops mjcf_loops(Context& context, const MjcfModel& model, const MjcfTree& tree, MjcfFrames& frames,
                       const std::set<std::string>& driven_by_lengths) {
  const std::set<std::string> carried = bodies_that_are_carried(tree);
  std::vector<Element> elements;
  for (const Element& section : model.root.children)
    if (section.name == "equality")
      std::copy_if(section.children.begin(), section.children.end(), std::back_inserter(elements), is_loop);
  const auto is_carried = [&](const Element& element) {
    return carried.count(text_of(element, "body1")) + carried.count(text_of(element, "body2")) > 0;
  };
  tree::Loops loops;
  loops.any = !std::all_of(elements.begin(), elements.end(), is_carried);
  loops.may_lack = context.options.actuated.empty();
  loops.actuated = loops.may_lack ? driven_joints(model.root, driven_by_lengths)
                                  : tree::JointNames{context.options.actuated, {}};
  const auto warn_of = [&context](const Element& element) {
    context.warning(element.place, "<" + element.name + "> of <equality> is not read: joints move freely",
                    "loops belong to whole robots, without --tip");
  };
  for (const Element& element : elements)
    if (is_carried(element)) warn_of(element);
  std::erase_if(elements, is_carried);
  loops.leave_out = [=] { std::for_each(elements.begin(), elements.end(), warn_of); };
  loops.read = [=, &context, &model, &tree, &frames](const std::vector<Node>&) {
    return LoopReader(context, model, tree, frames).closures(elements);
  };
  return loops;
}

}  // namespace qvgen::description::xml
