// SPDX-License-Identifier: MIT
#include "description/tree/rods.h"

#include <algorithm>
#include <map>

#include <cln/float.h>
#include <fmt/format.h>

#include "model/evaluate.h"

namespace qvgen::description::tree {
namespace {

using Nodes = std::vector<Node>;

/// A link between two points.
struct Rod {
  std::size_t first = Node::none;  ///< the node of its first joint
  model::Displacement ball;        ///< its first end, seen from the node before that
  Vector reach{};                  ///< from its first end to its other one, m
  Body body;                       ///< as `reach`, in the frame behind the last joint, about the first end
  bool has_limits = false;
};

cln::cl_R dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool is_right(const Vector& a, const Vector& b) { return model::vanishes(dot(a, b)); }

bool is_zero(const model::Vector3& v) {
  const Vector value = values(v);
  return std::all_of(value.begin(), value.end(), model::vanishes);
}

Body point(const cln::cl_R& mass, const model::Vector3& at) {
  Body body;
  body.mass = mass;
  body.centre = values(at);
  return body;
}

/// Finds the rods of a tree.
class Finder {
 public:
  Finder(Context& context, const Nodes& nodes, const ReadSegment& read, const Loops& loops,
         const std::vector<Closure>& closures)
      : context_(&context),
        nodes_(&nodes),
        read_(&read),
        kept_(context.options.tips.begin(), context.options.tips.end()) {
    for (const Closure& closure : closures)
      for (const std::size_t node : closure.nodes) ++ties_[node];
    for (const JointNames* list : {&loops.actuated, &loops.outputs})
      driven_.insert(list->names.begin(), list->names.end());
  }

  /// The rod that an end of a closure ties.
  std::optional<Rod> rod_at(std::size_t node, const model::Displacement& tied) {
    model::Displacement end = tied;
    for (; !(*nodes_)[node].moves; node = (*nodes_)[node].parent) {
      if ((*nodes_)[node].parent == Node::none) return std::nullopt;
      const Segment& segment = segment_of(node);
      end = folded(folded(segment.before, segment.after), end);
    }
    if (!ends_at(node) || ties_behind(node) != 1) return std::nullopt;
    return rod_of(node, folded(segment_of(node).after, end));
  }

 private:
  /// Behind the last joint, whose node is given; `end` is seen from there.
  std::optional<Rod> rod_of(std::size_t last, const model::Displacement& end) {
    Rod rod;
    rod.reach = values(end.translation);
    if (!can_be_of_rod(last) || model::vanishes(dot(rod.reach, rod.reach))) return std::nullopt;
    rod.body = body_behind(last, segment_of(last).after);
    int joints = 1;
    std::size_t node = last;
    for (; joints < 3 && meets_next(node); ++joints) {
      rod.has_limits = rod.has_limits || segment_of(node).joint->limits;
      node = (*nodes_)[node].parent;
      rod.body = joined(rod.body, point(segment_of(node).body.mass, {}));
    }
    // Two turns lead everywhere around their common point if the rod is across the second one, three always.
    if (joints == 1 || (joints == 2 && !is_right(values(segment_of(last).joint->axis), rod.reach)))
      return std::nullopt;
    rod.has_limits = rod.has_limits || segment_of(node).joint->limits;
    rod.first = node;
    rod.ball = segment_of(node).before;
    return rod;
  }

  /// True if nothing behind the link moves, and no option names any of it.
  bool ends_at(std::size_t node) const {
    if (kept_.count((*nodes_)[node].name) > 0) return false;
    return std::all_of((*nodes_)[node].children.begin(), (*nodes_)[node].children.end(),
                       [this](std::size_t child) { return !(*nodes_)[child].moves && ends_at(child); });
  }

  /// Closures at the link and at what is fixed to it.
  int ties_behind(std::size_t node) const {
    const auto own = ties_.find(node);
    int ties = own == ties_.end() ? 0 : own->second;
    for (const std::size_t child : (*nodes_)[node].children) ties += ties_behind(child);
    return ties;
  }

  bool can_be_of_rod(std::size_t node) {
    const Node& own = (*nodes_)[node];
    if (!own.moves || own.parent == Node::none) return false;
    const auto& joint = segment_of(node).joint;
    return joint && joint->type == model::JointType::revolute && !joint->mimic &&
           driven_.count(joint->name) == 0;
  }

  /// True if the joint before this one has its axis through the same point and across this one's, and carries
  /// nothing else.
  bool meets_next(std::size_t node) {
    const std::size_t before = (*nodes_)[node].parent;
    if (!can_be_of_rod(before) || (*nodes_)[before].children.size() != 1) return false;
    if (ties_.count(before) > 0 || kept_.count((*nodes_)[before].name) > 0) return false;
    const Segment& first = segment_of(before);
    const model::Displacement between = folded(first.after, segment_of(node).before);
    return is_zero(between.translation) &&
           is_right(values(first.joint->axis), values(turned(between.turns, segment_of(node).joint->axis)));
  }

