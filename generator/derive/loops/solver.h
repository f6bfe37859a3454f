// SPDX-License-Identifier: MIT
// Steps that solve closures for the joints that they hold, each with the equation of inverse kinematics that
// fits.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "derive/inverse/builder.h"
#include "derive/loops/cycle.h"
#include "derive/loops/gears.h"

namespace qvgen::derive::loops {

/// Appends steps to a plan; joints become known one after the other.
class Solver {
 public:
  Solver(const model::Robot& robot, inverse::Scope& scope, inverse::Builder& builder);

  /// Makes a joint known by the names of its value.
  void know(std::size_t joint);
  /// Joints of a cycle that are not known yet.
  [[nodiscard]] std::vector<std::size_t> unknown(const Cycle& cycle) const;

  // Each returns an empty text if it has appended its steps, or why the equation does not serve.

  /// True if the length of a rod is a number or the value of a known slide.
  [[nodiscard]] bool knows_length(const Cycle& cycle) const;

  /// Distance of two points, for the one unknown joint, which may be the rod's length.
  std::string rod(const Cycle& cycle);
  /// A common point of links that move in one plane, for two unknown joints.
  std::string meeting(const Cycle& cycle);
  /// Three distances to points of one link that three slides at right angles carry.
  std::string three_spheres(const std::vector<const Cycle*>& cycles);

  /// Values that sum up, for the one unknown joint. `is_needed`: by other equations, too.
  std::string gear(const Cycle& cycle, const Geared& gear, bool is_needed);
  /// Says that a joint that leads by a polynomial is not found by that.
  [[nodiscard]] std::string no_root(const Cycle& cycle) const;

  /// Two links of a plane that are one, for three unknown joints.
  std::string weld(const Cycle& cycle);
  /// Two links of a plane that slide along each other, for two unknown joints.
  std::string slide(const Cycle& cycle);

  /// A closure as the distance of two points: a rod, or a pin behind a turn (`pivot`) that no other open
  /// closure holds, whose circle the pin is on.
  struct Span {
    const Cycle* cycle;
    std::optional<std::size_t> pivot;
  };
  /// Unknown joints that a span holds, sorted; not its pivot.
  [[nodiscard]] std::vector<std::size_t> held(const Span& span) const;
  /// Two distances, for the two turns that both hold.
  std::string two_turns(const std::array<Span, 2>& spans);
  /// Three distances, for the two slides and the turn of a platform.
  std::string planar_platform(const std::array<Span, 3>& spans);

  /// A ball in space at the end of a leg that swings in a plane, whatever its two joints are.
  struct Swing {
    const Cycle* cycle;
    std::vector<std::size_t> leg;   ///< its two joints
    std::vector<std::size_t> held;  ///< two slides and a turn of the platform, sorted
  };
  /// A closure as such a leg, if it is one.
  [[nodiscard]] std::optional<Swing> swing_of(const Cycle& cycle) const;
  /// Three of them, for the platform, then the legs.
  std::string three_planes(const std::array<Swing, 3>& swings);

 private:
  /// An unknown joint's place: side and index there.
  struct Place {
    const Side* side;
    const Side* other;
    int index;
    std::size_t joint;
  };
  [[nodiscard]] Place place_of(const Cycle& cycle, std::size_t joint) const;
  [[nodiscard]] bool turns(std::size_t joint) const;
  [[nodiscard]] inverse::Screw screw_of(std::size_t joint);
  [[nodiscard]] Carrier carrier();
  symbolic::Vector kept(const symbolic::Vector& v);
  GiNaC::ex kept(const GiNaC::ex& value);
  inverse::Flat kept(const inverse::Flat& v) { return {kept(v.x), kept(v.y)}; }
  /// The other side's end in the frame in front of a joint.
  symbolic::Vector goal(const Place& at);
  /// How that moves with a slide, which is on either side or in front of the joint.
  symbolic::Vector goal_by(const Place& at, const Place& slide);
  void pair(const Place& at, const std::string& equation);

  /// A direction turned as many times as far.
  inverse::Flat power(inverse::Flat base, int exponent);
  std::string turn_by_gear(const Cycle& cycle, const Geared& gear);
  std::string slide_by_gear(const Cycle& cycle, const Geared& gear);
  [[nodiscard]] std::string no_whole_turns(const std::string& variable, const Geared& gear) const;
  [[nodiscard]] std::string no_powers(const Cycle& cycle) const;

  /// Finds a turn by the direction that both links of a weld or a slide have.
  void turn_by_direction(const Cycle& cycle, const Place& at);
  /// The direction across the line of a slide, in the common link's frame.
  [[nodiscard]] symbolic::Vector line_across(const Carrier& carrier, const Cycle& cycle) const;
  std::string slide_of_turns(const Cycle& cycle, const Place& u, const Place& v);
  Cycle cut_at(const Cycle& weld, const Place& at);
  std::string weld_cut_at(const Cycle& cycle, const Place& at);

  using Values = std::map<std::size_t, inverse::Scope::Turn>;
  /// Carries with values of unknown joints.
  [[nodiscard]] Carrier carrier_at(const Values& values);
  /// The way between both ends of a span in the common link's frame, from that of the second side, and the
  /// square that its length has to have, at values of unknown joints.
  struct Ends {
    symbolic::Vector way;
    GiNaC::ex square;
  };
  Ends ends(const Span& span, const Values& values);
  /// Finds the pivot, once all else is known.
  void turn_pivot(const Span& span);
  struct PlatformJoints {
    std::size_t x, y, turn;
  };
  struct Leg;
  [[nodiscard]] inverse::Flat at(const Leg& leg, const inverse::Scope::Turn& turn) const;
  /// Returns nothing if the joints do not make a platform in a plane.
  std::optional<Leg> leg_of(const Span& span, const PlatformJoints& joints);

  [[nodiscard]] bool holds_platform(const Swing& swing) const;
  [[nodiscard]] bool swings_in_plane(const Swing& swing) const;
  struct Plane;
  Plane plane_of(const Swing& swing, const PlatformJoints& platform);

  void stretch(const Cycle& cycle);
  std::string slide_by_rod(const Cycle& cycle, const Place& at);
  std::string two_turns(const Cycle& cycle, Place u, Place v);
  std::string turn_and_slide(const Cycle& cycle, const Place& turn, const Place& slide);
  std::string two_slides(const Cycle& cycle, const Place& s, const Place& t);

  const model::Robot& robot_;
  inverse::Scope& scope_;
  inverse::Builder& builder_;
  std::set<std::size_t> known_;
  int names_ = 0;
};

}  // namespace qvgen::derive::loops
