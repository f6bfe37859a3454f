// SPDX-License-Identifier: MIT
#include "emit/blocks/runtime/runtime.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "emit/blocks/c_text.h"

namespace qvgen::emit::blocks::runtime {
namespace {

using Kind = Expression::Kind;

bool is_truth(const Expression& e) { return e.type->kind == Type::Kind::boolean; }
bool is_rotor(const Expression& e) {
  return e.type->kind == Type::Kind::structure && e.type->name == "Rotor";
}
bool is_whole(const Expression& e) { return e.type->kind == Type::Kind::integer; }
bool is_real(const Expression& e) { return e.type->kind == Type::Kind::real; }
bool is_place(const Expression& e) {
  return e.kind == Kind::name || e.kind == Kind::member || e.kind == Kind::index;
}

/// The parser of C with what C++ says by types.
class HeaderParser : public Parser {
 public:
  HeaderParser(const File& file, Scope& scope, Tokens tokens, Known& known)
      : Parser(file, scope, std::move(tokens)), known_(known) {}

 protected:
  /// A type with its sizes: `Columns<joints, 2 * rows>`.
  TypeRef base_type(Specifiers& into) override {
    const TypeRef type = Parser::base_type(into);
    if (!accept("<")) return type;
    Expressions sizes;
    do sizes.push_back(size());
    while (accept(","));
    expect(">");
    return sized(type, sizes);
  }

  /// The name of a reference is what it stands for, that of a size its field.
  Expression variable(const std::string& name) override {
    if (const auto field = field_of_size(name)) return *field;
    if (in_size_ && !is_local(name)) return made(Kind::name, name, {}, basic(Type::Kind::integer));
    Expression result = Parser::variable(name);
    if (!result.type->reference) return result;
    const TypeRef type = result.type->of;
    return made(Kind::dereference, "", {std::move(result)}, type);
  }

  /// Truth values have the operators of C's; products of rotors are calls. Whole numbers beside others become
  /// such by a cast: float does not have all.
  [[nodiscard]] Expression combined(const std::string& sign, Expression left,
                                    Expression right) const override {
    static const std::map<std::string, std::string> of_truth{{"&", "&&"}, {"|", "||"}, {"^", "!="}};
    const auto truth = of_truth.find(sign);
    if (truth != of_truth.end() && is_truth(left) && is_truth(right))
      return Parser::combined(truth->second, std::move(left), std::move(right));
    if (is_real(left) && is_whole(right)) right = as_real(std::move(right));
    if (is_real(right) && is_whole(left)) left = as_real(std::move(left));
    if (sign != "*" || !is_rotor(right)) return Parser::combined(sign, std::move(left), std::move(right));
    const char* name = is_rotor(left) ? "product" : "scaled";
    const TypeRef type = right.type;
    return made(Kind::call, name, {std::move(left), std::move(right)}, type);
  }

  /// A member, or a method: `branch.doubt(x)` is `doubt(branch, x)`.
  Expression part_of(Expression object) override {
    const std::string part = name();
    if (!is("(")) return field_with_sizes(std::move(object), part);
    Expressions list{std::move(object)};
    add_arguments(part, list);
    return called(part, std::move(list));
  }

  /// An entry, of a struct that stands for an array too.
  Expression entry_of(Expression object, Expression index) override {
    const bool is_named =
        object.type->kind == Type::Kind::structure && known_.arrays.count(object.type->name) > 0;
    if (is_named) object = field_with_sizes(std::move(object), "of");
    return Parser::entry_of(std::move(object), std::move(index));
  }

  Expression call(const std::string& name) override {
    if (is_local(name)) fail("a variable hides the function " + name);
    Expressions list;
    add_arguments(name, list);
    if (name != "select") return called(name, std::move(list));
    if (list.size() != 3) fail("select has three arguments");
    const TypeRef type = is_truth(list[1]) ? list[1].type : common(list[1].type, list[2].type);
    return made(Kind::conditional, "", std::move(list), type);
  }

  /// Assigns the values that a struct gives its fields.
  Statements declarations() override {
    Statements result;
    for (Statement& each : Parser::declarations()) {
      const bool is_open = each.values.empty() && each.type->kind == Type::Kind::structure;
      result.push_back(std::move(each));
      if (is_open) add_defaults(result);
    }
    return result;
  }

 private:
  using Sizes = std::map<std::string, Expression>;

  [[nodiscard]] Expression as_real(Expression whole) const {
    if (whole.kind == Kind::integer) return whole;
    return made(Kind::cast, "", {std::move(whole)}, basic(Type::Kind::real));
  }

  /// A size between the brackets of a type: a sum of what may be declared later.
  Expression size() {
    in_size_ = true;
    Expression result = binary(precedence("+"));
    in_size_ = false;
    return result;
  }

