// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "dag/counts.h"
#include "dag/graph.h"
#include "derive/dynamics/scalar.h"

namespace qvgen::compare {

class Recorder;

/// A number of an algorithm that is being recorded: + - * go to the recorder, which must outlive it.
class Value {
 public:
  Value(Recorder& recorder, dag::Edge edge) : recorder_(&recorder), edge_(edge) {}
  [[nodiscard]] dag::Edge edge() const { return edge_; }
  Value operator-() const { return {*recorder_, -edge_}; }
  friend Value operator+(const Value& a, const Value& b);
  friend Value operator-(const Value& a, const Value& b) { return a + -b; }
  friend Value operator*(const Value& a, const Value& b);

 private:
  Recorder* recorder_;
  dag::Edge edge_;
};

/// Knowledge that an algorithm has of the robot's numbers while it runs.
enum class Entries {
  unknown,  ///< nothing, as a library: each is a number in memory, and no operation is left out
  known     ///< everything: zeros, ones and what cancels vanish as they come, numbers are folded
};

/// Runs an algorithm once and keeps what it did: the operations it asked for, and its result as a graph.
///
/// An algorithm is a plain function over Value. What it needs of a robot it works out beforehand, in exact
/// arithmetic (derive::dynamics::Scalar, in the same graph), and hands over by `stored`: that costs nothing,
/// being done once for a robot.
class Recorder {
 public:
  explicit Recorder(Entries entries) : entries_(entries) {}
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  [[nodiscard]] dag::Graph& graph() { return graph_; }
  using Exact = derive::dynamics::Scalar;

  /// A number that is kept for this robot.
  Value stored(const Exact& number);
  /// An entry that a type of the library has anyway (the zeros of an identity): general, but not kept.
  Value entry(long number);
  /// A number of the formula itself, such as its 2 and 1/2: known to everyone.
  Value literal(const cln::cl_RA& number);
  /// An argument of the function: a joint variable, its rate.
  Value argument(const std::string& name);

  struct Circle {
    Value cosine, sine;
  };
  /// Sine and cosine of an angle, one call of a library.
  Circle circle(const dag::Angle& angle);

  Value sum(const Value& a, const Value& b);
  Value product(const Value& a, const Value& b);

  /// The operations that were asked for, whatever came of them.
  [[nodiscard]] const dag::OperationCounts& asked() const { return asked_; }
  /// The numbers kept for the robot, by the symbols that stand for them where entries are unknown.
  [[nodiscard]] const std::map<std::string, dag::Edge>& kept() const { return kept_; }
  [[nodiscard]] int stored_numbers() const { return stored_; }

 private:
  Value opaque(dag::Edge meaning);

  Entries entries_;
  dag::Graph graph_;
  dag::OperationCounts asked_;
  std::map<std::string, dag::Edge> kept_;
  int stored_ = 0;
};

/// True if a symbol stands for a number of the robot that the recorder took for unknown.
bool is_opaque(const std::string& symbol);

}  // namespace qvgen::compare
