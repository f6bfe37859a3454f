// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "emit/cpp/code.h"

namespace qvgen::emit {

/// Task of Newton's steps: names of triples that a step has computed, and expressions.
struct PolishTask {
  std::vector<bool> revolute;
  std::vector<std::string> axes, points, start, goal;  ///< behind each _x, _y, _z
  std::vector<std::string> from, seed;                 ///< the joints' values
  std::vector<std::string> back;                       ///< statements that take the values back
  std::string size_square;
};

/// How a language spells the statements of inverse kinematics: steps, loops over branches and the way along a
/// seed's are written down once, in these terms. t is the target, w (p, ...) what steps leave for later ones,
/// q a row.
class Dialect {
 public:
  using Lines = std::vector<std::string>;
  using Arguments = std::vector<std::string>;  ///< an empty one is none

  virtual ~Dialect() = default;

  // Expressions.

  [[nodiscard]] virtual Spelling spelling() const = 0;
  /// A double as a number of the type that is computed with.
  [[nodiscard]] virtual std::string scalar(const std::string& value) const = 0;
  /// A member of what functions get by reference: "w.branch".
  [[nodiscard]] virtual std::string member(const std::string& of, const std::string& name) const = 0;
  /// An argument that is handed over by reference.
  [[nodiscard]] virtual std::string reference(const std::string& place) const = 0;
  [[nodiscard]] virtual std::string rotor(const std::string& cosine, const std::string& sine) const = 0;
  [[nodiscard]] virtual std::string product(const std::string& a, const std::string& b) const = 0;
  [[nodiscard]] virtual std::string scaled(const std::string& factor, const std::string& rotor) const = 0;
  [[nodiscard]] virtual std::string inverse(const std::string& rotor) const = 0;
  /// A type of the runtime, by its C++ name: "WristTurns".
  [[nodiscard]] virtual std::string type(const std::string& name) const = 0;
  /// A runtime's struct made of its members.
  [[nodiscard]] virtual std::string braces(const std::string& type, const Arguments& members) const = 0;
  /// pi as an argument, if blocks take it.
  [[nodiscard]] virtual std::string pi() const = 0;
  [[nodiscard]] virtual std::string function(const std::string& name) const = 0;
  /// A call of a building block of the runtime.
  [[nodiscard]] virtual std::string block(const std::string& name, const Arguments& arguments) const = 0;
  /// Writes a block that makes a vector a direction; `opposites`: the opposite one is another branch.
  [[nodiscard]] virtual std::string direction_block(const std::string& name, bool opposites,
                                                    const Arguments& arguments) const = 0;
  [[nodiscard]] virtual std::string number_type() const = 0;
  /// sin, cos
  [[nodiscard]] virtual std::string mathematical(const std::string& function) const = 0;
  /// The i-th of the values that Newton's steps move.
  [[nodiscard]] virtual std::string joint_value(std::size_t i) const = 0;
  /// The angle of a joint's cosine and sine; `length` is empty if it is 1.
  [[nodiscard]] virtual std::string output_angle(const std::string& cosine, const std::string& sine,
                                                 const std::string& length) const = 0;
  /// How far a turn, a slide or a wrist's angles are from those of a seed.
  [[nodiscard]] virtual std::string turn_apart(const std::string& cosine, const std::string& sine,
                                               const std::string& seed) const = 0;
  [[nodiscard]] virtual std::string slide_apart(const std::string& value, const std::string& seed) const = 0;
  [[nodiscard]] virtual std::string wrist_apart(const std::string& angles, const Arguments& seed) const = 0;
  [[nodiscard]] virtual std::string takes_other(const std::string& other, const std::string& other_apart,
                                                const std::string& branch,
                                                const std::string& apart) const = 0;

  // Statements.

  /// Declares the values that steps leave, at first.
  [[nodiscard]] virtual Lines new_work(const std::string& name, bool all_zero) const = 0;
  [[nodiscard]] virtual Lines copied_work(const std::string& name, const std::string& from) const = 0;
  [[nodiscard]] virtual std::string assign_work(const std::string& name, const std::string& from) const = 0;
  /// A row, virtual joints included.
  [[nodiscard]] virtual std::string new_row(int size) const = 0;
  [[nodiscard]] virtual std::string save_branch(const std::string& name, const std::string& work) const = 0;
  [[nodiscard]] virtual std::string resume_branch(const std::string& work, const std::string& name) const = 0;
  /// A constant of a runtime's type.
  [[nodiscard]] virtual std::string constant(const std::string& type, const std::string& name,
                                             const std::string& value) const = 0;
  /// Declares a variable that is changed later; and returns one of two things that are there.
  [[nodiscard]] virtual std::string variable(const std::string& type, const std::string& name,
                                             const std::string& value) const = 0;
  [[nodiscard]] virtual std::string chosen(const std::string& type, const std::string& name,
                                           const std::string& value) const = 0;
  [[nodiscard]] virtual std::string entry(const std::string& array, const std::string& index) const = 0;
  [[nodiscard]] virtual std::string rows_found() const = 0;
  [[nodiscard]] virtual std::string append(const std::string& label, const std::string& work) const = 0;
  /// Appends the one row of a seed's branch.
  [[nodiscard]] virtual std::string append_nearest(const std::string& work) const = 0;
  // Calls of the tracker; `visits`: that of arms with a quartic.
  [[nodiscard]] virtual std::string is_settled(const std::string& label, bool visits) const = 0;
  [[nodiscard]] virtual std::string close(const std::string& label) const = 0;
  [[nodiscard]] virtual std::string reopen(const std::string& label, const std::string& work,
                                           bool visits) const = 0;
  /// The body of a polish step's function.
  [[nodiscard]] virtual Lines polish_lines(const PolishTask& task) const = 0;
  /// True if a polish step leads on; of a seed's branch, by its tracker.
  [[nodiscard]] virtual std::string polishes(const std::string& step, const std::string& target,
                                             const std::string& label, const std::string& work,
                                             bool of_seed) const = 0;
  [[nodiscard]] virtual std::string take_nearer(const std::string& other, const std::string& other_apart,
                                                const std::string& work, const std::string& apart) const = 0;
  /// Makes w of the quartic's root that is nearest to the seed; `take` (a call) makes work of a root.
  [[nodiscard]] virtual Lines nearest_root(const std::string& number, const std::string& take,
                                           const std::string& apart, int branches) const = 0;
};

const Dialect& cpp_dialect();
/// Returns the dialect for lanes: functions are found by what they are called with.
const Dialect& cpp_lane_dialect();

}  // namespace qvgen::emit
