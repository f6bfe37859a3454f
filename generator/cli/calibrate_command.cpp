// SPDX-License-Identifier: MIT
// Reads the arm and the data, calibrates, prints what was found, and writes the arm's description.
#include "cli/calibrate_command.h"

#include <algorithm>

#include <fmt/format.h>

#include "calibrate/dh.h"
#include "calibrate/page.h"
#include "calibrate/plan.h"
#include "calibrate/report.h"
#include "calibrate/result.h"
#include "calibrate/urdf.h"
#include "cli/commands.h"
#include "cli/suggestion.h"
#include "description/names.h"
#include "description/write.h"
#include "pipeline/files.h"

namespace qvgen::cli {
namespace {

namespace fs = std::filesystem;
using calibrate::Calibration;

/// Thrown after the mistakes of a table of spheres have been printed.
struct BadSpheres {};

bool has(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Returns the name of the calibrated robot: said, or the output's, or the robot's with an ending.
std::string name_of(const CalibrateArguments& arguments, const model::Robot& robot) {
  if (!arguments.read.name.empty()) return arguments.read.name;
  const std::string stem = arguments.output.stem().string();
  const bool is_name = description::check_robot_name(stem).message.empty();
  return is_name && stem != robot.name ? stem : robot.name + "_calibrated";
}

void check_masses(const model::Robot& robot) {
  for (const model::Joint& joint : robot.joints)
    for (const model::Expression& each : {joint.inertia.mass, joint.inertia.centre_of_mass[0],
                                          joint.inertia.centre_of_mass[1], joint.inertia.centre_of_mass[2]})
      for (const std::string& symbol : model::symbols(each))
        if (!model::default_bindings(robot).contains(symbol))
          throw std::runtime_error(fmt::format(
              "--bending: {} of {} has no value; write masses and centres, or identify them first", symbol,
              robot.name));
  const bool none = std::all_of(robot.joints.begin(), robot.joints.end(), [](const model::Joint& joint) {
    return joint.inertia.mass.is_literal_zero();
  });
  if (none)
    throw std::runtime_error("--bending: " + robot.name + " has no masses; qvgen identify finds them");
}

void check_numbers(const model::Robot& robot) {
  for (const model::Parameter& each : robot.geometry)
    if (!each.default_value)
      throw std::runtime_error(
          fmt::format("{} of {} has no value: a calibration begins with numbers; write one under [defaults]",
                      each.name, robot.name));
}

void write_whole(const fs::path& path, const std::string& text) {
  fs::path temporary = path;
  temporary += ".unfinished";
  pipeline::replace_file(path, text, temporary);
}

/// Reads a text again: what `generate` would not take is not written.
void check_again(const std::string& text, const fs::path& path, const description::ReadOptions& options) {
  const auto read = description::read_text(text, path.string(), options);
  if (read.robot) return;
  print_diagnostics(read.diagnostics);
  throw std::logic_error("the calibrated description cannot be read");
}

void write_toml(const CalibrateArguments& arguments, const model::Robot& robot, const Calibration& found) {
  const model::Robot result = calibrate::calibrated_robot(robot, found, name_of(arguments, robot));
  const std::string text = description::write_text(result);
  check_again(text, arguments.output, {});
  write_whole(arguments.output, text);
  const std::string ideal = result.ideal.empty() ? "" : result.ideal + " ";
  fmt::print(stderr, "wrote {}; next: qvgen generate {}{}\n", arguments.output.string(), ideal,
             arguments.output.string());
}

void write_urdf(const CalibrateArguments& arguments, const description::ReadResult& read,
                const Calibration& found) {
  const std::string head =
      fmt::format("Origins of joints calibrated by qvgen from {}.", arguments.data.filename().string());
  const std::string text = calibrate::calibrated_urdf(read.text, arguments.read, found, head);
  description::ReadOptions again = arguments.read;
  again.xacro_arguments.clear();
  check_again(text, "calibrated.urdf", again);
  write_whole(arguments.output, text);
  fmt::print(stderr, "wrote {}\n", arguments.output.string());
}

/// Writes the arm that was found in the form that was asked for.
void write(const CalibrateArguments& arguments, const description::ReadResult& read,
           const Calibration& found) {
  if (arguments.format == CalibratedFormat::toml) return write_toml(arguments, *read.robot, found);
  if (arguments.format == CalibratedFormat::urdf) return write_urdf(arguments, read, found);
  const auto form =
      arguments.format == CalibratedFormat::dh ? calibrate::DhForm::classic : calibrate::DhForm::hayati;
  write_whole(arguments.output, calibrate::dh_text(calibrate::dh_change(found, form), form));
  fmt::print(stderr, "wrote {}\n", arguments.output.string());
}

/// Returns the spheres that stand for the links: those of a table, else those of a URDF. Throws BadSpheres.
std::vector<calibrate::Sphere> spheres_of(const CalibrateArguments& arguments,
                                          const description::ReadResult& read) {
  if (arguments.spheres.empty()) return calibrate::spheres_of_urdf(read.text, arguments.read, *read.robot);
  auto result = calibrate::read_spheres(arguments.spheres, *read.robot, arguments.options.length_unit);
  print_diagnostics(result.diagnostics);
  if (!result.good) throw BadSpheres{};
  return std::move(result.spheres);
}

/// Says what a plan keeps apart.
void say_spheres(std::size_t count, const calibrate::Plan& plan, double clearance) {
  if (count == 0) {
    fmt::print(stderr, "links may meet: a table of spheres, --spheres FILE, keeps them apart\n");
    return;
  }
  fmt::print(
      stderr,
      "{} spheres: those of links that are not neighbours keep {:.4g} mm, on straight motions of the joints "
      "from one posture to the next, too\n",
      count, 1e3 * clearance);
  for (const std::string& links : plan.touching)
    fmt::print(stderr, "note: spheres of {} meet in every posture: these were not looked at\n", links);
}

/// Prints postures to measure next.
void print_plan(const CalibrateArguments& arguments, const description::ReadResult& read,
                const calibrate::Identifiable& can, const calibrate::State& state,
                const calibrate::DataSet& set) {
  if (can.setup.data == calibrate::Data::plane || can.setup.data == calibrate::Data::sphere)
    throw std::runtime_error("--plan is for poses, positions and distances: a surface leaves no choice");
  const std::vector<calibrate::Sphere> spheres = spheres_of(arguments, read);
  const calibrate::Plan plan =
      calibrate::plan(*read.robot, can, state, set, arguments.plan,
                      calibrate::Clearance(can.model.geometry, spheres, arguments.clearance));
  fmt::print("{}", calibrate::table_of(*read.robot, plan));
  fmt::print(stderr, "expected deviation of a prediction: {:.4f} mm, before {:.4f} mm\n", 1e3 * plan.after,
             1e3 * plan.before);
  say_spheres(spheres.size(), plan, arguments.clearance);
}

void plan_without_data(const CalibrateArguments& arguments, const description::ReadResult& read,
                       const calibrate::Options& options) {
  calibrate::DataSet none;
  none.targets = {1};
  if (arguments.options.camera) none.data = calibrate::Data::camera;
  const calibrate::Identifiable can =
      calibrate::identifiable(*read.robot, calibrate::setup_of(none, options));
  print_plan(arguments, read, can, calibrate::state_without_data(can), none);
}

void plan_after(const CalibrateArguments& arguments, const description::ReadResult& read,
                calibrate::DataSet set, const Calibration& found) {
  for (auto& row : set.rows)
    if (!set.sigma_known) row.sigma = found.sigma, row.sigma_angle = found.sigma_angle;
  print_plan(arguments, read, found.identifiable, found.state, set);
}

/// Runs a function that prints a plan.
template <class Print>
int planned(const Print& print) {
  try {
    print();
    return success;
  } catch (const BadSpheres&) {
    return failure;
  }
}

}  // namespace

int run_calibrate(const CalibrateArguments& arguments) {
  if (arguments.data.empty() && arguments.plan == 0)
    throw UsageError("calibrate takes a table of measurements, or --plan NUMBER");
  if (arguments.plan == 0 && !arguments.spheres.empty()) throw UsageError("--spheres is for --plan NUMBER");
  if (arguments.format != CalibratedFormat::toml && arguments.output.empty())
    throw UsageError("--format says how the output is written: name it, -o FILE");
  description::ReadOptions read = arguments.read;
  read.name.clear();
  const auto descriptions = read_chains({arguments.description}, read);
  if (!descriptions) return bad_description;
  const model::Robot& robot = *descriptions->front().robot;
  check_numbers(robot);
  if (arguments.bending) check_masses(robot);
  const calibrate::Options options{arguments.errors, arguments.gears, has(arguments.known, "tracker"),
                                   has(arguments.known, "target"), arguments.bending};
  const description::ReadResult& read_robot = descriptions->front();
  if (arguments.data.empty()) return planned([&] { plan_without_data(arguments, read_robot, options); });
  const calibrate::DataResult data = calibrate::read_data(arguments.data, robot, arguments.options);
  print_diagnostics(data.diagnostics);
  if (!data.good) return failure;
  calibrate::DataError error;
  const auto found = calibrate::calibrate(robot, data.set, options, error);
  if (!found) {
    print_diagnostics({{data.set.file, 1, 1, description::Diagnostic::error, error.message, error.hint}});
    return failure;
  }
  if (arguments.plan > 0) return planned([&] { plan_after(arguments, read_robot, data.set, *found); });
  fmt::print("{}", calibrate::report_text(robot, data.set, *found));
  if (!arguments.output.empty()) write(arguments, descriptions->front(), *found);
  if (!arguments.page.empty()) write_whole(arguments.page, calibrate::page(robot, data.set, *found));
  return success;
}

}  // namespace qvgen::cli
