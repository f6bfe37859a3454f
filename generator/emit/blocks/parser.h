// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "emit/blocks/lexer.h"
#include "emit/blocks/types.h"

/// Reads C into a unit, one file after the other. Every expression gets its type as it is read: C declares
/// names before it uses them.
namespace qvgen::emit::blocks {

/// Types and names of what has been read, which later files see.
struct Scope {
  Unit unit;
  std::map<std::string, TypeRef> types;  ///< by typedef name
  std::map<std::string, int> numbers;    ///< values of enumerators
};

class Parser {
 public:
  Parser(const File& file, Scope& scope) : Parser(file, scope, tokens_of(file)) {}
  Parser(const File& file, Scope& scope, std::vector<Token> tokens)
      : file_(file), scope_(scope), tokens_(std::move(tokens)) {}
  virtual ~Parser() = default;

  void run();

 protected:
  struct Declarator {
    std::string name;
    TypeRef type;
  };
  struct Specifiers {
    TypeRef type;
    bool constant = false;
    bool is_static = false;
    bool is_extern = false;
  };

  // Words: parser.cpp.
  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const;
  Token take();
  [[nodiscard]] bool is(const std::string& text, std::size_t ahead = 0) const;
  bool accept(const std::string& text);
  void expect(const std::string& text);
  std::string name();
  [[noreturn]] void fail(const std::string& what) const;

  // Definitions: parser.cpp.
  void definition();
  void type_definition(const std::vector<std::string>& doc);
  TypeRef structure(const std::string& name, const std::vector<std::string>& doc);
  void fields(Structure& into);
  void enumerators(const std::vector<std::string>& doc);
  void function(const Specifiers& specifiers, const Declarator& declared,
                const std::vector<std::string>& doc);
  void constants(const Specifiers& specifiers, Declarator declared, const std::vector<std::string>& doc);
  std::vector<Field> parameters();
  std::string own_name(const std::string& name);

  // Types: types.cpp.
  [[nodiscard]] bool begins_type(std::size_t ahead = 0) const;
  Specifiers specifiers();
  virtual TypeRef base_type(Specifiers& into);
  Declarator declarator(const Specifiers& specifiers, bool is_parameter = false);
  TypeRef declarator_free_type();
  int constant_value();
  [[nodiscard]] int value_of(const Expression& expression) const;

  // Statements: statements.cpp.
  Statements block();
  Statement statement();
  virtual Statements declarations();
  Statement loop_for();
  Statement choose();
  Statement simple();
  Statement made(Statement::Kind kind) const;

  // Expressions: expressions.cpp.
  Expression expression();
  Expression conditional();
  Expression binary(int least);
  [[nodiscard]] virtual Expression combined(const std::string& sign, Expression left, Expression right) const;
  Expression unary();
  Expression cast_or_brackets();
  Expression size_of();
  Expression postfix();
  Expression behind(Expression object);
  virtual Expression part_of(Expression object);
  virtual Expression entry_of(Expression object, Expression index);
  Expression primary();
  virtual Expression variable(const std::string& name);
  virtual Expression call(const std::string& name);
  Expressions arguments();
  Expression initializer(const TypeRef& type);
  Expression listed(const TypeRef& type);
  [[nodiscard]] Expression field_of(Expression object, const std::string& field) const;
  [[nodiscard]] Expression made(Expression::Kind kind, const std::string& text, Expressions operands,
                                TypeRef type) const;
  [[nodiscard]] TypeRef type_of(const std::string& name) const;
  [[nodiscard]] bool is_local(const std::string& name) const;

  const File& file_;
  Scope& scope_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::vector<std::map<std::string, TypeRef>> locals_;
  TypeRef result_ = {};  ///< of the function that is read
};

/// Precedence of an operator of two operands; 0 if it is none.
int precedence(const std::string& sign);
/// True for functions of <math.h> and <string.h> that blocks call.
bool is_of_library(const std::string& name);

}  // namespace qvgen::emit::blocks
