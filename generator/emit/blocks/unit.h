// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

/// The C of a robot as a typed tree, from which further languages are printed. `runtime/` makes C of the
/// equations in headers of the C++ runtime; what is around them is C99 (templates/c/inverse). `parse` reads
/// the subset that all keep to: numbers, fixed arrays, structs, if, for, while, calls, pointers as parameters
/// or as other names of a place. What leaves it is an error with file and line. Example: `w->s = -t[1];` is
///
///     assign "=" (member "s" (dereference (name "w"))) (negative (index (name "t") (integer "1")))
namespace qvgen::emit::blocks {

/// A text that is not in the subset: "file:line: what is wrong: the line".
struct NotInSubset : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Type;
using TypeRef = std::shared_ptr<const Type>;
struct Type {
  enum class Kind { nothing, real, integer, natural, boolean, text, structure, array, pointer };
  Kind kind = Kind::nothing;
  std::string name = {};   ///< of a structure; of an array the constant that says its size, if one does
  TypeRef of = {};         ///< element of an array or what a pointer points at
  int size = 0;            ///< of an array; of a pointer parameter that says it: "double x[3]"; else 0
  bool constant = false;   ///< of what a pointer points at
  bool reference = false;  ///< a pointer whose name stands for what it points at, as in C++
};

struct Expression {
  enum class Kind {
    real,         ///< decimal text
    integer,      ///< text
    boolean,      ///< "true" or "false"
    text,         ///< a string with its quotation marks
    null,         ///< NULL
    name,         ///< a variable, constant or function
    member,       ///< field of an object
    index,        ///< array, index
    call,         ///< of a function `text`
    negative,     ///< -x
    is_not,       ///< !x
    complement,   ///< ~x
    dereference,  ///< *x, also in x->y
    address,      ///< &x
    binary,       ///< operator `text`
    conditional,  ///< c ? a : b
    assign,       ///< operator `text`: = += -= *= /= |= &=
    before,       ///< ++x or --x
    after,        ///< x++ or x--
    cast,         ///< (type) x
    size_of,      ///< of the operand's type
    list,         ///< initializer in braces; `type` says of what
    designated    ///< .field = x in a list
  };
  Kind kind = Kind::integer;
  std::string text = {};
  std::vector<Expression> operands = {};
  TypeRef type = {};
  int line = 0;
  bool is_global = false;  ///< a name that is no variable of its function
};
using Expressions = std::vector<Expression>;

struct Statement {
  enum class Kind { declare, evaluate, block, choose, loop_for, loop_while, leave, next, give, nothing };
  Kind kind = Kind::nothing;
  std::string name = {};  ///< of a declared variable
  TypeRef type = {};      ///< of it
  bool constant = false;  ///< declared const
  Expressions values =
      {};  ///< first value; condition; expression; of a loop: condition, step (each may lack)
  std::vector<Statement> body = {};       ///< block; what is done; body of a loop
  std::vector<Statement> otherwise = {};  ///< of choose
  std::vector<Statement> first = {};      ///< what a for loop begins with
  std::vector<std::string> comment = {};
  int line = 0;
};
using Statements = std::vector<Statement>;

struct Field {
  std::string name;
  TypeRef type;
  std::vector<std::string> doc = {};
};

struct Structure {
  std::string name;
  std::vector<std::string> doc;
  std::vector<Field> fields;
  std::string module;
  bool is_public = false;
};

struct Constant {
  std::string name;
  std::vector<std::string> doc;
  TypeRef type;
  Expressions value;  ///< one
  std::string module;
  bool is_public = false;
};

struct Function {
  std::string name;
  std::vector<std::string> doc;
  TypeRef result;
  std::vector<Field> parameters;
  Statements body;
  std::string module;
  bool is_public = false;
  bool is_defined = false;
};

/// Definitions, in the order of the text.
struct Unit {
  std::string robot;
  std::vector<std::string> modules;
  std::map<std::string, Structure> structures;
  std::vector<std::string> structure_order;
  std::vector<Constant> constants;  ///< enumerators too, as integers
  std::vector<Function> functions;

  [[nodiscard]] const Function* function(const std::string& name) const;
  [[nodiscard]] const Constant* constant(const std::string& name) const;
  /// The constant that an expression names, or nothing.
  [[nodiscard]] const Constant* constant_of(const Expression& expression) const;
};

/// A file of C: "qvgen_ur5.h" and its text. Files of one module see each other's static names.
struct File {
  std::string name;
  std::string module;
  bool is_header = false;
  std::string text;
};

/// Reads files in their order, headers in front of the sources that use them. Throws NotInSubset.
Unit parse(const std::string& robot, const std::vector<File>& files);

}  // namespace qvgen::emit::blocks