  /// A size that a parameter has as its field, if one does.
  [[nodiscard]] std::optional<Expression> field_of_size(const std::string& name) const {
    if (is_local(name)) return std::nullopt;
    for (const auto& scope : locals_)
      for (const auto& [variable, type] : scope) {
        const bool is_pointer = type->kind == Type::Kind::pointer;
        const TypeRef object = is_pointer ? type->of : type;
        if (object->kind != Type::Kind::structure || known_.with_fields.count(object->name) == 0) continue;
        const std::vector<std::string>& fields = known_.sized.at(object->name);
        if (std::find(fields.begin(), fields.end(), name) == fields.end()) continue;
        Expression place = made(Kind::name, variable, {}, type);
        if (is_pointer) place = made(Kind::dereference, "", {std::move(place)}, object);
        return field_of(std::move(place), name);
      }
    return std::nullopt;
  }

  /// A size as an expression of the function that is read.
  [[nodiscard]] Expression declared(Expression size) const {
    if (size.kind == Kind::name) {
      if (const auto field = field_of_size(size.text)) return *field;
      if (!is_local(size.text)) fail("the size " + size.text + " is not declared");
    }
    for (Expression& each : size.operands) each = declared(std::move(each));
    return size;
  }

  TypeRef sized(const TypeRef& type, Expressions sizes) const {
    const auto known = known_.sized.find(type->name);
    if (known == known_.sized.end() || known->second.size() != sizes.size())
      fail("another number of sizes than " + type->name + " has");
    const TypeRef result = std::make_shared<const Type>(*type);
    known_.sizes[result] = std::move(sizes);
    return result;
  }

  /// Sizes of a struct by their names in its template; where none are written they have these names.
  [[nodiscard]] Sizes sizes_of(const TypeRef& type) const {
    Sizes result;
    const auto names = known_.sized.find(type->name);
    if (type->kind != Type::Kind::structure || names == known_.sized.end()) return result;
    const auto written = known_.sizes.find(type);
    for (std::size_t i = 0; i < names->second.size(); ++i) {
      const std::string& name = names->second[i];
      result[name] = written != known_.sizes.end() ? written->second[i]
                                                   : made(Kind::name, name, {}, basic(Type::Kind::integer));
    }
    return result;
  }

  /// An expression of sizes with others in the place of their names.
  static Expression with(const Sizes& sizes, Expression e) {
    if (e.kind == Kind::name)
      if (const auto known = sizes.find(e.text); known != sizes.end()) return known->second;
    for (Expression& each : e.operands) each = with(sizes, std::move(each));
    return e;
  }

  /// A type whose sizes are said by those of what it is a part or the result of.
  [[nodiscard]] TypeRef with_sizes(const TypeRef& type, const Sizes& sizes) const {
    if (type->kind == Type::Kind::array) return array_of(with_sizes(type->of, sizes), type->size, type->name);
    const auto written = known_.sizes.find(type);
    if (written == known_.sizes.end()) return type;
    Expressions own = written->second;
    for (Expression& each : own) each = with(sizes, std::move(each));
    return sized(type, own);
  }

  [[nodiscard]] Expression field_with_sizes(Expression object, const std::string& name) const {
    const TypeRef owner = object.type;
    Expression result = field_of(std::move(object), name);
    result.type = with_sizes(result.type, sizes_of(owner));
    return result;
  }

  /// Sizes of a function, by their names there, that the types of a call's arguments say.
  [[nodiscard]] Sizes deduced(const Function& function, const Expressions& list) const {
    const std::size_t count = function.parameters.size() - list.size();
    Sizes result;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const TypeRef& parameter = function.parameters[count + i].type;
      const Sizes given = sizes_of(list[i].type);
      for (const auto& [name, said] :
           sizes_of(parameter->kind == Type::Kind::pointer ? parameter->of : parameter))
        if (const auto known = given.find(name); said.kind == Kind::name && known != given.end())
          result.emplace(said.text, known->second);
    }
    return result;
  }

  /// Puts the sizes of a function in front of a call's arguments.
  void add_sizes(const Function& function, const Sizes& sizes, Expressions& list) const {
    Expressions all;
    for (std::size_t i = 0; i + list.size() < function.parameters.size(); ++i) {
      const auto known = sizes.find(function.parameters[i].name);
      if (known == sizes.end())
        fail("no argument says the " + function.parameters[i].name + " of " + function.name);
      all.push_back(declared(known->second));
    }
    list.insert(list.begin(), all.begin(), all.end());
  }

  void add_arguments(const std::string& name, Expressions& list) {
    const Function* known = scope_.unit.function(name);
    expect("(");
    while (!accept(")")) {
      if (is("{")) {
        if (known == nullptr || list.size() >= known->parameters.size()) fail("braces without a type");
        list.push_back(listed(known->parameters[list.size()].type));
      } else {
        list.push_back(conditional());
      }
      if (!accept(",") && !is(")")) fail("expected a comma between arguments");
    }
  }

