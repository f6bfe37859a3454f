// SPDX-License-Identifier: MIT
#include "calibrate/urdf.h"

#include <stdexcept>

#include "calibrate/result.h"
#include "description/xml/urdf_edit.h"

namespace qvgen::calibrate {
namespace {

using description::xml::UrdfEdit;
using description::xml::UrdfOrigin;
using description::xml::UrdfStep;

/// Returns roll, pitch and yaw. Next to a pitch of 90 degrees the roll is what the yaw leaves, so that both
/// together are exact.
UrdfOrigin origin_of(const Rigid<double>& m) {
  const auto& [x, y, z] = m.axes;
  const double pitch = std::atan2(-x[2], std::hypot(x[0], x[1]));
  const bool locked = std::hypot(x[0], x[1]) < 1e-12;
  const double yaw = locked ? 0 : std::atan2(x[1], x[0]);
  const double c = std::cos(yaw), s = std::sin(yaw);
  const double roll = std::atan2(s * z[0] - c * z[1], c * y[1] - s * y[0]);
  return {m.position, {roll, pitch, yaw}};
}

/// Sets the axis where the file's digits are fewer than those of the arm that was calibrated.
void set_axis(UrdfEdit& edit, std::size_t step, const Vec<double>& axis) {
  const Vec<double> written = edit.steps()[step].axis;
  const Vec<double> unit = (1 / std::sqrt(dot(written, written))) * written;
  const Vec<double> difference = unit - axis;
  if (dot(difference, difference) > 1e-24) edit.set_axis(step, axis);
}

/// Goes along the chain. Within a gap the joint at its end takes what the fixed ones before it leave.
class Writer {
 public:
  Writer(UrdfEdit& edit, const Calibration& found) : edit_(edit), found_(found) {}

  void write() {
    std::size_t gap = 0;
    for (std::size_t step = 0; step < edit_.steps().size(); ++step) {
      const UrdfStep& each = edit_.steps()[step];
      if (each.has_offset)
        throw std::runtime_error(
            "the joint '" + each.joint +
            "' follows another one with an offset: write TOML, or take the offset into its origin");
      const bool last = step + 1 == edit_.steps().size();
      if (each.moves) {
        place(step, gap);
        set_axis(edit_, step, geometry().gaps[gap].directions[2]);
        fixed_ = identity(1.0);
        ++gap;
      } else if (last) {
        place(step, gap);
      } else {
        fixed_ = fixed_ * rigid_of(each.origin);
      }
      if (last && each.moves) add_tip(gap);
    }
  }

 private:
  [[nodiscard]] const Geometry<double>& geometry() const { return found_.identifiable.model.geometry; }
  [[nodiscard]] Rigid<double> way(std::size_t gap) const {
    return geometry().gaps.at(gap).way * error_of(found_.identifiable.model, found_.state, gap + 1);
  }
  void place(std::size_t step, std::size_t gap) {
    edit_.set_origin(step, origin_of(inverse(fixed_) * way(gap)));
  }
  void add_tip(std::size_t gap) {
    const Rigid<double> rest = way(gap), none = identity(1.0);
    const bool same = rest.position == none.position && rest.axes == none.axes;
    if (!same) edit_.add_tip(origin_of(rest));
  }

  UrdfEdit& edit_;
  const Calibration& found_;
  Rigid<double> fixed_ = identity(1.0);
};

}  // namespace

Rigid<double> rigid_of(const UrdfOrigin& origin) {
  Rigid<double> result = identity(1.0);
  for (std::size_t i = 3; i-- > 0;)
    result =
        result * turn(identity(1.0).axes.at(i), std::cos(origin.rpy.at(i)), std::sin(origin.rpy.at(i)), 1.0);
  result.position = origin.xyz;
  return result;
}

std::string calibrated_urdf(const std::string& text, const description::ReadOptions& options,
                            const Calibration& calibration, const std::string& head) {
  UrdfEdit edit(text, options);
  Writer(edit, calibration).write();
  edit.add_comment(head);
  return edit.text();
}

}  // namespace qvgen::calibrate
