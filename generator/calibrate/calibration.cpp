// SPDX-License-Identifier: MIT
#include "calibrate/calibration.h"

#include <algorithm>

#include <fmt/format.h>

#include "calibrate/align.h"
#include "calibrate/exact_rank.h"
#include "calibrate/load.h"
#include "calibrate/suspicion.h"
#include "calibrate/words.h"
#include "matrices/decompositions.h"

namespace qvgen::calibrate {
namespace {

template <class S>
Model<S> model_of(Geometry<S> geometry, const std::vector<Parameter>& parameters) {
  auto sorted = by_gap(parameters, geometry.gaps.size());
  return {std::move(geometry), parameters, std::move(sorted)};
}

/// True for the errors that tables of Denavit and Hartenberg have, which people ask for.
bool is_usual(const Parameter& each) {
  return each.kind == Kind::zero || (each.gap > 1 && (each.kind == Kind::length ||
                                                      each.kind == Kind::offset || each.kind == Kind::twist));
}

/// Splits the arm's errors into a minimal complete set and those that move the tool as others do.
Rank complete_set(const Geometry<Field>& geometry, const std::vector<Parameter>& errors, const Setup& setup) {
  Setup world = setup;
  world.data = Data::pose;
  world.targets = 1;
  world.surfaces = 0;
  world.target_known = true;
  return exact_rank(model_of(geometry, errors), world, priority_of(errors));
}

std::vector<std::size_t> nuisances(const std::vector<Parameter>& parameters,
                                   const std::vector<std::size_t>& among) {
  std::vector<std::size_t> result;
  for (const std::size_t index : among)
    if (parameters[index].nuisance) result.push_back(index);
  return result;
}

double numbers_of(Data data) {
  return data == Data::pose || data == Data::camera ? 6 : data == Data::position ? 3 : 1;
}

/// The steps of one calibration, which share the data and the model.
class Calibrator {
 public:
  Calibrator(const model::Robot& robot, DataSet set, const Options& options) : set_(std::move(set)) {
    result_.identifiable = identifiable(robot, setup_of(set_, options));
    all_.assign(set_.rows.size(), 1.0);
  }

  std::optional<Calibration> run(DataError& error) {
    const Identifiable& can = result_.identifiable;
    const std::vector<std::size_t> frames = nuisances(can.model.parameters, can.candidates);
    if (too_few(frames.size(), error)) return std::nullopt;
    State start = first_state(can.model, can.setup, set_);
    start = fit(can.model, {&set_, all_}, start, frames);
    if (const std::string doubt = suspicion(can, set_, start); !doubt.empty()) {
      error = {"the data do not fit the arm at all", doubt};
      return std::nullopt;
    }
    choose(start);
    if (too_few(result_.active.size(), error)) return std::nullopt;
    settle(start);
    if (!set_.sigma_known) choose_again();
    // Before: the frames fitted to the same measurements with the nominal arm.
    result_.nominal =
        fit(can.model, {&set_, result_.weights}, start, nuisances(can.model.parameters, result_.active));
    result_.before = size_of(can.model, {&set_, result_.weights}, result_.nominal);
    result_.after = size_of(can.model, {&set_, result_.weights}, result_.state);
    say_outliers();
    hold_out(start);
    return std::move(result_);
  }

 private:
  /// Chooses what these data tell.
  void choose(const State& start) {
    const Identifiable& can = result_.identifiable;
    const Rank rank = numeric_rank(can.model, {&set_, all_}, start, can.candidates);
    result_.active = rank.independent;
    result_.dependent = rank.dependent;
    result_.untold = sentences(can.model.parameters, rank.dependent);
  }

  /// Chooses once more with the deviations that were found: data that are better than usual tell more.
  void choose_again() {
    const std::vector<std::size_t> before = result_.active;
    choose(result_.state);
    if (result_.active == before) return;
    State state = result_.state;
    for (std::size_t i = 0; i < state.values.size(); ++i)
      if (!std::binary_search(result_.active.begin(), result_.active.end(), i)) state.values[i] = 0;
    settle(state);
  }

