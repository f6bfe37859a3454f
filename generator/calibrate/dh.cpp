// SPDX-License-Identifier: MIT
#include "calibrate/dh.h"

#include <numbers>

#include <fmt/format.h>

#include "calibrate/result.h"

namespace qvgen::calibrate {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double tiny = 1e-9;

struct Line {
  Vector3d point, axis;
};

/// Axes in the world with all joints at zero, and the tool.
struct Lines {
  std::vector<Line> axes;
  Isometry3d tool;
};

Vector3d vector(const Vec<double>& v) { return {v[0], v[1], v[2]}; }

Isometry3d isometry(const Rigid<double>& m) {
  Isometry3d result = Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) result.linear().col(i) = vector(m.axes[static_cast<std::size_t>(i)]);
  result.translation() = vector(m.position);
  return result;
}

/// Returns the lines of the arm: the described one, or the one that was found.
Lines lines_of(const Calibration& found, bool with_errors) {
  const Model<double>& model = found.identifiable.model;
  Lines lines;
  Rigid<double> at = identity(1.0);
  for (std::size_t i = 0; i < model.geometry.gaps.size(); ++i) {
    const Gap<double>& gap = model.geometry.gaps[i];
    at = at * gap.way;
    if (with_errors) at = at * error_of(model, found.state, i + 1);
    if (i < model.geometry.joints.size())
      lines.axes.push_back({vector(at.position), vector(turned(at, gap.directions[2]))});
  }
  lines.tool = isometry(at);
  return lines;
}

Isometry3d frame(const Vector3d& x, const Vector3d& z, const Vector3d& origin) {
  Isometry3d result = Isometry3d::Identity();
  result.linear() << x, z.cross(x), z;
  result.translation() = origin;
  return result;
}

double angle_about(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  return std::atan2(axis.dot(from.cross(to)), from.dot(to));
}

Isometry3d motion_of(const DhRow& row) {
  using Eigen::AngleAxisd;
  return Isometry3d(AngleAxisd(row.theta, Vector3d::UnitZ()) * Eigen::Translation3d(row.a, 0, row.d) *
                    AngleAxisd(row.alpha, Vector3d::UnitX()) * AngleAxisd(row.beta, Vector3d::UnitY()));
}

/// Goes along the axes, frame by frame.
class Walker {
 public:
  /// `described`: directions of the normals before, to which those after are the nearer ones; empty: none
  /// yet.
  Walker(const Lines& lines, const std::vector<bool>& keeps_d, const DhRows* before,
         std::vector<Vector3d>& normals)
      : lines_(lines), keeps_d_(keeps_d), before_(before), normals_(normals) {}

  DhRows walk() {
    const Line& first = lines_.axes.front();
    // The first axis says where z is; where x is, and where on the axis, are as described.
    const Vector3d before = before_ == nullptr ? Vector3d::UnitX() : Vector3d(before_->base.linear().col(0));
    const Vector3d across = before - before.dot(first.axis) * first.axis;
    const Vector3d x = across.norm() > 0.1 ? across.normalized() : first.axis.unitOrthogonal();
    at_ = frame(x, first.axis, first.point);
    DhRows result{at_, {}, {}};
    for (std::size_t i = 0; i < lines_.axes.size(); ++i) {
      result.rows.push_back(i + 1 < lines_.axes.size() ? row(i) : DhRow{0, last_offset(), 0, 0, 0});
      at_ = at_ * motion_of(result.rows.back());
    }
    result.tool = at_.inverse() * lines_.tool;
    return result;
  }

 private:
  [[nodiscard]] Vector3d z() const { return at_.linear().col(2); }
  /// The last row goes along its axis as far as the tool is; the tool's frame takes the rest.
  [[nodiscard]] double last_offset() const {
    return (lines_.tool.translation() - at_.translation()).dot(z());
  }

  DhRow row(std::size_t i) {
    const Line& next = lines_.axes[i + 1];
    const Vector3d cross = z().cross(next.axis);
    const bool along = keeps_d_[i] || cross.norm() < tiny;
    return along ? level_row(i, next) : normal_row(i, next, cross);
  }

  /// The next axis through the plane that is perpendicular to this one at the described d.
  DhRow level_row(std::size_t i, const Line& next) {
    DhRow row;
    row.d = before_ == nullptr ? 0 : before_->rows[i].d;
    const Vector3d from = at_.translation() + row.d * z();
    const double along = (from - next.point).dot(z()) / next.axis.dot(z());
    const Vector3d way = next.point + along * next.axis - from;
    const Vector3d flat = way - way.dot(z()) * z();
    const Vector3d normal =
        remembered(i, flat.norm() > tiny ? flat.normalized() : at_.linear().col(0), flat.norm() > tiny);
    row.theta = angle_about(z(), at_.linear().col(0), normal);
    row.a = flat.dot(normal);
    row.beta = std::asin(std::clamp(next.axis.dot(normal), -1.0, 1.0));
    row.alpha = std::atan2(-next.axis.dot(z().cross(normal)), next.axis.dot(z()));
    return row;
  }

