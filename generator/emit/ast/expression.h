// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// A syntax tree of what is emitted: expressions, statements and functions as values, of no language. They
/// are built from graphs and plans once; a printer of a language (emit/cpp, emit/c) turns them into text, and
/// nothing reads that text again. Example: `w.x = -a * (b + c);` is
///
///     assign(member(name("w"), "x"), product({negative(name("a")), sum({name("b"), name("c")})}))
namespace qvgen::emit::ast {

/// Numbers of which a value is made: any that the function is called with, doubles, or lanes of doubles.
enum class Element { generic, plain, lanes };

/// Type of a value. `name` is one of the runtime's ("Rotor"), of the generated file ("Work"), or a basic one:
/// real, int, bool; empty of a function without a result.
struct Type {
  std::string name = {};
  Element number = Element::generic;
};

/// How a name leads to its object: it is the object, a reference in languages that have them and else a
/// pointer, or a pointer in all.
enum class Reach { value, reference, pointer };

struct Expression {
  enum class Kind {
    nothing,          ///< no value; as an argument it is left out
    real,             ///< a number by its decimal text
    literal,          ///< a whole number or a truth value, by its text
    name,             ///< a variable
    member,           ///< `text` of an object
    entry,            ///< array, index
    convert,          ///< a double as a number of the function's type
    negative,         ///< -x
    sum,              ///< negative terms are subtracted
    product,          ///< of numbers
    quotient,         ///< numerator, denominator
    grouped,          ///< kept together by brackets
    compare,          ///< `text` is the operator
    is_not,           ///< true if the condition fails; in lanes, if it fails in all of them
    condition,        ///< condition, value if it holds, value if not
    sign,             ///< of a branch: 1 or -1, or one a lane
    sign_of_round,    ///< 1 in the first round of a loop, -1 in the second, by the loop's variable
    rotor,            ///< cosine, sine
    turned,           ///< product of two rotors
    scaled,           ///< number, rotor
    inverse,          ///< of a rotor
    angle,            ///< of a cosine and a sine
    pair,             ///< members of a struct that the place says the type of
    make,             ///< a struct `text` of the runtime, of its members
    direction,        ///< 1, -1 or 0 of a rate
    pi,               ///< as an argument of blocks, in languages whose blocks take it
    reference,        ///< an argument that a function changes, or too large to copy
    usual,            ///< an argument that is the parameter's default
    block,            ///< call of a building block `text` of the runtime
    direction_block,  ///< call of a block that makes a vector a direction; the first operand tells whether
                      ///< the opposite one is another branch
    runtime,          ///< call of another function of the runtime
    method,           ///< call of what an object, the first operand, can do
    own,              ///< call of a function of the generated file
    polishes,         ///< call of the step `text` that polishes: target, label, tracker, work
    polishes_seed,    ///< call of that step on the seed's branch
    function,         ///< sqrt, sin or cos, where nothing says of which library
    mathematical,     ///< sin or cos of the language's library
    named             ///< a function that a declaration in front has named
  };

  Kind kind = Kind::nothing;
  std::string text = {};
  std::vector<Expression> operands = {};
  Type type = {};
  Reach reach = Reach::value;
};
using Expressions = std::vector<Expression>;

Expression real(const std::string& decimal);
Expression whole(int value);
Expression truth(bool value);
Expression name(const std::string& text, const Type& type = {}, Reach reach = Reach::value);
Expression member(const Expression& object, const std::string& member, const Type& type = {},
                  Reach reach = Reach::value);
Expression entry(const Expression& array, const Expression& index, const Type& type = {});
/// An entry of an array with a name.
Expression entry(const std::string& array, std::size_t index);
Expression convert(const Expression& value, Element number = Element::generic);
Expression negative(const Expression& value);
Expression sum(const Expressions& terms);
Expression product(const Expressions& factors);
Expression quotient(const Expression& numerator, const Expression& denominator);
Expression grouped(const Expression& value);
Expression compare(const Expression& a, const std::string& by, const Expression& b);
Expression is_not(const Expression& condition);
Expression condition(const Expression& holds, const Expression& yes, const Expression& no);
/// Sign of a branch; in lanes one for each or one for all.
Expression sign(const std::vector<int>& signs, Element number = Element::plain);
Expression sign_of_round(const std::string& variable, Element number = Element::plain);
Expression rotor(const Expression& cosine, const Expression& sine);
Expression turned(const Expression& a, const Expression& b);
Expression scaled(const Expression& factor, const Expression& rotor);
Expression inverse(const Expression& rotor);
Expression angle(const Expression& cosine, const Expression& sine);
Expression pair(const Expressions& members, const Type& type = {});
Expression make(const std::string& type, const Expressions& members);
Expression pi();
Expression reference(const Expression& place);
Expression usual(const Expression& argument);
/// A call, of one of the kinds that are calls.
Expression call(Expression::Kind kind, const std::string& name, const Expressions& arguments);
Expression method(const Expression& object, const std::string& name, const Expressions& arguments = {});

/// True if an expression is a name, or one of its operands has it.
bool mentions(const Expression& expression, const std::string& name);

}  // namespace qvgen::emit::ast
