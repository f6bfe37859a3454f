// SPDX-License-Identifier: MIT
#pragma once

#include "emit/ast/c_like.h"

namespace qvgen::emit {

/// C++ with the runtime's templates. `lane` is the type that lanes of doubles have, where there are any:
/// "Pack" of branches, "Lane" of poses.
class CppPrinter : public ast::CLikePrinter {
 public:
  explicit CppPrinter(std::string lane = {}) : lane_(std::move(lane)) {}

  using ast::CLikePrinter::text;
  [[nodiscard]] ast::Lines function(const ast::Function& function) const override;

 protected:
  [[nodiscard]] std::string spelled(const ast::Expression& expression) const override;
  [[nodiscard]] ast::Lines spelled(const ast::Statement& statement) const override;
  [[nodiscard]] std::string arrow(const ast::Expression& object) const override;
  [[nodiscard]] std::string unroll() const override { return "#pragma GCC unroll 2"; }
  /// A number by its decimal text, and a call of sqrt, sin or cos where nothing says of which library.
  [[nodiscard]] virtual std::string real(const std::string& decimal) const;
  [[nodiscard]] virtual std::string function(const std::string& name, const std::string& value) const;
  [[nodiscard]] virtual std::string mathematical(const std::string& name, const std::string& value) const;

 private:
  [[nodiscard]] std::string number(ast::Element number) const;
  [[nodiscard]] std::string type(const ast::Type& type) const;
  [[nodiscard]] std::string call(const ast::Expression& expression) const;
  [[nodiscard]] std::string sign(const ast::Expression& expression) const;
  [[nodiscard]] ast::Lines declared(const ast::Statement& statement) const;
  [[nodiscard]] ast::Lines nearest_root(const ast::Statement& statement) const;
  [[nodiscard]] std::string head(const ast::Function& function) const;
  [[nodiscard]] ast::Lines polish(const ast::Polish& task) const;
  [[nodiscard]] std::string parameter(const ast::Function& function,
                                      const ast::Function::Parameter& parameter) const;

  std::string lane_;
};

/// C++ whose functions begin with `using std::sqrt;`, with Scalar as the number.
const ast::Printer& cpp();
/// C++ without such a declaration: Scalar's own functions, or the standard library's for its type.
const ast::Printer& plain_cpp();

}  // namespace qvgen::emit