  /// The common normal of two axes that are not parallel.
  DhRow normal_row(std::size_t i, const Line& next, const Vector3d& cross) {
    const Vector3d between = next.point - at_.translation();
    const double square = cross.squaredNorm();
    const Vector3d normal = remembered(i, cross / std::sqrt(square), false);
    DhRow row;
    row.d = between.cross(next.axis).dot(cross) / square;
    row.a = between.dot(normal);
    row.theta = angle_about(z(), at_.linear().col(0), normal);
    row.alpha = angle_about(normal, z(), next.axis);
    return row;
  }

  /// Returns the direction or its opposite. After: the one nearer to that before. Before: one that leads to
  /// the next axis, else one next to the x axis.
  Vector3d remembered(std::size_t i, const Vector3d& direction, bool is_way) {
    if (before_ != nullptr) return direction.dot(normals_[i]) < 0 ? Vector3d(-direction) : direction;
    const Vector3d between = lines_.axes[i + 1].point - at_.translation();
    const double lead = between.dot(direction), near = direction.dot(at_.linear().col(0));
    const bool flips = !is_way && (std::abs(lead) > tiny ? lead < 0 : near < -tiny);
    normals_.push_back(flips ? Vector3d(-direction) : direction);
    return normals_.back();
  }

  const Lines& lines_;
  const std::vector<bool>& keeps_d_;
  const DhRows* before_;
  std::vector<Vector3d>& normals_;
  Isometry3d at_;
};

/// Rounding becomes zero.
double cleaned(double value) { return std::abs(value) < 1e-14 ? 0.0 : value; }

std::string motion_text(const char* name, const Isometry3d& m) {
  const Eigen::Quaterniond q(m.linear());
  const Vector3d p = m.translation().unaryExpr(&cleaned);
  return fmt::format(
      "# {}: x y z {:.13g} {:.13g} {:.13g} m, quaternion w x y z {:.13g} {:.13g} {:.13g} {:.13g}\n", name,
      p[0], p[1], p[2], cleaned(q.w()), cleaned(q.x()), cleaned(q.y()), cleaned(q.z()));
}

/// The difference of angles in (-pi, pi].
double turn_between(double before, double after) {
  return std::remainder(after - before, 2 * std::numbers::pi);
}

}  // namespace

DhChange dh_change(const Calibration& calibration, DhForm form) {
  const Lines before = lines_of(calibration, false), after = lines_of(calibration, true);
  std::vector<bool> keeps_d;
  constexpr double nearly_parallel = 1e-2;
  for (std::size_t i = 0; i + 1 < before.axes.size(); ++i)
    keeps_d.push_back(form == DhForm::hayati &&
                      before.axes[i].axis.cross(before.axes[i + 1].axis).norm() < nearly_parallel);
  DhChange change;
  std::vector<Vector3d> normals;
  change.before = Walker(before, keeps_d, nullptr, normals).walk();
  change.after = Walker(after, keeps_d, &change.before, normals).walk();
  return change;
}

std::string dh_text(const DhChange& change, DhForm form) {
  const bool beta = form == DhForm::hayati;
  std::string text = "# a row: turn(z, theta) shift(z, d) shift(x, a) turn(x, alpha)";
  text += beta ? " turn(y, beta)\n" : "\n";
  text += motion_text("base", change.after.base) + motion_text("tool", change.after.tool);
  text += "joint, theta [rad], d [m], a [m], alpha [rad]" + std::string(beta ? ", beta [rad]" : "");
  text += ", delta_theta [rad], delta_d [m], delta_a [m], delta_alpha [rad]";
  text += beta ? ", delta_beta [rad]\n" : "\n";
  for (std::size_t i = 0; i < change.after.rows.size(); ++i) {
    const DhRow &from = change.before.rows[i], &to = change.after.rows[i];
    text += fmt::format("{}, {:.12g}, {:.12g}, {:.12g}, {:.12g}", i + 1, to.theta, to.d, to.a, to.alpha);
    if (beta) text += fmt::format(", {:.12g}", to.beta);
    text += fmt::format(", {:.12g}, {:.12g}, {:.12g}, {:.12g}", cleaned(turn_between(from.theta, to.theta)),
                        cleaned(to.d - from.d), cleaned(to.a - from.a),
                        cleaned(turn_between(from.alpha, to.alpha)));
    text += beta ? fmt::format(", {:.12g}\n", cleaned(to.beta - from.beta)) : "\n";
  }
  return text;
}

}  // namespace qvgen::calibrate