  /// The link and all that is fixed to it.
  Body body_behind(std::size_t node, const model::Displacement& placement) {
    Body sum = moved(placement, segment_of(node).body);
    for (const std::size_t child : (*nodes_)[node].children) {
      const Segment& segment = segment_of(child);
      const Body own = body_behind(child, folded(folded(placement, segment.before), segment.after));
      if (!cln::zerop(own.mass)) sum = joined(sum, own);
    }
    return sum;
  }

  const Segment& segment_of(std::size_t node) {
    const auto [place, is_new] = segments_.try_emplace(node);
    if (is_new) place->second = read_quietly(node);
    return place->second;
  }

  /// Reads a link without the notes of its joints: a rod has none, and other links are read once more.
  Segment read_quietly(std::size_t node) {
    auto& told = context_->diagnostics;
    const auto before = static_cast<std::ptrdiff_t>(told.size());
    Segment segment = (*read_)(node).value_or(Segment{});
    const auto is_note = [](const Diagnostic& each) { return each.severity == Diagnostic::note; };
    told.erase(std::remove_if(told.begin() + before, told.end(), is_note), told.end());
    return segment;
  }

  Context* context_;
  const Nodes* nodes_;
  const ReadSegment* read_;
  std::set<std::string> kept_, driven_;
  std::map<std::size_t, int> ties_;  ///< closures at a node
  std::map<std::size_t, Segment> segments_;
};

cln::cl_R length_of(const Rod& rod) {
  return model::evaluate(
      model::Expression::make(model::Expression::Kind::root, {rounded(dot(rod.reach, rod.reach))}));
}

/// Which part of the rod's mass its second end has, so that the centre of mass stays where it is along the
/// rod.
cln::cl_R part_of_end(const Rod& rod) {
  const cln::cl_R part = dot(rod.body.centre, rod.reach) / dot(rod.reach, rod.reach);
  return cln::max(cln::cl_R(0), cln::min(cln::cl_R(1), part));
}

void tell(Context& context, const Node& link, const Rod& rod, double length) {
  const std::string lost = rod.has_limits ? ", without the limits of its joints" : "";
  context.note(link.place,
               fmt::format("'{}' only keeps two points at their distance: it is read as a rod of {:.6g} m{}",
                           link.name, length, lost),
               "its own joints are left out; --tips with its name keeps them");
  if (!cln::zerop(rod.body.mass))
    context.warning(link.place,
                    fmt::format("the mass of the rod '{}', {:.6g} kg, is read as two masses at its ends",
                                link.name, model::to_double(rod.body.mass)),
                    "its weight is exact if its centre is between the ends, its inertia a little too large");
}

/// Puts a rod in place of the ball at an end of a closure, and its mass to the points of its ends.
void take(const Rod& rod, std::size_t end, Closure& closure, Nodes& nodes,
          std::map<std::size_t, Body>& points) {
  const std::size_t holder = nodes[rod.first].parent, other = closure.nodes.at(1 - end);
  auto& carried = nodes[holder].children;
  carried.erase(std::find(carried.begin(), carried.end(), rod.first));
  const cln::cl_R part = part_of_end(rod);
  points[holder] = joined(points[holder], point(rod.body.mass * (1 - part), rod.ball.translation));
  points[other] = joined(points[other], point(rod.body.mass * part, closure.frames.at(1 - end).translation));
  closure.type = model::LoopType::rod;
  closure.nodes.at(end) = holder;
  closure.frames.at(end) = rod.ball;
  closure.length = rounded(length_of(rod));
}

}  // namespace

WithoutRods take_rods(Context& context, const Nodes& nodes, const ReadSegment& read, const Loops& loops,
                      const std::vector<Closure>& closures) {
  WithoutRods result{nodes, closures, read};
  Finder finder(context, nodes, read, loops, closures);
  std::map<std::size_t, Body> points;
  for (Closure& closure : result.closures)
    for (std::size_t end = 0; end < 2 && closure.type == model::LoopType::ball && !closure.axis; ++end) {
      const auto rod = finder.rod_at(closure.nodes.at(end), closure.frames.at(end));
      if (!rod) continue;
      tell(context, nodes[closure.nodes.at(end)], *rod, model::to_double(length_of(*rod)));
      take(*rod, end, closure, result.nodes, points);
    }
  result.points = points;
  result.read = [read, points](std::size_t node) {
    auto segment = read(node);
    const auto found = points.find(node);
    if (segment && found != points.end()) segment->body = joined(segment->body, found->second);
    return segment;
  };
  return result;
}

}  // namespace qvgen::description::tree
