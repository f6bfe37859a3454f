// SPDX-License-Identifier: MIT
// A tracker's frame is Horn's (1987): two sets of points brought upon one another by a singular value
// decomposition. Where the target's place on the tool is unknown too, the two are found in turns, from
// several places, and the best is kept.
#include "calibrate/align.h"

#include <Eigen/Geometry>

#include "matrices/decompositions.h"

namespace qvgen::calibrate {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Eigen::Vector3d eigen(const Vec<double>& v) { return {v[0], v[1], v[2]}; }
Vec<double> plain(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Eigen::Isometry3d eigen(const Rigid<double>& m) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) result.linear().col(i) = eigen(m.axes[static_cast<std::size_t>(i)]);
  result.translation() = eigen(m.position);
  return result;
}
Rigid<double> plain(const Eigen::Isometry3d& m) {
  Rigid<double> result;
  for (int i = 0; i < 3; ++i)
    result.axes[static_cast<std::size_t>(i)] = plain(Eigen::Vector3d(m.linear().col(i)));
  result.position = plain(Eigen::Vector3d(m.translation()));
  return result;
}

/// The nominal tool's poses and what the instrument saw.
class Aligner {
 public:
  Aligner(const Model<double>& model, const Setup& setup, const DataSet& set) : setup_(setup), set_(set) {
    const std::vector<double> none(model.parameters.size(), 0.0);
    const Frames<double> frames{identity(1.0), std::vector<Rigid<double>>(setup.targets, identity(1.0))};
    for (const Measurement& row : set.rows) {
      tools_.push_back(eigen(predict(model, posture_of(model.geometry, row.q.data()), frames, 0, none).pose));
      const Eigen::Isometry3d seen = eigen(row.pose);
      seen_.push_back(set.data == Data::camera ? seen.inverse() : seen);
    }
    state_ = {none, frames, std::vector<Surface<double>>(setup.surfaces)};
  }

