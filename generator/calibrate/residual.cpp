// SPDX-License-Identifier: MIT
#include "calibrate/residual.h"

#include <Eigen/Geometry>

namespace qvgen::calibrate {
namespace {

Eigen::Matrix3d matrix_of(const Rigid<double>& m) {
  Eigen::Matrix3d result;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      result(row, column) = m.axes[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)];
  return result;
}

bool is_scalar(Data data) { return data == Data::distance || data == Data::plane || data == Data::sphere; }

/// Returns the distance or height that the state predicts, minus the measured one, and by what the row is
/// divided.
std::pair<double, double> scalar_of(Data data, const Surface<double>& surface, const Measurement& measured,
                                    const Vec<double>& at) {
  if (data == Data::plane) return {dot(surface.normal, at) - surface.offset, 1};
  const Vec<double> from = at - surface.point;
  const double distance = std::sqrt(dot(from, from));
  return {distance - (data == Data::sphere ? surface.radius : measured.distance), std::max(distance, 1e-9)};
}

Rigid<double> elementary(const Parameter& each, double amount) {
  const Vec<double> axis = identity(1.0).axes.at(each.direction);
  return each.turn ? turn(axis, std::cos(amount), std::sin(amount), 1.0) : shift(amount * axis, 1.0);
}

void move_surface(const Parameter& each, double amount, Surface<double>& surface) {
  // Tilts are those of planes alone, whose third number is the offset; spheres have a centre and a radius.
  if (each.turn) {
    const Vec<double> axis = each.direction == 0 ? surface.first : surface.second;
    const auto by = turn(axis, std::cos(amount), std::sin(amount), 1.0);
    for (Vec<double>* each_axis : {&surface.normal, &surface.first, &surface.second})
      *each_axis = turned(by, *each_axis);
  } else if (surface.normal != Vec<double>{}) {
    surface.offset += amount;
  } else if (each.direction == 3) {
    surface.radius += amount;
  } else {
    surface.point.at(each.direction) += amount;
  }
}

}  // namespace

Vec<double> rotation_vector(const Rigid<double>& m) {
  const Eigen::AngleAxisd turn(matrix_of(m));
  const Eigen::Vector3d vector = turn.angle() * turn.axis();
  return {vector.x(), vector.y(), vector.z()};
}

Residual residual_of(const Model<double>& model, Data data, const State& state, const Measurement& measured,
                     bool derivative) {
  const Prediction<double> prediction = predict(model, posture_of(model.geometry, measured.q.data()),
                                                state.frames, measured.target, state.values);
  const Surface<double> surface = is_scalar(data) ? state.surfaces[measured.surface] : Surface<double>{};
  Residual result;
  double divide = 1;
  if (is_scalar(data)) {
    const auto [difference, by] = scalar_of(data, surface, measured, prediction.pose.position);
    result.value = Eigen::VectorXd::Constant(1, difference);
    divide = by;
  } else {
    const Rigid<double> seen = data == Data::camera ? inverse(prediction.pose) : prediction.pose;
    result.value.resize(data == Data::position ? 3 : 6);
    const Vec<double> turned =
        data == Data::position ? Vec<double>{} : rotation_vector(seen * inverse(measured.pose));
    for (int i = 0; i < result.value.size(); ++i) {
      const auto k = static_cast<std::size_t>(i % 3);
      result.value[i] = i < 3 ? seen.position.at(k) - measured.pose.position.at(k) : turned.at(k);
    }
  }
  if (!derivative) return result;
  const auto rows = rows_of(model.parameters, data, prediction, surface, measured.surface, 1.0);
  result.derivative.resize(static_cast<Eigen::Index>(rows.size()),
                           static_cast<Eigen::Index>(model.parameters.size()));
  for (Eigen::Index i = 0; i < result.derivative.rows(); ++i)
    result.derivative.row(i) = Eigen::Map<const Eigen::RowVectorXd>(rows[static_cast<std::size_t>(i)].data(),
                                                                    result.derivative.cols()) /
                               divide;
  return result;
}

Eigen::VectorXd deviations(Data data, const Measurement& measured) {
  if (is_scalar(data)) return Eigen::VectorXd::Constant(1, measured.sigma);
  Eigen::VectorXd result(data == Data::position ? 3 : 6);
  result.setConstant(measured.sigma_angle);
  result.head(3).setConstant(measured.sigma);
  return result;
}

State moved(const Model<double>& model, State state, const Eigen::VectorXd& step,
            const std::vector<std::size_t>& active) {
  for (std::size_t i = 0; i < active.size(); ++i) {
    const Parameter& each = model.parameters[active[i]];
    const double amount = step[static_cast<Eigen::Index>(i)];
    if (!each.nuisance)
      state.values[active[i]] += amount;
    else if (each.kind == Kind::surface)
      move_surface(each, amount, state.surfaces[each.object]);
    else if (each.gap == 0)
      state.frames.tracker = state.frames.tracker * elementary(each, amount);
    else
      state.frames.targets[each.object] = state.frames.targets[each.object] * elementary(each, amount);
  }
  return state;
}

}  // namespace qvgen::calibrate
