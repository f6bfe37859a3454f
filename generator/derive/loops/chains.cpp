// SPDX-License-Identifier: MIT
#include "derive/loops/chains.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "derive/loops/gears.h"
#include "derive/loops/in_space.h"
#include "derive/loops/named_angles.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"
#include "model/inverse.h"
#include "model/private_names.h"
#include "model/replace.h"

namespace qvgen::derive::loops {
namespace {

using model::Displacement;
using model::Joint;
using Joints = std::vector<std::size_t>;

constexpr std::size_t most_joints = 6;

bool contains(const Joints& joints, std::size_t joint) {
  return std::find(joints.begin(), joints.end(), joint) != joints.end();
}

/// A joint of the ring, with the constant frames before and behind its motion. The slide of a closure has no
/// index.
struct Link {
  std::optional<std::size_t> joint;
  Joint moves;
};

Joint turned_back(const Joint& joint) {
  Joint back = joint;
  back.before = model::inverse(joint.after);
  back.after = model::inverse(joint.before);
  back.axis = model::subtract({}, joint.axis);
  return back;
}

/// A joint without masses, limits and the place where it hangs.
Joint bare(const Joint& joint) {
  Joint result;
  result.type = joint.type;
  result.variable = joint.variable;
  result.before = joint.before;
  result.axis = joint.axis;
  result.after = joint.after;
  return result;
}

/// The ring of a loop, from the common link along the first side to the closure and back along the second.
std::vector<Link> ring_of(const model::Mechanism& mechanism, const Cycle& cycle) {
  const model::Loop& loop = mechanism.loops.closures[cycle.number - 1];
  std::vector<Link> ring;
  for (const std::size_t joint : cycle.sides[0].joints)
    ring.push_back({joint, bare(mechanism.robot.joints[joint])});
  const Displacement to_point{{}, loop.points[0]};
  const Displacement from_point{loop.turns, model::rotate(loop.turns, model::subtract({}, loop.points[1]))};
  Displacement closure = model::compose(to_point, from_point);
  if (cycle.type == model::LoopType::slide) {
    Joint slide;
    slide.type = model::JointType::prismatic;
    slide.variable = "slide_of_loop_" + std::to_string(cycle.number);
    slide.before = to_point;
    slide.axis = *loop.axis;
    ring.push_back({std::nullopt, slide});
    closure = from_point;
  }
  if (!ring.empty()) ring.back().moves.after = model::compose(ring.back().moves.after, closure);
  const auto& back = cycle.sides[1].joints;
  for (auto joint = back.rbegin(); joint != back.rend(); ++joint) {
    ring.push_back({*joint, turned_back(bare(mechanism.robot.joints[*joint]))});
    if (ring.size() == 1) ring[0].moves.before = model::compose(closure, ring[0].moves.before);
  }
  return ring;
}

/// A chain of links; what hangs on the whole robot alone is left out.
model::Robot robot_of(const model::Robot& whole, const std::string& name, const std::string& title,
                      const std::vector<Link>& links) {
  model::Robot robot;
  robot.name = whole.name + "_" + name;
  robot.title = whole.title + ", " + title;
  robot.source = whole.source;
  robot.geometry = whole.geometry;
  robot.definitions = whole.definitions;
  for (const Link& link : links) {
    robot.joints.push_back(link.moves);
    Joint& joint = robot.joints.back();
    joint.before = model::compose(robot.tool, joint.before);
    robot.tool = joint.after;
    joint.after = {};
  }
  return robot;
}

std::string names_of(const model::Mechanism& mechanism, const Joints& joints) {
  std::string text;
  for (const std::size_t joint : joints)
    text += (text.empty() ? "" : ", ") + mechanism.robot.joints[joint].variable;
  return text;
}

/// The links of a ring, the unknown ones first; how many these are.
struct Parted {
  std::vector<Link> links;
  std::size_t unknown = 0;
  bool is_parted = false;  ///< false: known ones are between unknown ones
};

Parted parted(std::vector<Link> ring, const Joints& known) {
  const auto is_known = [&](const Link& link) { return link.joint && contains(known, *link.joint); };
  Parted result;
  // From behind a known link to an unknown one.
  for (std::size_t i = 0; i < ring.size() && (!is_known(ring.back()) || is_known(ring.front())); ++i)
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
  const auto first_known = std::find_if(ring.begin(), ring.end(), is_known);
  result.is_parted = std::all_of(first_known, ring.end(), is_known);
  result.unknown = static_cast<std::size_t>(first_known - ring.begin());
  result.links = std::move(ring);
  return result;
}

/// The longest of a robot's offsets, m, rounded to a power of two.
cln::cl_RA length_of(const model::Robot& robot) {
  const model::Bindings values = model::sample_geometry(robot);
  double longest = 1e-3;
  for (const Joint& joint : robot.joints)
    for (const Displacement* frame : {&joint.before, &joint.after})
      for (const model::Expression& each : frame->translation)
        longest = std::max(longest, std::abs(model::to_double(model::evaluate(each, values))));
  const int power = std::ilogb(longest);
  return power < 0 ? cln::recip(cln::expt(cln::cl_RA(2), -power)) : cln::expt(cln::cl_RA(2), power);
}

/// Takes other frames for the ends of both chains. A chain of few joints takes a part of a pose: the point,
/// say. That tells nothing of a turn about an axis through the point, and a loop of few joints that moves
/// does turn about the axes of its rest: so the point has to be beside them.
void go_aside(const model::Robot& whole, LoopChain& loop) {
  const cln::cl_RA length = length_of(whole);
  const auto part = [&](long of, long in) { return model::Expression(length * of / in); };
  const Displacement aside{{}, {part(3, 7), part(5, 11), part(-4, 13)}};
  for (model::Robot* robot : {&loop.chain, &loop.rest}) robot->tool = model::compose(robot->tool, aside);
}

LoopChain chain_of(const model::Robot& whole, const Cycle& cycle, const Parted& ring,
                   const std::string& way) {
  const auto middle = ring.links.begin() + static_cast<std::ptrdiff_t>(ring.unknown);
  const std::vector<Link> held(ring.links.begin(), middle);
  std::vector<Link> rest(middle, ring.links.end());
  std::reverse(rest.begin(), rest.end());
  for (Link& link : rest) link.moves = turned_back(link.moves);
  const std::string loop = "loop_" + std::to_string(cycle.number) + way;
  const std::string title = "loop " + std::to_string(cycle.number);
  LoopChain result;
  result.cycle = cycle.number - 1;
  result.chain = robot_of(whole, loop, title + ": the joints that it holds", held);
  result.rest = robot_of(whole, "rest_of_" + loop, "the rest of " + title, rest);
  for (const Link& link : held) result.joints.push_back(link.joint);
  for (const Link& link : rest) result.rest_joints.push_back(*link.joint);
  if (result.joints.size() < most_joints) go_aside(whole, result);
  return result;
}

/// `way`: end of the chain's name, for the joints that are given.
ChainOrReason chain_of(const model::Mechanism& mechanism, const Cycle& cycle, const Joints& known,
                       const std::string& way) {
  Joints open = cycle.joints();
  std::erase_if(open, [&](std::size_t joint) { return contains(known, joint); });
  const bool slides = cycle.type == model::LoopType::slide;
  const std::size_t most = most_joints - (slides ? 1 : 0);
  const std::string kind = slides ? "slide" : "weld";
  if (open.size() > most)
    return {{},
            "its " + kind + " holds " + std::to_string(most) + " joints in space, and " +
                names_of(mechanism, open) + " are open; drive all but " + std::to_string(most) +
                " of them, or close the loops that hold them before it"};
  if (open.size() == cycle.joints().size())
    return {{}, "none of its joints has a value: it holds itself; drive one of " + names_of(mechanism, open)};
  const Parted ring = parted(ring_of(mechanism, cycle), known);
  if (!ring.is_parted)
    return {{},
            "joints with values are between those that its " + kind + " holds, " + names_of(mechanism, open) +
                "; drive joints that follow each other around the loop"};
  return {chain_of(mechanism.robot, cycle, ring, way), ""};
}

/// The chains from given joints on, and from those that gears lead by these.
std::vector<LoopChain> chains_from(const model::Mechanism& mechanism, const std::vector<Cycle>& cycles,
                                   const Joints& given, const std::string& way) {
  std::vector<LoopChain> chains;
  Joints known = given;
  for (const Geared& geared : geared_by(cycles, given)) known.push_back(geared.joint);
  std::vector<bool> is_closed(cycles.size(), false);
  for (bool found = true; found;) {
    found = false;
    for (std::size_t i = 0; i < cycles.size(); ++i) {
      if (is_closed[i] || !is_rigid_in_space(cycles[i])) continue;
      const Joints joints = cycles[i].joints();
      is_closed[i] = std::all_of(joints.begin(), joints.end(), [&](auto j) { return contains(known, j); });
      if (is_closed[i]) continue;
      const auto chain = chain_of(mechanism, cycles[i], known, way).chain;
      if (!chain) continue;
      chains.push_back(*chain);
      for (const std::size_t joint : chain->held()) known.push_back(joint);
      found = is_closed[i] = true;
    }
  }
  return chains;
}

bool are_alike(const LoopChain& a, const LoopChain& b) {
  return a.cycle == b.cycle && a.joints == b.joints && a.rest_joints == b.rest_joints;
}

}  // namespace

Joints LoopChain::held() const {
  Joints result;
  for (const auto& joint : joints)
    if (joint) result.push_back(*joint);
  return result;
}

ChainOrReason chain_of(const model::Mechanism& mechanism, const Cycle& cycle, const Joints& known) {
  return chain_of(mechanism, cycle, known, "");
}

std::vector<LoopChain> chains_of(const model::Mechanism& mechanism, const std::vector<Cycle>& cycles,
                                 const Joints& given) {
  const model::Loops& loops = mechanism.loops;
  const bool are_driven = given == loops.actuated;
  if (!are_driven && given != loops.outputs) return {};
  const auto from_motors = chains_from(mechanism, cycles, loops.actuated, "");
  if (are_driven) return from_motors;
  auto chains = chains_from(mechanism, cycles, given, "_from_outputs");
  for (LoopChain& each : chains)
    for (const LoopChain& other : from_motors)
      if (are_alike(each, other)) each = other;
  return chains;
}

std::vector<LoopChain> chains_of(const model::Mechanism& mechanism) {
  const auto& closures = mechanism.loops.closures;
  const auto is_rigid = [](const model::Loop& loop) {
    return loop.type == model::LoopType::weld || loop.type == model::LoopType::slide;
  };
  if (std::none_of(closures.begin(), closures.end(), is_rigid)) return {};
  try {
    const model::Robot robot = with_named_angles(model::with_private_names(mechanism.robot));
    const auto cycles = cycles_of(mechanism, robot, scope_of(robot, mechanism.loops));
    auto chains = chains_of(mechanism, cycles, mechanism.loops.actuated);
    if (mechanism.loops.outputs.empty()) return chains;
    for (LoopChain& each : chains_of(mechanism, cycles, mechanism.loops.outputs))
      if (std::none_of(chains.begin(), chains.end(),
                       [&](const LoopChain& other) { return other.chain.name == each.chain.name; }))
        chains.push_back(std::move(each));
    return chains;
  } catch (const std::domain_error&) {
    return {};  // the assembly says why
  }
}

}  // namespace qvgen::derive::loops
