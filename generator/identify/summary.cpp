// SPDX-License-Identifier: MIT
#include "identify/summary.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "identify/extra_columns.h"
#include "model/followers.h"

namespace qvgen::identify {
namespace {

using Eigen::Index;

/// Shares of a parameter below this are rounding.
constexpr double nothing = 1e-12;
/// Correlation of a residual with the one before it above which noise is not white.
constexpr double lasting = 0.3;

constexpr std::array standard_names{"m", "hx", "hy", "hz", "Ixx", "Iyy", "Izz", "Ixy", "Iyz", "Ixz"};
constexpr std::array drive_names{"Ia", "fv", "fc", "off"};

std::string name_of(const ArmRegressor& arm, Index place) {
  if (place < arm.standard())
    return standard_names[static_cast<std::size_t>(place % 10)] + std::to_string(place / 10 + 1);
  const auto drive = static_cast<std::size_t>(place - arm.standard()), unit = drive / 4;
  return std::string(drive_names[drive % 4]) + (unit < arm.links ? "" : "_") + arm.drive_name(unit);
}

std::string term(double factor, const std::string& name, bool first) {
  const std::string sign = factor < 0 ? (first ? "-" : " - ") : (first ? "" : " + ");
  const double size = std::abs(factor);
  return sign + (std::abs(size - 1) < nothing ? "" : fmt::format("{:.6g} ", size)) + name;
}

std::vector<std::string> variables_of(const model::Robot& robot) { return model::variables(robot); }

std::string filter_text(const Filter& filter) {
  if (!filter.rates && !filter.accelerations) return "rates and accelerations as measured\n";
  return fmt::format("{} from polynomials of degree 4 through {} samples: band {:.3g} Hz\n",
                     filter.rates ? "rates and accelerations" : "accelerations", 2 * filter.half + 1,
                     filter.band);
}

std::string joints_text(const model::Robot& robot, const Identification& found) {
  const auto variables = variables_of(robot);
  std::string text = fmt::format("\n{:<12}{:>9}{:>12}{:>12}{:>9}{:>9}{:>12}\n", "joint", "rows", "torque rms",
                                 "residual", "share", "lag 1", "hold-out");
  for (std::size_t i = 0; i < found.joints.size(); ++i) {
    const JointResidual& joint = found.joints[i];
    text +=
        fmt::format("{:<12}{:>9}{:>12.4g}{:>12.4g}{:>8.3g}%{:>9.2f}{:>12}\n", variables[i], joint.rows,
                    joint.torque, joint.residual, joint.torque > 0 ? 100 * joint.residual / joint.torque : 0,
                    joint.correlation, joint.hold_out ? fmt::format("{:.4g}", *joint.hold_out) : "-");
  }
  return text +
         "torques in Nm (N for slides); share: residual by torque; lag 1: correlation of a residual with the "
         "next\n";
}

std::string warnings_text(const model::Robot& robot, const Identification& found) {
  const auto variables = variables_of(robot);
  std::string text;
  for (const std::string& doubt : found.doubts) text += "warning: " + doubt + "\n";
  for (std::size_t i = 0; i < found.joints.size(); ++i) {
    const JointResidual& joint = found.joints[i];
    if (joint.rows > 0 && joint.residual > 0.5 * joint.torque && joint.torque > 0)
      text += fmt::format(
          "{}: the motion explains little of its torque; look for swapped columns, a wrong sign, a "
          "wrong gear or unit\n",
          variables[i]);
    else if (joint.correlation > lasting)
      text += fmt::format(
          "{}: its residual is no white noise (something is not modelled); true deviations are about "
          "{:.1f} times those below\n",
          variables[i], std::sqrt((1 + joint.correlation) / (1 - joint.correlation)));
  }
  return text;
}

std::string parameters_text(const Identification& found) {
  const Estimate& estimate = found.estimate;
  std::string text =
      fmt::format("\n{} parameters that motions can tell; condition number of these data {:.3g}\n",
                  estimate.value.size(), estimate.condition);
  text += fmt::format("{:<16}{:>14}{:>12}{:>10}\n", "parameter", "value", "+-", "t");
  for (Index k = 0; k < estimate.value.size(); ++k) {
    if (!estimate.told[static_cast<std::size_t>(k)]) continue;
    const double deviation = estimate.deviation[k];
    text += fmt::format("{:<16}{:>14.6g}{:>12.2g}{:>10.3g}\n", found.arm.names[static_cast<std::size_t>(k)],
                        estimate.value[k], deviation,
                        deviation > 0 ? std::abs(estimate.value[k]) / deviation : 0);
  }
  for (Index k = found.arm.plain(); k < estimate.value.size(); ++k)
    text += found.arm.names[static_cast<std::size_t>(k)] + " of " + definition(found.arm, k) + "\n";
  return text +
         "+- is one standard deviation: the true value is within twice that with 95 %; with t below 3 it may "
         "as "
         "well be zero\n";
}

std::string drive_text(const Identification& found, std::size_t unit) {
  const auto d = found.full.values.segment<4>(found.arm.standard() + 4 * static_cast<Index>(unit));
  return fmt::format("{:>12.4g}{:>11.4g}{:>11.4g}{:>11.4g}\n", d[0], d[1], d[2], d[3]);
}

std::string full_text(const Identification& found) {
  const ArmRegressor& arm = found.arm;
  std::string text =
      found.full.exact
          ? "\nfull set: bodies with exactly these parameters, nearest to the prior\n"
          : fmt::format(
                "\nfull set: no bodies have exactly these parameters; the nearest add {:.4g} to the weighted "
                "sum of squares (one row's noise is 1)\n",
                found.full.distance);
  text += fmt::format("{:<6}{:>11}{:>11}{:>11}{:>11}{:>12}{:>11}{:>11}{:>11}\n", "link", "mass", "centre x",
                      "y", "z", "rotor", "viscous", "Coulomb", "offset");
  for (std::size_t i = 0; i < arm.links; ++i) {
    const auto link = static_cast<Index>(i);
    const auto p = found.full.values.segment<10>(10 * link);
    text += fmt::format("{:<6}{:>11.5g}{:>11.4g}{:>11.4g}{:>11.4g}{}", i + 1, p[0], p[1] / p[0], p[2] / p[0],
                        p[3] / p[0], drive_text(found, i));
  }
  if (!arm.motors.empty()) text += "motor\n";
  for (std::size_t i = arm.links; i < arm.drive_units(); ++i)
    text += fmt::format("{:<50}{}", arm.drive_name(i), drive_text(found, i));
  return text;
}

std::string payload_text(const PayloadEstimate& found) {
  std::string text =
      fmt::format("\npayload, in the frame of the last link; condition number {:.3g}\n", found.condition);
  const auto line = [](const std::string& name, double value, double deviation, const std::string& unit) {
    return fmt::format("{:<16}{:>14.6g}{:>12.2g}  {}\n", name, value, deviation, unit);
  };
  const Payload &body = found.body, &deviation = found.deviation;
  text += line("mass", body.mass, deviation.mass, "kg");
  for (Index k = 0; k < 3; ++k)
    text += line(fmt::format("centre {}", "xyz"[k]), body.centre[k], deviation.centre[k], "m");
  constexpr std::array names{"xx", "yy", "zz", "xy", "yz", "xz"};
  for (std::size_t k = 0; k < 6; ++k)
    text += line(fmt::format("inertia {}", names[k]), body.inertia[k], deviation.inertia[k], "kg m^2");
  std::string untold;
  for (std::size_t k = 0; k < 10; ++k)
    if (!found.told[k]) untold += (untold.empty() ? "" : ", ") + std::string(standard_names[k]);
  return untold.empty() ? text : text + "taken as zero, since these data do not tell: " + untold + "\n";
}

}  // namespace

std::string definition(const ArmRegressor& arm, Index parameter) {
  if (parameter >= arm.plain()) return extra_definition(arm, parameter);
  std::string text;
  for (Index k = 0; k < arm.combination.cols(); ++k)
    if (const double factor = arm.combination(parameter, k); std::abs(factor) > nothing)
      text += term(factor, name_of(arm, k), text.empty());
  return text;
}

std::vector<std::string> untold(const Identification& found) {
  std::vector<std::string> sentences = found.arm.left_out;
  const Estimate& estimate = found.estimate;
  for (Index k = 0; k < estimate.value.size(); ++k) {
    if (estimate.told[static_cast<std::size_t>(k)]) continue;
    const std::string& name = found.arm.names[static_cast<std::size_t>(k)];
    std::string with;
    for (Index other = 0; other < estimate.value.size(); ++other)
      if (estimate.parts(k, other) != 0)
        with += (with.empty() ? "" : ", ") + found.arm.names[static_cast<std::size_t>(other)];
    sentences.push_back(with.empty() ? name + " does not show in these data: they lack the motion for it"
                                     : name + " is not told apart by these data: it is part of " + with);
  }
  return sentences;
}

std::string summary(const model::Robot& robot, const Identification& found) {
  std::string text = filter_text(found.filter) + joints_text(robot, found) + warnings_text(robot, found) +
                     parameters_text(found);
  for (const std::string& sentence : untold(found)) text += sentence + "\n";
  text += full_text(found);
  return found.payload ? text + payload_text(*found.payload) : text;
}

std::string parameter_table(const Identification& found) {
  const Estimate& estimate = found.estimate;
  std::string text = "parameter,value,deviation,t,told,definition\n";
  for (Index k = 0; k < estimate.value.size(); ++k) {
    const double deviation = estimate.deviation[k];
    text +=
        fmt::format("{},{},{},{},{},{}\n", found.arm.names[static_cast<std::size_t>(k)], estimate.value[k],
                    deviation, deviation > 0 ? std::abs(estimate.value[k]) / deviation : 0.0,
                    estimate.told[static_cast<std::size_t>(k)] ? "yes" : "no", definition(found.arm, k));
  }
  return text;
}

}  // namespace qvgen::identify
