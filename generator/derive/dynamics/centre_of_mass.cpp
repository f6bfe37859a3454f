// SPDX-License-Identifier: MIT
// The centre of mass as the tip of an arm.
//
// With H the first moment of link k and all behind it about the origin of frame k, and M their mass,
//   H(k-1) = h(k-1) + M (a, b, 0) + Rx(alpha) (Rz(angle) H(k) + M (0, 0, d)),
// where h are the link's own first moments. The part of H(k) along the axis does not turn with the joint: it
// is constant and joins h(k-1). What is left of each turning link is a vector across its axis. Divided by the
// whole mass all of them are lengths: those of an arm with the same rotations, whose tip is the centre of
// mass. A slide moves it by the share of the mass that the slide carries. If joints branch, H(k) is the
// sum over the links behind, and so is the way to the tip.
#include <array>
#include <map>
#include <utility>

#include "derive/dynamics/followers.h"
#include "derive/dynamics/formulation.h"
#include "derive/dynamics/naming.h"
#include "derive/dynamics/suggestions.h"

namespace qvgen::derive::dynamics {
namespace {

/// Rest of a link.
struct Segment {
  Vector3 arm;   ///< behind the joint; across its axis if it turns, none if not
  Scalar share;  ///< of the mass that the joint moves, for a slide
};

struct MassArm {
  Chain chain;  ///< its motions and angles
  std::vector<Segment> segments;
  Vector3 base;  ///< what does not move, in the world
};

/// The part of what is behind a joint that does not move with it, and the rest.
Vector3 split_off_constant(const Link& link, Vector3& behind) {
  Vector3 constant;
  if (link.motion == Motion::revolute)
    std::swap(constant[2], behind[2]);
  else
    std::swap(constant, behind);
  return constant;
}

/// In the source graph.
MassArm plain_arm(const model::Robot& robot, dag::Graph& graph) {
  MassArm result;
  result.chain = make_chain(robot, graph);
  const std::vector<Link>& links = result.chain.links;
  result.segments.resize(links.size());
  struct Behind {
    Vector3 moment;  ///< of what is constant there
    Scalar mass;
  };
  Behind all;
  std::vector<Behind> behind(links.size());
  for (std::size_t k = links.size(); k-- > 0;) {
    const Link& link = links[k];
    Vector3 moment = behind[k].moment + link.inertia.first_moments();
    const Scalar mass = behind[k].mass + link.inertia.mass();
    Vector3 constant = split_off_constant(link, moment);
    result.segments[k].arm = moment;
    if (link.motion == Motion::prismatic) result.segments[k].share = mass;
    if (link.motion != Motion::revolute) constant = rotate(2, circle(link.angle, graph), constant);
    constant[2] = constant[2] + mass * link.d;
    Behind& before = link.parent == no_link ? all : behind[link.parent];
    before.moment = before.moment + rotate(0, circle(link.alpha, graph), constant) +
                    mass * Vector3{link.a, link.b, Scalar()};
    before.mass = before.mass + mass;
  }
  result.base = rotate(2, circle(result.chain.yaw, graph), all.moment) + all.mass * result.chain.start;
  const Scalar per_mass = Scalar(graph, graph.constant(1)) / all.mass;
  for (Segment& segment : result.segments) {
    segment.arm = per_mass * segment.arm;
    segment.share = per_mass * segment.share;
  }
  result.base = per_mass * result.base;
  return result;
}

/// With its constants as symbols of the target graph.
MassArm named_arm(const model::Robot& robot, dag::Graph& graph, dag::Function& constants) {
  dag::Graph source;
  MassArm arm = plain_arm(robot, source);
  std::vector<Scalar*> places = {&arm.base[0], &arm.base[1], &arm.base[2]};
  for (Segment& segment : arm.segments)
    for (Scalar* place : {&segment.arm[0], &segment.arm[1], &segment.arm[2], &segment.share})
      places.push_back(place);
  std::vector<dag::Edge> edges;
  for (const Scalar* place : places) edges.push_back(place->in(source));
  Naming naming(std::move(source), std::move(edges), graph);
  for (std::size_t i = 0; i < places.size(); ++i) *places[i] = naming.name(i);
  constants = naming.take();
  return arm;
}

class CentreOfMass {
 public:
  CentreOfMass(const model::Robot& robot, Formulation& out)
      : robot_(robot),
        graph_(out.function.graph),
        suggest_(out.function),
        arm_(named_arm(robot, graph_, out.constants)) {}

  void position(dag::Function& out) {
    const Vector3 tip = arm_.base + to_world(reach());
    for (std::size_t i = 0; i < 3; ++i)
      out.outputs.push_back({std::string("c") + "xyz"[i], tip[i].in(graph_)});
  }