  State state() {
    if (!setup_.has_tracker()) {
      for (std::size_t i = 0; i < setup_.surfaces; ++i) state_.surfaces[i] = surface(i);
      return std::move(state_);
    }
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Matrix3d& start : first_rotations())
      for (const Eigen::Vector3d& place : first_places()) try_from(start, place, least);
    for (std::size_t i = 0; i < setup_.targets; ++i) {
      Eigen::Isometry3d target = Eigen::Isometry3d::Identity();
      target.translation() = best_places_[i];
      if (setup_.has_orientation() && !setup_.target_known) target.linear() = target_rotation(best_, i);
      state_.frames.targets[i] = plain(target);
    }
    state_.frames.tracker = plain(best_);
    return std::move(state_);
  }

 private:
  /// Returns rotations of the tracker to begin with: none, and that which brings turns between poses upon one
  /// another.
  std::vector<Eigen::Matrix3d> first_rotations() {
    std::vector<Eigen::Matrix3d> result{Eigen::Matrix3d::Zero()};  // zero: from the points
    if (!setup_.has_orientation() || setup_.tracker_known) return result;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < tools_.size(); ++i) {
      const std::size_t j = (i + 1 + tools_.size() / 3) % tools_.size();
      const Eigen::AngleAxisd of_tool(Eigen::Matrix3d(tools_[i].linear() * tools_[j].linear().transpose()));
      const Eigen::AngleAxisd of_seen(Eigen::Matrix3d(seen_[i].linear() * seen_[j].linear().transpose()));
      if (of_tool.angle() < 3.0)
        sum += of_seen.angle() * of_tool.angle() * of_seen.axis() * of_tool.axis().transpose();
    }
    result.push_back(matrices::rotation_next_to(sum));
    return result;
  }

  /// Returns places of the target on the tool to begin with.
  [[nodiscard]] Points first_places() const {
    Points result{Eigen::Vector3d::Zero()};
    if (setup_.target_known) return result;
    for (int axis = 0; axis < 3; ++axis)
      for (const double sign : {-0.2, 0.2}) result.push_back(sign * Eigen::Vector3d::Unit(axis));
    return result;
  }

  void try_from(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& place, double& least) {
    Points places(setup_.targets, place);
    Eigen::Isometry3d tracker = Eigen::Isometry3d::Identity();
    constexpr int rounds = 40;
    for (int round = 0; round < rounds; ++round) {
      if (!setup_.tracker_known)
        tracker = tracker_of(places, round == 0 ? rotation : Eigen::Matrix3d::Zero());
      if (setup_.target_known) break;
      places = places_of(tracker);
    }
    const double cost = cost_of(tracker, places);
    if (cost >= least) return;
    least = cost;
    best_ = tracker;
    best_places_ = places;
  }

  /// Returns the tracker's frame for known places of targets; with a rotation other than zero that one.
  [[nodiscard]] Eigen::Isometry3d tracker_of(const Points& places, const Eigen::Matrix3d& rotation) const {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(), middle_seen = Eigen::Vector3d::Zero();
    Points points;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
      points.push_back(tools_[i] * places[set_.rows[i].target]);
      middle += points.back();
      middle_seen += seen_[i].translation();
    }
    middle /= static_cast<double>(points.size());
    middle_seen /= static_cast<double>(points.size());
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += (seen_[i].translation() - middle_seen) * (points[i] - middle).transpose();
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = rotation.isZero() ? matrices::rotation_next_to(sum) : rotation;
    result.translation() = middle_seen - result.linear() * middle;
    return result;
  }

  /// Returns the places of targets for a known tracker: the mean of what is seen, in the tool's frame.
  [[nodiscard]] Points places_of(const Eigen::Isometry3d& tracker) const {
    Points places(setup_.targets, Eigen::Vector3d::Zero());
    std::vector<double> counts(setup_.targets, 0);
    for (std::size_t i = 0; i < tools_.size(); ++i) {
      const std::size_t target = set_.rows[i].target;
      places[target] += (tracker * tools_[i]).inverse() * seen_[i].translation();
      ++counts[target];
    }
    for (std::size_t i = 0; i < places.size(); ++i) places[i] /= std::max(1.0, counts[i]);
    return places;
  }

  [[nodiscard]] Eigen::Matrix3d target_rotation(const Eigen::Isometry3d& tracker, std::size_t target) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < tools_.size(); ++i)
      if (set_.rows[i].target == target)
        sum += (tracker * tools_[i]).linear().transpose() * seen_[i].linear();
    return matrices::rotation_next_to(sum);
  }

  [[nodiscard]] double cost_of(const Eigen::Isometry3d& tracker, const Points& places) const {
    double cost = 0;
    std::vector<Eigen::Matrix3d> rotations;
    for (std::size_t i = 0; setup_.has_orientation() && i < setup_.targets; ++i)
      rotations.push_back(setup_.target_known ? Eigen::Matrix3d::Identity() : target_rotation(tracker, i));
    for (std::size_t i = 0; i < tools_.size(); ++i) {
      const std::size_t target = set_.rows[i].target;
      const Eigen::Isometry3d tool = tracker * tools_[i];
      cost += (tool * places[target] - seen_[i].translation()).squaredNorm();
      if (!rotations.empty())
        cost += 0.05 * (tool.linear() * rotations[target] - seen_[i].linear()).squaredNorm();
    }
    return cost;
  }

  Surface<double> surface(std::size_t object) const {
    Points points;
    std::vector<double> distances;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
      if (set_.rows[i].surface != object) continue;
      points.push_back(tools_[i].translation());
      distances.push_back(set_.rows[i].distance);
    }
    return set_.data == Data::plane ? plane_through(points) : sphere_through(points, distances);
  }

  static Surface<double> plane_through(const Points& points) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& point : points) middle += point / static_cast<double>(points.size());
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const auto& point : points) sum += (point - middle) * (point - middle).transpose();
    const Eigen::Matrix3d axes = matrices::principal_axes(sum).axes;
    Surface<double> result;
    result.normal = plain(Eigen::Vector3d(axes.col(0)));
    result.first = plain(Eigen::Vector3d(axes.col(1)));
    result.second = plain(Eigen::Vector3d(axes.col(2)));
    result.offset = axes.col(0).dot(middle);
    return result;
  }

  /// Solves p^2 - L^2 = 2 c.p + k, with L = 0 and k = r^2 - c^2 for a sphere.
  Surface<double> sphere_through(const Points& points, const std::vector<double>& distances) const {
    Eigen::MatrixXd matrix(static_cast<Eigen::Index>(points.size()), 4);
    Eigen::VectorXd right(matrix.rows());
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      matrix.row(i) << 2 * points[k].transpose(), 1;
      right[i] = points[k].squaredNorm() - (set_.data == Data::distance ? distances[k] * distances[k] : 0);
    }
    const Eigen::VectorXd found = matrices::shortest_solution(matrix, right);
    Surface<double> result;
    result.point = plain(Eigen::Vector3d(found.head<3>()));
    result.radius = std::sqrt(std::max(1e-12, found[3] + found.head<3>().squaredNorm()));
    return result;
  }

  const Setup& setup_;
  const DataSet& set_;
  std::vector<Eigen::Isometry3d> tools_, seen_;
  State state_;
  Eigen::Isometry3d best_ = Eigen::Isometry3d::Identity();
  Points best_places_;
};

}  // namespace

State first_state(const Model<double>& model, const Setup& setup, const DataSet& set) {
  return Aligner(model, setup, set).state();
}

}  // namespace qvgen::calibrate
