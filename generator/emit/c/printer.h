// SPDX-License-Identifier: MIT
#pragma once

#include "emit/ast/c_like.h"

namespace qvgen::emit::c {

/// C99. References are pointers; `prefix` tells a robot's variants apart, in front of their types and
/// functions.
class Printer : public ast::CLikePrinter {
 public:
  explicit Printer(std::string prefix) : prefix_(std::move(prefix)) {}

  [[nodiscard]] ast::Lines function(const ast::Function& function) const override;
  /// Parameters that are not read are marked: compilers warn of them.
  [[nodiscard]] ast::Lines body(const std::vector<std::string>& parameters,
                                const ast::Statements& statements) const override;

 protected:
  [[nodiscard]] std::string spelled(const ast::Expression& expression) const override;
  [[nodiscard]] ast::Lines spelled(const ast::Statement& statement) const override;
  [[nodiscard]] std::string arrow(const ast::Expression& object) const override;

 private:
  [[nodiscard]] std::string type(const ast::Type& type) const;
  [[nodiscard]] std::string address(const ast::Expression& place) const;
  [[nodiscard]] std::string call(const ast::Expression& expression) const;
  [[nodiscard]] std::string method(const ast::Expression& expression) const;
  [[nodiscard]] ast::Lines declared(const ast::Statement& statement) const;
  [[nodiscard]] ast::Lines declared_work(const ast::Statement& statement) const;
  [[nodiscard]] std::string assigned(const ast::Statement& statement) const;
  [[nodiscard]] ast::Lines nearest_root(const ast::Statement& statement) const;
  [[nodiscard]] std::string parameters(const ast::Function& function) const;
  [[nodiscard]] ast::Lines polish(const ast::Function& function) const;
  [[nodiscard]] ast::Lines task_of(const ast::Function& function) const;

  std::string prefix_;
};

/// Printer of names without a prefix.
const ast::Printer& printer();

}  // namespace qvgen::emit::c