  void jacobian(dag::Function& out) {
    reach();
    std::array<std::vector<Scalar>, 3> rows;
    for (auto& row : rows) row.resize(robot_.joints.size());
    for (const Moved& column : columns_) {
      const Vector3 in_world = to_world(column.vector);
      for (std::size_t i = 0; i < 3; ++i) rows[i][column.joint] = in_world[i];
    }
    offer_cross_products();
    for (auto& row : rows) row = gathered(robot_, row, graph_);
    for (std::size_t joint = 0; joint < rows[0].size(); ++joint)
      for (std::size_t i = 0; i < 3; ++i)
        out.outputs.push_back(
            {std::string("j") + "xyz"[i] + std::to_string(joint + 1), rows[i][joint].in(graph_)});
  }

 private:
  /// A vector that belongs to a joint, on its way inward.
  struct Moved {
    std::size_t joint = 0;
    Vector3 vector;
    std::size_t link = no_link;  ///< where it has come to
  };

  /// The vector from link 0's start to the tip, in the frame there; columns and vectors of the joints on the
  /// way.
  Vector3 reach() {
    Vector3 reach;
    const std::vector<Link>& links = arm_.chain.links;
    std::vector<Vector3> behind(links.size());
    for (std::size_t k = links.size(); k-- > 0;) {
      const Link& link = links[k];
      Vector3 tip = behind[k] + arm_.segments[k].arm;
      offer_apart(k, behind[k]);
      if (link.motion == Motion::prismatic)
        tip[2] = tip[2] + arm_.segments[k].share * Scalar(graph_, graph_.symbol(link.variable));
      add_joint(link, k, arm_.segments[k], tip);
      inner_[k] = tip;
      Vector3& before = link.parent == no_link ? reach : behind[link.parent];
      before = before + to_parent(k, tip);
      for (std::vector<Moved>* list : {&columns_, &reaches_, &axes_})
        for (Moved& each : *list)
          if (each.link == k) each = {each.joint, to_parent(k, each.vector), link.parent};
    }
    return reach;
  }

  void add_joint(const Link& link, std::size_t k, const Segment& segment, const Vector3& tip) {
    const Scalar one(graph_, graph_.constant(1));
    if (link.motion == Motion::prismatic)
      columns_.push_back({link.joint, {Scalar(), Scalar(), segment.share}, k});
    if (link.motion != Motion::revolute) return;
    columns_.push_back({link.joint, {-tip[1], tip[0], Scalar()}, k});
    reaches_.push_back({link.joint, tip, k});
    axes_.push_back({link.joint, {Scalar(), Scalar(), one}, k});
  }

  Vector3 to_parent(std::size_t k, const Vector3& v) {
    const Link& link = arm_.chain.links[k];
    return rotate(0, circle(link.alpha, graph_), rotate(2, circle(link.angle, graph_), v));
  }

  Vector3 to_world(const Vector3& v) { return rotate(2, circle(arm_.chain.yaw, graph_), v); }

  /// The link's own part and what is behind it turned apart; behind parallel axes by the sum of the angles.
  void offer_apart(std::size_t k, const Vector3& behind) {
    const std::vector<Link>& links = arm_.chain.links;
    exact::Angle angle = links[k].angle;
    suggest_(rotate(2, circle(angle, graph_), arm_.segments[k].arm) +
             rotate(2, circle(angle, graph_), behind));
    for (std::size_t m = k + 1;
         m < links.size() && links[m].parent + 1 == m && circle(links[m].alpha, graph_).cosine.is_one();
         ++m) {
      angle = angle + links[m].angle;
      suggest_(rotate(2, circle(angle, graph_), arm_.segments[m].arm));
      suggest_(rotate(2, circle(angle, graph_), inner_.at(m)));
    }
  }

  /// Axes and reaches are in the world: a column is the cross product of both.
  void offer_cross_products() {
    for (std::size_t i = 0; i < axes_.size(); ++i)
      suggest_(cross(to_world(axes_[i].vector), to_world(reaches_[i].vector)));
  }

  const model::Robot& robot_;
  dag::Graph& graph_;
  Suggestions suggest_;
  MassArm arm_;
  std::vector<Moved> columns_, reaches_, axes_;
  std::map<std::size_t, Vector3> inner_;  ///< from each link's frame to the tip, in that frame
};

}  // namespace

Formulation centre_of_mass(const model::Robot& robot, const FormulationOptions&) {
  Formulation result;
  CentreOfMass(robot, result).position(result.function);
  return result;
}

Formulation centre_of_mass_jacobian(const model::Robot& robot, const FormulationOptions&) {
  Formulation result;
  CentreOfMass(robot, result).jacobian(result.function);
  return result;
}

}  // namespace qvgen::derive::dynamics
