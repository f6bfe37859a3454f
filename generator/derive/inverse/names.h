// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

/// Names of the symbols in a plan's programs: made and read here alone.
namespace qvgen::derive::inverse::names {

/// Names of the caller's values: the pose's unit quaternion and position.
inline constexpr const char* pose_quaternion = "pose_q";
inline constexpr const char* pose_position = "pose_p";
/// The quaternion as it was given, of any length, and 1 / its square: the rotation matrix does not wait for a
/// unit one.
inline constexpr const char* pose_given = "pose_r";
inline constexpr const char* pose_scale = "pose_s";
/// Defined by every target program: the square of a length of the arm's size, for telling noise from values.
inline constexpr const char* size_square = "size_square";

/// Results of a step's block: an angle's cosine and sine, a length, two lengths.
inline constexpr const char* cosine_result = "cos_result";
inline constexpr const char* sine_result = "sin_result";
inline constexpr const char* result = "result";
inline constexpr const char* result_1 = "result_1";
inline constexpr const char* result_2 = "result_2";

/// Name of an angle's cosine, by the joint's variable or another name of the angle.
inline std::string cosine(const std::string& angle) { return "cos_" + angle; }
inline std::string sine(const std::string& angle) { return "sin_" + angle; }
inline std::string half(const std::string& angle) { return "half_" + angle; }
/// Name of the length of a direction that is not normalised.
inline std::string length(const std::string& unknown) { return "length_" + unknown; }
/// A coordinate ("x", "y") in the plane across the axis in the middle of a position problem, of what the
/// joint on one side carries.
inline std::string plane(const std::string& variable, const std::string& coordinate) {
  return "plane_" + variable + "_" + coordinate;
}
/// The orientation with joints taken off, the last of them last; its components are behind an underscore.
inline std::string orientation_without(const std::string& joints) { return "after_" + joints; }

/// Returns the rest of a name with that beginning; nothing if it begins otherwise.
inline std::optional<std::string> behind(const std::string& beginning, const std::string& name) {
  if (name.rfind(beginning, 0) != 0) return std::nullopt;
  return name.substr(beginning.size());
}

}  // namespace qvgen::derive::inverse::names
