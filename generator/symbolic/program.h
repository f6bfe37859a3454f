// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <vector>

#include <ginac/ginac.h>

#include "symbolic/algebra.h"

namespace qvgen::symbolic {

/// A straight-line derivation: named intermediate results, each in terms of the model's symbols and of
/// earlier names, and the results. GiNaC flattens nested sums, so whatever is to stay shared must be named.
class Program {
 public:
  struct Step {
    GiNaC::symbol name;
    GiNaC::ex value;
  };
  struct Output {
    std::string name;
    GiNaC::ex value;
  };

  /// Names a value and returns its symbol; atoms (numbers, symbols, and their negatives) are returned
  /// unnamed.
  GiNaC::ex let(const GiNaC::ex& value);
  Quaternion let(const Quaternion& value);
  Vector let(const Vector& value);
  Matrix3 let(const Matrix3& value);
  void output(const std::string& name, const GiNaC::ex& value);
  /// Takes over a step of another program that began as a copy of this one.
  void append(const Step& step) { steps_.push_back(step); }
  /// A result that later values of this program may use by its symbol.
  void output(const GiNaC::symbol& name, const GiNaC::ex& value);

  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  [[nodiscard]] const std::vector<Output>& outputs() const { return outputs_; }
  /// Names of the symbols that the values read, those of the steps not among them. Each value is looked
  /// through once: plans are asked for this again and again.
  [[nodiscard]] const std::set<std::string>& reads() const;
  /// Every output written out in the model's symbols alone (may be large).
  [[nodiscard]] std::vector<Output> expanded() const;

 private:
  std::vector<Step> steps_;
  std::vector<Output> outputs_;

  /// Knowledge of the first steps and outputs.
  struct Read {
    std::set<std::string> names, own;
    std::size_t steps = 0, outputs = 0;
  };
  mutable Read read_;
};

}  // namespace qvgen::symbolic
