// SPDX-License-Identifier: MIT
#include "derive/dynamics/link_wrenches.h"

#include <map>

#include "model/coordinates.h"

namespace qvgen::derive::dynamics {
namespace {

class Inward {
 public:
  Inward(const Recursion& recursion, const LinkMotions& motions)
      : r_(recursion), motions_(motions), behind_(recursion.joints.size()) {}

  LinkWrenches run() {
    if (r_.choices.wrench) behind_.back() = wrench_to_balance(r_.last_angle);
    const std::size_t links = r_.joints.size();
    LinkWrenches result{std::vector<Wrench>(links),
                        std::vector<Scalar>(model::base_motions(r_.robot) + r_.robot.joints.size())};
    for (std::size_t j = links; j-- > 0;) take(j, result);
    return result;
  }

 private:
  void take(std::size_t j, LinkWrenches& result) {
    const MovingJoint& joint = r_.joints[j];
    const Wrench own = link_wrench(joint.inertia, motions_.states[j].u, motions_.states[j].v, r_.suggest);
    const Wrench total = own + behind_[j];
    result.wrenches[j] = total;
    for (const Way& way : ways_of(r_.p.chain.links[j]))
      result.forces[way.coordinate] =
          (way.slides ? r_.p.per_unit * total.force[way.axis] : total.moment[way.axis]) + joint.drive;
    if (joint.parent == no_link && joint.moving != Motion::none) return;
    const Wrench inward = carried_inward(j, own, behind_[j]);
    if (joint.parent != no_link) behind_[joint.parent] = behind_[joint.parent] + inward;
  }

  /// Minus the wrench on the tool, about the origin of the last link in that link's frame, which has not
  /// turned by its joint's angle if that is so chosen. Forces are per unit of length.
  Wrench wrench_to_balance(const Circle& last) {
    const auto component = [&](std::size_t k) { return r_.symbol(wrench_component(k)); };
    const Circle yaw = circle(r_.p.chain.yaw, r_.graph);
    const Vector3 force = outward(unrotate(2, yaw, {component(0), component(1), component(2)}));
    const Vector3 moment = outward(unrotate(2, yaw, {component(3), component(4), component(5)}));
    const bool turned = r_.choices.last_link_unrotated && r_.joints.back().moving == Motion::revolute;
    const Vector3 tool = turned ? rotate(2, last, r_.p.chain.tool) : r_.p.chain.tool;
    const Vector3 scaled = r_.p.unit * force;
    return {-scaled, -(moment + cross(tool, scaled))};
  }

  /// A vector of the frame that link 0 starts from, in the last link's frame.
  Vector3 outward(Vector3 v) {
    Vector3 arriving;
    for (std::size_t j = 0; j < r_.joints.size(); ++j) {
      if (r_.is_parallel(j))
        r_.suggest(unrotate(2, sum_of(r_.joints[j - 1].angle, r_.joints[j].angle), arriving));
      arriving = unrotate(0, r_.joints[j].alpha, v);
      v = unrotate(2, r_.joints[j].angle, arriving);
    }
    return v;
  }

  /// The wrench on link j and all behind it, in the frame of the link before and about its origin.
  Wrench carried_inward(std::size_t j, const Wrench& own, const Wrench& behind) {
    const MovingJoint& joint = r_.joints[j];
    const Wrench total = own + behind;
    const Wrench at_axis = shifted(total, joint.d);
    const Wrench turned{rotate(2, joint.angle, total.force), rotate(2, joint.angle, at_axis.moment)};
    r_.suggest(shifted({turned.force, rotate(2, joint.angle, total.moment)}, joint.d).moment);
    if (const auto place = motions_.unrotated.find(j); place != motions_.unrotated.end())
      offer_sum_unrotated(j, place->second, behind);
    if (joint.next.size() == 1 && r_.is_parallel(joint.next.front())) offer_parallel_inward(j, own);
    const Vector3 force = rotate(0, joint.alpha, turned.force);
    Vector3 moment = rotate(0, joint.alpha, turned.moment);
    moment = moment + cross(Vector3{joint.a, joint.b, Scalar()}, force);
    last_shifted_[j] = at_axis;
    return {force, moment};
  }

  /// About a point d further in along z.
  static Wrench shifted(const Wrench& w, const Scalar& d) {
    return {w.force, {w.moment[0] - d * w.force[1], w.moment[1] + d * w.force[0], w.moment[2]}};
  }

  void offer_sum_unrotated(std::size_t j, const Wrench& own, const Wrench& behind) {
    const MovingJoint& joint = r_.joints[j];
    const Wrench turned{rotate(2, joint.angle, behind.force),
                        rotate(2, joint.angle, shifted(behind, joint.d).moment)};
    r_.suggest((own + turned).force);
    r_.suggest(own.moment + turned.moment);
    r_.suggest({own.moment[2] + behind.moment[2]});
  }

  /// The moment behind joint j + 1 turned by both angles at once, its offset's part by the first alone.
  void offer_parallel_inward(std::size_t j, const Wrench& own) {
    const MovingJoint& joint = r_.joints[j];
    const MovingJoint& next = r_.joints[joint.next.front()];
    if (!next.b.is_zero()) return;
    const Circle both = sum_of(joint.angle, next.angle);
    const Wrench& outer = last_shifted_.at(joint.next.front());
    const Vector3 direct = rotate(2, both, outer.moment);
    const Vector3 force = rotate(2, next.angle, outer.force);
    const Scalar z = outer.force[2];
    const Vector3 lever = {next.a * joint.angle.sine * z, -(next.a * joint.angle.cosine * z),
                           next.a * force[1]};
    const Vector3 lever_2 = rotate(2, joint.angle, {Scalar(), -(next.a * z), Scalar()});
    for (const Vector3& offset : {lever, lever_2}) {
      const Vector3 behind =
          Vector3{direct[0], direct[1], Scalar()} + Vector3{offset[0], offset[1], Scalar()};
      r_.suggest(behind);
      r_.suggest(rotate(2, joint.angle, own.moment) + behind);
      if (const auto place = motions_.unrotated.find(j); place != motions_.unrotated.end())
        r_.suggest(place->second.moment + behind);
    }
    r_.suggest(rotate(2, both, outer.force));
  }

  const Recursion& r_;
  const LinkMotions& motions_;
  std::vector<Wrench> behind_;  ///< by link, the sum over those that it carries
  std::map<std::size_t, Wrench> last_shifted_;
};

}  // namespace

LinkWrenches link_wrenches(const Recursion& recursion, const LinkMotions& motions) {
  return Inward(recursion, motions).run();
}

}  // namespace qvgen::derive::dynamics