  bool too_few(std::size_t unknowns, DataError& error) const {
    const double numbers = numbers_of(set_.data) * static_cast<double>(set_.rows.size());
    const double unknown = static_cast<double>(unknowns);
    if (numbers > unknown) return false;
    error = {
        fmt::format("{} rows are too few: {} numbers for {} unknowns", set_.rows.size(), numbers, unknown),
        fmt::format("measure at least {} more, or ask for less: --errors zeros",
                    static_cast<int>((unknown - numbers) / numbers_of(set_.data)) + 2)};
    return true;
  }

  /// Fits; where no deviations are said, finds those of positions and angles from the residuals.
  void settle(const State& start) {
    const Identifiable& can = result_.identifiable;
    RobustFit best = robust_fit(can.model, set_, start, result_.active, all_);
    for (int round = 0; !set_.sigma_known && round < 3; ++round) {
      scale_deviations(best);
      best = robust_fit(can.model, set_, best.state, result_.active, all_);
    }
    result_.state = std::move(best.state);
    result_.weights = std::move(best.weights);
    const Normal normal = normal_of(can.model, {&set_, result_.weights}, result_.state, result_.active);
    const Eigen::VectorXd norms = normal.matrix.diagonal().cwiseSqrt().cwiseMax(1e-300);
    const Eigen::MatrixXd scaled =
        norms.cwiseInverse().asDiagonal() * normal.matrix * norms.cwiseInverse().asDiagonal();
    const Eigen::MatrixXd inverse =
        matrices::solve_symmetric_columns(scaled, Eigen::MatrixXd::Identity(scaled.rows(), scaled.cols()));
    result_.covariance = norms.cwiseInverse().asDiagonal() * inverse * norms.cwiseInverse().asDiagonal();
    result_.freedom = std::max(1.0, normal.numbers - static_cast<double>(result_.active.size()));
    result_.misfit = std::sqrt(normal.cost / result_.freedom);
    if (!set_.sigma_known) result_.covariance *= result_.misfit * result_.misfit;
    result_.sigma = set_.rows.front().sigma;
    result_.sigma_angle = set_.rows.front().sigma_angle;
  }

  /// Makes the deviations what the residuals are, with a correction for the unknowns that were fitted.
  void scale_deviations(const RobustFit& best) {
    const Size size = size_of(result_.identifiable.model, {&set_, best.weights}, best.state);
    const double used = static_cast<double>(std::count(best.weights.begin(), best.weights.end(), 1.0));
    const double numbers = numbers_of(set_.data) * std::max(1.0, used);
    const double freedom = std::max(1.0, numbers - static_cast<double>(result_.active.size()));
    const double share = std::sqrt(numbers / freedom / std::min(3.0, numbers_of(set_.data)));
    constexpr double least = 1e-12;
    for (Measurement& row : set_.rows) {
      row.sigma = std::max(least, size.position * share);
      if (size.angle > 0) row.sigma_angle = std::max(least, size.angle * share);
    }
  }

  void say_outliers() {
    const std::vector<double> sizes = sizes_of(result_.identifiable.model, set_, result_.state);
    for (std::size_t i = 0; i < sizes.size(); ++i)
      if (result_.weights[i] == 0) result_.outliers.push_back({set_.rows[i].line, sizes[i]});
  }

  /// Fits four fifths of the data and looks at the others.
  void hold_out(const State& start) {
    const Identifiable& can = result_.identifiable;
    std::vector<double> kept = result_.weights, others = result_.weights;
    for (std::size_t i = 0; i < kept.size(); ++i) (i % 5 == 4 ? kept : others)[i] = 0;
    const double numbers =
        numbers_of(set_.data) * static_cast<double>(std::count(kept.begin(), kept.end(), 1.0));
    if (numbers < 1.2 * static_cast<double>(result_.active.size())) return;
    if (numeric_rank(can.model, {&set_, kept}, start, can.candidates).independent != result_.active) return;
    const State state = fit(can.model, {&set_, kept}, result_.state, result_.active);
    result_.hold_out = size_of(can.model, {&set_, others}, state);
    result_.expected = expected_size(kept, others);
  }

