// SPDX-License-Identifier: MIT
#include "emit/blocks/stack.h"

#include <algorithm>
#include <set>

#include "emit/blocks/analysis.h"

namespace qvgen::emit::blocks {
namespace {

constexpr int word = 8, registers = 8 * word, alignment = 16;

int rounded_up(int bytes, int to) { return (bytes + to - 1) / to * to; }

class Stack {
 public:
  Stack(const Unit& unit, int real_bytes) : unit_(unit), real_(real_bytes) {}

  std::map<std::string, int> run() {
    for (const Function& each : unit_.functions)
      if (each.is_defined) (void)below(each);
    return std::move(known_);
  }

 private:
  int size(const TypeRef& type) const {
    switch (type->kind) {
      case Type::Kind::nothing:
        return 0;
      case Type::Kind::real:
        return real_;
      case Type::Kind::boolean:
        return 1;
      case Type::Kind::integer:
      case Type::Kind::natural:
        return 4;
      case Type::Kind::array:
        return type->size * size(type->of);
      case Type::Kind::structure:
        return structure_size(unit_.structures.at(type->name));
      default:
        return word;
    }
  }

  int structure_size(const Structure& structure) const {
    int bytes = 0;
    for (const Field& each : structure.fields) bytes = rounded_up(bytes, word) + size(each.type);
    return rounded_up(bytes, word);
  }

  int place(const TypeRef& type) const { return rounded_up(size(type), word); }

  /// Bytes of a function's frame: registers, arguments, variables, and structs that calls hand over or give
  /// back.
  int own(const Function& function) const {
    int bytes = registers + place(function.result);
    for (const Field& each : function.parameters) bytes += place(each.type);
    for_each_statement(function.body, [&](const Statement& each) {
      if (each.kind == Statement::Kind::declare) bytes += place(each.type);
    });
    for_each(function.body, [&](const Expression& each) { bytes += between(each); });
    return rounded_up(bytes, alignment);
  }

  /// Bytes for the value of an expression, if it may have to be kept.
  int between(const Expression& e) const {
    if (e.kind == Expression::Kind::binary) return word;
    if (e.kind != Expression::Kind::call) return 0;
    int bytes = e.type ? place(e.type) : 0;
    for (const Expression& each : e.operands)
      if (each.type && each.type->kind == Type::Kind::structure) bytes += place(each.type);
    return bytes;
  }

  int below(const Function& function) {
    if (const auto found = known_.find(function.name); found != known_.end()) return found->second;
    if (!open_.insert(function.name).second)
      throw NotInSubset(function.name + ": calls itself, so that its stack has no bound");
    int deepest = 0;
    for_each(function.body, [&](const Expression& each) {
      if (each.kind != Expression::Kind::call) return;
      const Function* callee = unit_.function(each.text);
      if (callee != nullptr && callee->is_defined) deepest = std::max(deepest, below(*callee));
    });
    open_.erase(function.name);
    return known_[function.name] = own(function) + deepest;
  }

  const Unit& unit_;
  int real_;
  std::map<std::string, int> known_;
  std::set<std::string> open_;
};

}  // namespace

std::map<std::string, int> stack_bytes(const Unit& unit, int real_bytes) {
  return Stack(unit, real_bytes).run();
}

}  // namespace qvgen::emit::blocks
