// SPDX-License-Identifier: MIT
#include "report/linkage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "report/live_section.h"

namespace qvgen::report {
namespace {

/// Collects what each link carries: the base's points first, then those of the joints' links.
class LinkLines {
 public:
  explicit LinkLines(std::vector<Vector> origins) : origins_(std::move(origins)) {}

  void carry(std::size_t link, const Vector& point) {
    const bool is_base = link == model::base_link;
    if (is_base && !has_base_) {
      base_ = point;
      has_base_ = true;
    }
    const Vector& from = is_base ? base_ : origins_.at(link);
    if ((point - from).norm() > 1e-12) lines.push_back({from, point, is_base});
  }

  std::vector<PlacedLinkage::Line> lines;

 private:
  std::vector<Vector> origins_;
  Vector base_ = Vector::Zero();
  bool has_base_ = false;
};

/// Link frames of all joints in the world, and the joints themselves.
struct Frames {
  Motion base;
  std::vector<Motion> links;
  std::vector<Posture::Joint> joints;

  [[nodiscard]] const Motion& of(std::size_t link) const {
    return link == model::base_link ? base : links.at(link);
  }
};

Frames frames_of(const Linkage& linkage, const std::vector<double>& q) {
  Frames frames{linkage.chain.base.motion, {}, {}};
  for (std::size_t i = 0; i < linkage.chain.joints.size(); ++i) {
    const ChainJoint& joint = linkage.chain.joints[i];
    const Motion at = frames.of(linkage.parents[i]) * joint.before.motion;
    const Motion moved =
        at * (joint.revolute ? turn(joint.axis, q[i]) : Motion(Eigen::Translation3d(q[i] * joint.axis)));
    frames.joints.push_back({at.translation(), at.linear() * joint.axis, moved.translation(), moved});
    frames.links.push_back(moved * joint.after.motion);
  }
  return frames;
}

/// Returns an index for the scripts: -1 for the base.
int index_of(std::size_t link) { return link == model::base_link ? -1 : static_cast<int>(link); }

}  // namespace

Linkage linkage_of(const model::Mechanism& mechanism) {
  const model::Robot& robot = mechanism.robot;
  Linkage linkage{chain_of(robot), {}, {}, {}, mechanism.loops.actuated};
  for (std::size_t i = 0; i < robot.joints.size(); ++i) linkage.parents.push_back(model::parent_of(robot, i));
  for (const model::Loop& loop : mechanism.loops.closures)
    linkage.ties.push_back({loop.type == model::LoopType::rod || loop.type == model::LoopType::slide,
                            loop.links,
                            {numbers_of(robot, loop.points[0]), numbers_of(robot, loop.points[1])}});
  for (const model::Frame& tip : mechanism.tips)
    linkage.tips.push_back({tip.name, tip.joint, motion_of(robot, tip.placement)});
  return linkage;
}

PlacedLinkage placed(const Linkage& linkage, const std::vector<double>& q) {
  const Frames frames = frames_of(linkage, q);
  PlacedLinkage result{frames.joints, {}, {}, {}};
  std::vector<Vector> origins;
  for (const Posture::Joint& joint : frames.joints) origins.push_back(joint.moved);
  LinkLines lines(origins);
  for (std::size_t i = 0; i < frames.joints.size(); ++i) {
    lines.carry(linkage.parents[i], frames.joints[i].point);
    if (!linkage.chain.joints[i].revolute)
      lines.lines.push_back({frames.joints[i].point, frames.joints[i].moved});
  }
  for (const Linkage::Tie& tie : linkage.ties) {
    std::array<Vector, 2> ends;
    for (std::size_t k = 0; k < 2; ++k) {
      ends.at(k) = frames.of(tie.links.at(k)) * tie.points.at(k);
      lines.carry(tie.links.at(k), ends.at(k));
      result.ties.push_back(ends.at(k));
    }
    if (tie.is_apart) lines.lines.push_back({ends[0], ends[1]});
  }
  for (const Linkage::Tip& tip : linkage.tips) {
    result.tips.push_back(frames.of(tip.link) * tip.placement);
    lines.carry(tip.link, result.tips.back().translation());
  }
  result.lines = lines.lines;
  return result;
}

double extent_of(const PlacedLinkage& at) {
  Eigen::AlignedBox3d box;
  for (const PlacedLinkage::Line& line : at.lines) box.extend(line.from).extend(line.to);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

Sight sight_of(const Linkage& linkage, const PlacedLinkage& at) {
  constexpr double most = 0.6, beside = 0.3, lowest = 0.28, highest = 1.15;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < at.joints.size(); ++i)
    if (linkage.chain.joints[i].revolute) axes += at.joints[i].axis * at.joints[i].axis.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(axes);
  if (!(solver.eigenvalues()[2] > most * axes.trace())) return {};
  Vector way = solver.eigenvectors().col(2);
  if (way.dot(View().toward()) < 0) way = -way;
  const bool is_steep = std::hypot(way[0], way[1]) < 0.3;  // x is to the right then
  const double azimuth = is_steep ? -std::numbers::pi / 2 : std::atan2(way[1], way[0]);
  return {azimuth + beside, std::clamp(std::asin(way[2]), lowest, highest)};
}

double symbol_radius(const PlacedLinkage& at, const Sight& sight) {
  constexpr double largest = 0.02, smallest = 0.007, of_gap = 0.35;
  const View view(sight);
  const double extent = extent_of(at);
  double radius = largest * extent;
  for (const Posture::Joint& a : at.joints)
    for (const Posture::Joint& b : at.joints) {
      const Point from = view.project(a.point), to = view.project(b.point);
      const double gap = std::hypot(from[0] - to[0], from[1] - to[1]);
      if (gap > 1e-6 * extent) radius = std::min(radius, std::max(of_gap * gap, smallest * extent));
    }
  return radius;
}

nlohmann::json linkage_data(const Linkage& linkage, const std::vector<double>& start) {
  using nlohmann::json;
  json data = chain_data(linkage.chain);
  const PlacedLinkage at = placed(linkage, start);
  const Sight sight = sight_of(linkage, at);
  data["start"] = start;
  data["sight"] = {{"azimuth", sight.azimuth}, {"elevation", sight.elevation}};
  data["radius"] = symbol_radius(at, sight);
  const auto point = [](const Vector& v) { return json{v[0], v[1], v[2]}; };
  data["parents"] = data["ties"] = data["tips"] = json::array();
  for (const std::size_t parent : linkage.parents) data["parents"].push_back(index_of(parent));
  for (const Linkage::Tie& tie : linkage.ties)
    data["ties"].push_back({{"apart", tie.is_apart},
                            {"links", {index_of(tie.links[0]), index_of(tie.links[1])}},
                            {"points", {point(tie.points[0]), point(tie.points[1])}}});
  for (const Linkage::Tip& tip : linkage.tips)
    data["tips"].push_back(
        {{"name", tip.name}, {"link", index_of(tip.link)}, {"placement", motion_data(tip.placement)}});
  data["driven"] = linkage.driven;
  return data;
}

}  // namespace qvgen::report
