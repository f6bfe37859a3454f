// SPDX-License-Identifier: MIT
#pragma once

#include "description/tree/tree.h"
#include "description/xml/mjcf_settings.h"
#include "description/xml/orientation.h"

namespace qvgen::description::xml {

/// The numbers of an MJCF's bodies, joints and sites.
class MjcfNumbers {
 public:
  MjcfNumbers(Context& context, const MjcfSettings& settings)
      : MjcfNumbers(context, settings, context.options.snap) {}
  MjcfNumbers(Context& context, const MjcfSettings& settings, const SnapOptions& snap)
      : context_(&context), settings_(settings), snap_(context, snap) {}
  /// pos and whatever gives the orientation.
  [[nodiscard]] model::Displacement frame(const Element& element) const;
  /// The joint, whose attributes are complete, about a point of the body's frame: before, motion, after.
  /// Nothing if it is of a type that no chain has.
  [[nodiscard]] std::optional<tree::Segment> joint(const Element& joint, const std::string& name) const;
  /// The motor of a fixed tendon, whose value is the tendon's length: rad if it `turns` joints, else m.
  [[nodiscard]] model::Motor tendon_motor(const Element& tendon, const std::string& name, bool turns) const;
  /// Value of a joint where the body stands as the file has it.
  [[nodiscard]] model::Expression reference(const Element& joint) const;
  /// An angle that is in radians whatever the file's unit.
  [[nodiscard]] model::Expression radians(const Decimal& written) const { return snap_.angle(written); }
  static bool is_hinge(const Element& joint);
  /// Returns how the copy of that number of a <replicate> is turned.
  [[nodiscard]] std::vector<model::Turn> turns_of_copy(const Element& replicate, long copy) const;
  [[nodiscard]] model::Vector3 offset_of_copies(const Element& replicate) const;

 private:
  [[nodiscard]] model::Expression angle(const Decimal& written) const;
  [[nodiscard]] std::vector<model::Turn> turns(const Element& element) const;
  [[nodiscard]] std::vector<model::Turn> euler(const std::vector<Decimal>& angles) const;
  [[nodiscard]] std::vector<model::Turn> other_turns(const Element& element) const;
  [[nodiscard]] std::optional<model::Limits> limits(const Element& joint, const std::string& name,
                                                    bool hinge) const;
  [[nodiscard]] std::optional<model::Expression> greatest_effort(const Element& joint) const;
  [[nodiscard]] model::Drive drive(const Element& joint) const;
  /// True if the first numbers are all 0, which is reported.
  [[nodiscard]] bool is_zero(const Attribute& attribute, const std::vector<Decimal>& numbers,
                             std::size_t count) const;

  Context* context_;
  MjcfSettings settings_;
  Snap snap_;
};

}  // namespace qvgen::description::xml
