// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_couplings.h"
#include "description/xml/mjcf_inertia.h"
#include "description/xml/mjcf_loops.h"
#include "description/xml/mjcf_numbers.h"
#include "description/xml/mjcf_tree.h"
#include "description/xml/reader.h"
#include "model/evaluate.h"

namespace qvgen::description::xml {
namespace {

/// Reads the numbers of the tree's nodes.
class SegmentReader {
 public:
  SegmentReader(Context& context, const MjcfModel& model, const MjcfTree& tree,
                const MjcfInertiaSettings& settings)
      : context_(&context),
        tree_(&tree),
        frames_(context, context.options.snap),
        inertia_(context),
        couplings_(context, model, tree) {
    if (cln::plusp(settings.total_mass)) scale_ = scale_to(settings.total_mass);
  }

  std::optional<tree::Segment> read(std::size_t node) {
    const MjcfPart& part = tree_->parts[node];
    std::optional<tree::Segment> segment = part.joint ? joint(*part.joint) : tree::Segment{};
    if (!segment) return std::nullopt;
    if (part.held) tell_of_free(node, *part.held);
    if (part.frame) segment->before = tree::folded(frames_.frame(*part.frame), segment->before);
    segment->body = body(node);
    return segment;
  }

  /// Joints that motors of tendons drive.
  [[nodiscard]] const std::set<std::string>& driven_by_lengths() const {
    return couplings_.driven_by_lengths();
  }

  [[nodiscard]] bool follow_powers() const { return couplings_.follow_powers(); }

  /// The numbers of frames around elements.
  MjcfFrames& frames() { return frames_; }

  tree::Body body(std::size_t node) {
    const MjcfPart& part = tree_->parts[node];
    return part.body ? scaled(inertia_.of(*part.body, part.contents), scale_) : tree::Body{};
  }

 private:
  /// The frames around a joint place its axis: there, the motion, and back.
  std::optional<tree::Segment> joint(const MjcfJoint& joint) {
    if (joint.first_of_ball) tell_of_ball(*context_, joint);
    const MjcfNumbers numbers(*context_, joint.placed.model->settings);
    auto segment = numbers.joint(joint.element, joint.name);
    if (segment) segment->joint->mimic = couplings_.of(joint.name);
    if (!segment || joint.placed.around == nullptr) return segment;
    const model::Displacement around = frames_.around(joint.placed.around);
    segment->before = tree::folded(around, segment->before);
    segment->after = tree::folded(segment->after, tree::inverse(around));
    return segment;
  }

  void tell_of_free(std::size_t node, const Placed& joint) {
    const std::string name = joint.name();
    context_->warning(joint.element->place,
                      (name.empty() ? "a joint" : "the joint '" + name + "'") +
                          std::string(" is free: the body is held where the file has it"),
                      "with --base '" + tree_->nodes[node].name +
                          "' the chain begins at this body; with --floating it moves freely");
  }

  /// By what masses are multiplied so that those of all bodies sum up to a total.
  cln::cl_R scale_to(const cln::cl_R& total) {
    const cln::cl_R least = cln::expt(cln::cl_RA(10), cln::cl_I(-15));
    cln::cl_R sum = 0;
    for (const MjcfPart& part : tree_->parts)
      if (part.body) sum = sum + inertia_.of(*part.body, part.contents).mass;
    return cln::max(least, total / cln::max(least, sum));
  }

  Context* context_;
  const MjcfTree* tree_;
  MjcfFrames frames_;
  MjcfInertia inertia_;
  MjcfCouplings couplings_;
  cln::cl_R scale_ = 1;
};

}  // namespace

model::Mechanism read_mjcf(Context& context, const Element& root) {
  const auto model = load_model(context, root);
  if (context.has_error) return {};
  const MjcfTree tree(context, *model);
  if (context.has_error) return {};
  const Attribute* name = root.attribute("model");
  const std::string title = name == nullptr || name->value.empty() ? "robot" : name->value;
  SegmentReader reader(context, *model, tree, model->settings.inertia);
  tree::Loops loops = mjcf_loops(context, *model, tree, reader.frames(), reader.driven_by_lengths());
  loops.any = loops.any || reader.follow_powers();
  return read_tree(
      context, tree.nodes, "body", title, [&](std::size_t node) { return reader.read(node); },
      [&](std::size_t node) { return reader.body(node); }, loops);
}

}  // namespace qvgen::description::xml