  /// Returns the size of residuals that the covariance of a fit of `kept` promises for `others`.
  [[nodiscard]] Size expected_size(const std::vector<double>& kept, const std::vector<double>& others) const {
    const Model<double>& model = result_.identifiable.model;
    const Normal normal = normal_of(model, {&set_, kept}, result_.state, result_.active);
    const Eigen::MatrixXd inverse = matrices::solve_symmetric_columns(
        normal.matrix, Eigen::MatrixXd::Identity(normal.matrix.rows(), normal.matrix.cols()));
    Size size;
    double count = 0;
    for (std::size_t i = 0; i < others.size(); ++i) {
      if (others[i] == 0) continue;
      const Residual residual = residual_of(model, set_.data, result_.state, set_.rows[i]);
      Eigen::MatrixXd rows(residual.value.size(), static_cast<Eigen::Index>(result_.active.size()));
      for (Eigen::Index k = 0; k < rows.cols(); ++k)
        rows.col(k) =
            residual.derivative.col(static_cast<Eigen::Index>(result_.active[static_cast<std::size_t>(k)]));
      const Eigen::VectorXd squares =
          (rows * inverse * rows.transpose()).diagonal() + deviations(set_.data, set_.rows[i]).cwiseAbs2();
      const Eigen::Index heads = std::min<Eigen::Index>(3, squares.size());
      size.position += squares.head(heads).sum();
      size.angle += squares.tail(squares.size() - heads).sum();
      count += 1;
    }
    const double scale = (set_.sigma_known ? 1 : result_.misfit) / std::sqrt(std::max(1.0, count));
    return {std::sqrt(size.position) * scale, std::sqrt(size.angle) * scale, 0};
  }

  DataSet set_;
  Calibration result_;
  std::vector<double> all_;
};

}  // namespace

Setup setup_of(const DataSet& set, const Options& options) {
  Setup setup;
  setup.data = set.data;
  setup.targets = set.targets.size();
  setup.surfaces = setup.has_tracker() ? 0 : set.surfaces.size();
  setup.tracker_known = options.tracker_known || !setup.has_tracker();
  setup.target_known = options.target_known;
  setup.errors = options.errors;
  setup.eccentric = options.eccentric;
  setup.bending = options.bending;
  return setup;
}

Identifiable identifiable(const model::Robot& robot, const Setup& setup) {
  const auto classes = classes_of(robot);
  Geometry<double> geometry = geometry_of(robot, classes);
  Geometry<Field> field = field_geometry_of(robot, classes);
  if (setup.bending) add_bodies(robot, geometry, field);
  geometry.greatest_loads = greatest_loads(geometry);
  std::vector<Parameter> errors, parameters;
  for (const Parameter& each : parameters_of(geometry, setup))
    if (!each.nuisance) errors.push_back(each);
  const Rank complete = complete_set(field, errors, setup);
  std::vector<Dependence> usual;
  for (const Dependence& each : complete.dependent)
    if (is_usual(errors[each.parameter])) usual.push_back(each);
  std::vector<Parameter> kept;
  for (const std::size_t index : complete.independent) kept.push_back(errors[index]);
  for (const Parameter& each : parameters_of(geometry, setup))
    if (each.nuisance) kept.push_back(each);

  Identifiable result{setup, model_of(geometry, kept), {}, sentences(errors, usual), {}};
  const Rank rank = exact_rank(model_of(field, kept), setup, priority_of(kept));
  for (const std::size_t index : priority_of(kept))
    if (std::binary_search(rank.independent.begin(), rank.independent.end(), index))
      result.candidates.push_back(index);
  result.dependent = rank.dependent;
  for (std::string& sentence : sentences(kept, rank.dependent)) result.never.push_back(std::move(sentence));
  return result;
}

std::optional<Calibration> calibrate(const model::Robot& robot, DataSet set, const Options& options,
                                     DataError& error) {
  if (set.rows.empty()) {
    error = {"there are no measurements", "write a row for each"};
    return std::nullopt;
  }
  return Calibrator(robot, std::move(set), options).run(error);
}

}  // namespace qvgen::calibrate