  /// A call with pointers where the function has them, and without pi where that is a constant.
  [[nodiscard]] Expression called(const std::string& wanted, Expressions list) const {
    const std::string name =
        overload_in_c(wanted, list.size(), !list.empty() && list.front().type && is_rotor(list.front()));
    const Function* known = scope_.unit.function(name);
    if (known == nullptr) {
      const TypeRef real = basic(Type::Kind::real);
      if (!is_of_library(name)) fail("the function " + name + " is not declared");
      return made(Kind::call, name, std::move(list), name == "signbit" ? basic(Type::Kind::boolean) : real);
    }
    const std::vector<Field>& parameters = known->parameters;
    for (std::size_t i = list.size(); i-- > 0 && list.size() > parameters.size();)
      if (list[i].kind == Kind::name && list[i].text == "pi") list.erase(list.begin() + static_cast<int>(i));
    if (list.size() > parameters.size()) fail("another number of arguments than " + name + " has");
    const Sizes sizes = deduced(*known, list);
    add_sizes(*known, sizes, list);
    for (std::size_t i = 0; i < list.size(); ++i)
      if (parameters[i].type->kind == Type::Kind::pointer) list[i] = pointer_at(std::move(list[i]));
    return made(Kind::call, name, std::move(list), with_sizes(known->result, sizes));
  }

  [[nodiscard]] Expression pointer_at(Expression e) const {
    if (e.kind == Kind::dereference) return e.operands[0];
    if (e.type->kind == Type::Kind::pointer) return e;
    if (!is_place(e)) fail("a reference to what has no name");
    const TypeRef type = pointer_to(e.type, false);
    return made(Kind::address, "", {std::move(e)}, type);
  }

  void add_defaults(Statements& list) {
    Statement& declared = list.back();
    const std::string constant = "new_" + snake(declared.type->name);
    if (scope_.unit.constant(constant) != nullptr) {
      declared.values = {Parser::variable(constant)};
      return;
    }
    Expression object = Parser::variable(declared.name);
    assign_defaults(object, list);
  }

  void assign_defaults(const Expression& object, Statements& list) {
    const auto defaults = known_.defaults.find(object.type->name);
    for (const Field& each : scope_.unit.structures.at(object.type->name).fields) {
      Expression field = field_of(object, each.name);
      if (each.type->kind == Type::Kind::structure) assign_defaults(field, list);
      if (defaults == known_.defaults.end()) continue;
      for (const auto& [name, value] : defaults->second) {
        if (name != each.name) continue;
        Statement set = made(Statement::Kind::evaluate);
        set.comment.clear();
        set.values = {made(Kind::assign, "=", {field, made(Kind::integer, value, {}, each.type)}, each.type)};
        list.push_back(set);
      }
    }
  }

  using Parser::made;
  Known& known_;
  bool in_size_ = false;  ///< between the brackets of a type
};

}  // namespace

void Reader::read_c(const File& file) {
  const std::vector<std::string>& names = scope_.unit.structure_order;
  const std::size_t known = names.size();
  Parser(file, scope_).run();
  for (std::size_t i = known; i < names.size(); ++i) {
    std::vector<std::string> sizes;
    for (const Field& each : scope_.unit.structures.at(names[i]).fields) {
      if (scope_.numbers.count("most_" + each.name) == 0) break;
      sizes.push_back(each.name);
    }
    if (sizes.empty()) continue;
    known_.with_fields.insert(names[i]);
    known_.sized[names[i]] = sizes;
  }
}

std::string Reader::in_c(const File& header) {
  const Unit& unit = scope_.unit;
  const auto skipped = [&](const std::string& name) {
    return is_of_library(name) || unit.function(name) != nullptr || unit.constant(name) != nullptr ||
           unit.structures.count(name) > 0;
  };
  const std::size_t structures = unit.structure_order.size(), constants = unit.constants.size(),
                    functions = unit.functions.size();
  HeaderParser(header, scope_, words_of(header, skipped, known_), known_).run();
  std::string text;
  const auto add_constants = [&](bool of_structures) {
    for (std::size_t i = constants; i < unit.constants.size(); ++i)
      if ((unit.constants[i].type->kind == Type::Kind::structure) == of_structures)
        text += c_text(unit, unit.constants[i]);
  };
  add_constants(false);
  for (std::size_t i = structures; i < unit.structure_order.size(); ++i)
    text += c_text(unit, unit.structures.at(unit.structure_order[i]));
  add_constants(true);
  for (std::size_t i = functions; i < unit.functions.size(); ++i) text += c_text(unit, unit.functions[i]);
  return text;
}

}  // namespace qvgen::emit::blocks::runtime
