// SPDX-License-Identifier: MIT
// Joints that <equality> ties to others, as joints that follow them.
//
// For joints, and likewise for lengths of fixed tendons, which are sums of multiples of joints, MuJoCo keeps
// y - y0 = a0 + a1 (x - x0) + a2 (x - x0)^2 + ..., where y0 and x0 are the values in the file's pose. Powers
// are read of joints, not of tendons. The first joint of a <joint> follows the second; of tendons the joint
// that is named last follows the others. Joints that motors move by fixed tendons follow these
// (mjcf_motors.h).
#pragma once

#include <map>
#include <set>

#include "description/xml/mjcf_motors.h"
#include "description/xml/mjcf_numbers.h"
#include "description/xml/mjcf_tree.h"

namespace qvgen::description::xml {

class MjcfCouplings {
 public:
  MjcfCouplings(Context& context, const MjcfModel& model, const MjcfTree& tree);
  /// The joints that a joint follows, and how; nothing if it follows none. Mistakes are reported.
  std::optional<tree::Mimic> of(const std::string& joint);
  /// True if a joint follows by powers of another, which whole robots have.
  [[nodiscard]] bool follow_powers() const;
  /// Joints whose value is the length of a tendon with a motor.
  [[nodiscard]] const std::set<std::string>& driven_by_lengths() const { return driven_by_lengths_; }

 private:
  using Sum = JointSum;
  struct Relation {
    Place place;
    const Element* element;  ///< of the first relation of this joint
    Sum leaders;             ///< differences from the file's pose
    Decimal constant;
    cln::cl_RA of_constant = 1;  ///< its factor
    bool is_again = false;       ///< another element has a relation of this joint
    std::vector<cln::cl_RA> powers =
        {};  ///< factors of the only leader's square, cube, ...; the last is not 0
  };

  void read(const Element& element);
  void read_joint(const Element& element);
  void read_tendons(const Element& element);
  [[nodiscard]] bool has_more(const Element& section) const;
  void add(const std::string& follower, Relation relation);
  [[nodiscard]] Sum joints_of_tendon(const std::string& name, std::string* last);
  void read_motors(const MjcfModel& model);
  void tell_of_group(const TendonGroup& group, const std::map<std::string, const Element*>& actuators);
  void add_group(const MjcfModel& model, const TendonGroup& group,
                 const std::map<std::string, const Element*>& actuators);
  /// A value of the form a + b pi: sums of such do not grow.
  struct Value {
    cln::cl_RA plain = 0, half_turns = 0;
    void add(const cln::cl_RA& factor, const Value& other);
  };
  struct Followed {
    Sum sum;  ///< of joints that follow none
    Value offset;
    std::vector<cln::cl_RA> powers = {};  ///< as of a relation, of the value less `from`
    Value from = {};
  };
  const Followed* followed(const std::string& joint, std::set<std::string>& above);
  std::optional<Followed> resolved(const std::string& joint, std::set<std::string>& above);
  bool is_wrong(const std::string& joint, const std::set<std::string>& above) const;
  bool add_powers(const std::string& joint, const Relation& relation, const Followed* leader, Followed& to);
  [[nodiscard]] Value in_pose(const std::string& joint) const;
  [[nodiscard]] Value constant_of(const std::string& joint, const Relation& relation) const;
  static Value value_of(const model::Expression& expression);
  std::optional<Followed> in_leaders(const std::string& joint);
  /// A tendon's length as a sum of joints that follow none; nothing if there are none, or it is reported.
  std::optional<Followed> length_of(const std::string& tendon);
  /// The motor of a tendon, and the joints that its group has.
  struct TendonMotor {
    tree::TendonMotor motor;
    Value in_pose;
  };

  Context* context_;
  std::map<std::string, const MjcfJoint*> joints_;
  std::map<std::string, const Element*> tendons_;  ///< the fixed ones
  std::set<std::string> used_;                     ///< tendons that tie joints
  std::map<std::string, TendonMotor> motors_;      ///< by key_of their tendons
  std::set<std::string> driven_by_lengths_;
  std::set<std::string> wrong_;  ///< joints whose relations are reported
  std::map<std::string, Relation> relations_;
  std::map<std::string, Followed> followed_;  ///< of those that were asked for
};

}  // namespace qvgen::description::xml
