// SPDX-License-Identifier: MIT
#include "passes/search/classes.h"

#include <algorithm>
#include <utility>

#include "passes/search/random.h"

namespace qvgen::passes::search_detail {
namespace {

constexpr std::uint32_t none = ~0U;

bool is_canonical(Field value) { return value <= -value; }

Field canonical(Field value) { return is_canonical(value) ? value : -value; }

Leaf number(long value) { return {dag::Op::constant, exact::Number(value), {}, 0, false}; }

}  // namespace

Classes::Classes() : table_(1024, none) {
  leaf(number(0), Field(), true);
  leaf(number(1), Field::from(1), true);
}

std::size_t Classes::slot(Field key) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t place = mix(key.bits()) & mask;
  while (table_[place] != none && classes_[table_[place]].value != key) place = (place + 1) & mask;
  return place;
}

std::optional<Ref> Classes::find(Field value) const {
  const Field key = canonical(value);
  const std::uint32_t id = table_[slot(key)];
  if (id == none) return std::nullopt;
  return Ref{id, key != value};
}

Ref Classes::intern(Field value) {
  const Field key = canonical(value);
  const std::size_t place = slot(key);
  if (table_[place] != none) return {table_[place], key != value};
  const std::uint32_t id = size();
  table_[place] = id;
  classes_.push_back({key, std::nullopt, false, {}});
  if (classes_.size() * 2 > table_.size()) grow();
  return {id, key != value};
}

void Classes::grow() {
  table_.assign(table_.size() * 2, none);
  for (std::uint32_t id = 0; id < size(); ++id) table_[slot(classes_[id].value)] = id;
}

Ref Classes::leaf(Leaf leaf, Field value, bool free) {
  const Ref ref = intern(value);
  EClass& entry = classes_[ref.id];
  if (!entry.leaf) {
    leaf.negative = ref.negative;
    entry.leaf = std::move(leaf);
  }
  entry.free = entry.free || free;
  return ref;
}

/// Definitions that mention the class itself, and those of a number or symbol, are of no use.
Ref Classes::define(Field value, ENode node) {
  const Ref ref = intern(value);
  EClass& entry = classes_[ref.id];
  const bool atom = entry.leaf && entry.leaf->op != dag::Op::sine && entry.leaf->op != dag::Op::cosine;
  if (atom || node.a.id == ref.id || node.b.id == ref.id) return ref;
  if (node.op == dag::Op::sum) {
    node.a = node.a.signed_by(ref.negative);
    node.b = node.b.signed_by(ref.negative);
  } else {
    node.negative = node.negative != ref.negative;
  }
  if (classes_[node.a.id].free && classes_[node.b.id].free) entry.free = true;
  if (std::find(entry.nodes.begin(), entry.nodes.end(), node) == entry.nodes.end())
    entry.nodes.push_back(node);
  return ref;
}

Ref Classes::sum(Ref a, Ref b) {
  if (a.id == zero) return b;
  if (b.id == zero) return a;
  if (b.id < a.id) std::swap(a, b);
  return define(value(a) + value(b), {dag::Op::sum, false, a, b});
}

Ref Classes::product(Ref a, Ref b) {
  if (a.id == zero || b.id == zero) return {zero, false};
  if (a.id == one) return b.signed_by(a.negative);
  if (b.id == one) return a.signed_by(b.negative);
  if (b.id < a.id) std::swap(a, b);
  return define(value(a) * value(b),
                {dag::Op::product, a.negative != b.negative, {a.id, false}, {b.id, false}});
}

Ref Classes::quotient(Ref a, Ref b) {
  if (a.id == zero) return a;
  if (b.id == one) return a.signed_by(b.negative);
  const Field result = value(a) * value(b).inverse();
  if (classes_[b.id].free && a.id != one) return product(a, quotient({one, false}, b));
  return define(result, {dag::Op::quotient, a.negative != b.negative, {a.id, false}, {b.id, false}});
}

Ref Classes::opaque(dag::Op op, Ref a, Ref b, Field value) { return define(value, {op, false, a, b}); }

void Classes::propagate_free() {
  const auto from_free = [this](const ENode& d) { return classes_[d.a.id].free && classes_[d.b.id].free; };
  for (bool changed = true; changed;) {
    changed = false;
    for (EClass& entry : classes_) {
      if (entry.free || std::none_of(entry.nodes.begin(), entry.nodes.end(), from_free)) continue;
      entry.free = changed = true;
    }
  }
}

}  // namespace qvgen::passes::search_detail
