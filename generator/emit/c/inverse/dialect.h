// SPDX-License-Identifier: MIT
#pragma once

#include "emit/cpp/inverse/dialect.h"

namespace qvgen::emit::c {

/// C99. Work, targets, rows and trackers are behind pointers; `prefix` tells a robot's variants apart, in
/// front of their types and functions.
class C : public Dialect {
 public:
  explicit C(std::string prefix) : prefix_(std::move(prefix)) {}

  Spelling spelling() const override;
  std::string scalar(const std::string& value) const override { return value; }
  std::string member(const std::string& of, const std::string& name) const override {
    return of + "->" + name;
  }
  std::string reference(const std::string& place) const override { return "&" + place; }
  std::string rotor(const std::string& cosine, const std::string& sine) const override;
  std::string product(const std::string& a, const std::string& b) const override;
  std::string scaled(const std::string& factor, const std::string& rotor) const override;
  std::string inverse(const std::string& rotor) const override;
  std::string type(const std::string& name) const override { return name; }
  std::string braces(const std::string& type, const Arguments& members) const override;
  std::string pi() const override { return ""; }
  std::string function(const std::string& name) const override { return prefix_ + name; }
  std::string block(const std::string& name, const Arguments& arguments) const override;
  std::string direction_block(const std::string& name, bool opposites,
                              const Arguments& arguments) const override;
  std::string number_type() const override { return "double"; }
  std::string mathematical(const std::string& function) const override { return function; }
  std::string joint_value(std::size_t i) const override { return "values->of[" + std::to_string(i) + "]"; }
  std::string output_angle(const std::string& cosine, const std::string& sine,
                           const std::string& length) const override;
  std::string turn_apart(const std::string& cosine, const std::string& sine,
                         const std::string& seed) const override;
  std::string slide_apart(const std::string& value, const std::string& seed) const override;
  std::string wrist_apart(const std::string& angles, const Arguments& seed) const override;
  std::string takes_other(const std::string& other, const std::string& other_apart, const std::string& branch,
                          const std::string& apart) const override;

  Lines new_work(const std::string& name, bool all_zero) const override;
  Lines copied_work(const std::string& name, const std::string& from) const override;
  std::string assign_work(const std::string& name, const std::string& from) const override;
  std::string new_row(int size) const override;
  std::string save_branch(const std::string& name, const std::string& work) const override;
  std::string resume_branch(const std::string& work, const std::string& name) const override;
  std::string constant(const std::string& type, const std::string& name,
                       const std::string& value) const override;
  std::string variable(const std::string& type, const std::string& name,
                       const std::string& value) const override;
  std::string chosen(const std::string& type, const std::string& name,
                     const std::string& value) const override {
    return constant(type, name, value);
  }
  std::string entry(const std::string& array, const std::string& index) const override;
  std::string rows_found() const override { return "found->count"; }
  std::string append(const std::string& label, const std::string& work) const override;
  std::string append_nearest(const std::string& work) const override;
  std::string is_settled(const std::string& label, bool visits) const override;
  std::string close(const std::string& label) const override;
  std::string reopen(const std::string& label, const std::string& work, bool visits) const override;
  Lines polish_lines(const PolishTask& task) const override;
  std::string polishes(const std::string& step, const std::string& target, const std::string& label,
                       const std::string& work, bool of_seed) const override;
  std::string take_nearer(const std::string& other, const std::string& other_apart, const std::string& work,
                          const std::string& apart) const override;
  Lines nearest_root(const std::string& number, const std::string& take, const std::string& apart,
                     int branches) const override;

 private:
  std::string prefix_;
};

}  // namespace qvgen::emit::c
