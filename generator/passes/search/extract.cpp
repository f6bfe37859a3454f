// SPDX-License-Identifier: MIT
#include "passes/search/extract.h"

#include <optional>
#include <stdexcept>
#include <utility>

namespace qvgen::passes::search_detail {
namespace {

/// ENode with the smallest tree for every free class: sizes grow from operand to user, so it is acyclic.
std::vector<std::int32_t> smallest_trees(const Classes& classes) {
  constexpr std::uint64_t unknown = ~std::uint64_t{0} >> 2U;
  std::vector<std::uint64_t> size(classes.size(), unknown);
  std::vector<std::int32_t> choice(classes.size(), -1);
  for (std::uint32_t id = 0; id < classes.size(); ++id)
    if (classes[id].leaf) size[id] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t id = 0; id < classes.size(); ++id) {
      if (!classes[id].free || classes[id].leaf) continue;
      const auto& nodes = classes[id].nodes;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const ENode& d = nodes[i];
        if (!classes[d.a.id].free || !classes[d.b.id].free) continue;
        const std::uint64_t tree = size[d.a.id] + size[d.b.id] + 1;
        if (tree >= size[id]) continue;
        size[id] = tree;
        choice[id] = static_cast<std::int32_t>(i);
        changed = true;
      }
    }
  }
  return choice;
}

class Extractor {
 public:
  Extractor(const Classes& classes, const AngleTable& angles, const Network& network,
            const Selection& selection)
      : classes_(classes),
        angles_(angles),
        network_(network),
        selection_(selection),
        free_(smallest_trees(classes)),
        done_(classes.size()) {}

  dag::Edge edge(Ref ref) {
    std::optional<dag::Edge>& known = done_[ref.id];
    if (!known) known = make(ref.id);
    return ref.negative ? -*known : *known;
  }
  dag::Graph take() { return std::move(graph_); }

 private:
  dag::Edge make(std::uint32_t id) {
    const EClass& entry = classes_[id];
    const std::int32_t index =
        entry.free ? free_[id] : network_.choices[network_.first[id] + selection_[id]].node;
    if (index < 0) return make_leaf(*entry.leaf);
    const ENode& d = entry.nodes[static_cast<std::size_t>(index)];
    const dag::Edge a = edge(d.a);
    const dag::Edge b = edge(d.b);
    const dag::Edge result = make(d.op, a, b);
    return d.negative ? -result : result;
  }
  dag::Edge make(dag::Op op, dag::Edge a, dag::Edge b) {
    switch (op) {
      case dag::Op::sum:
        return constants(a, b) ? graph_.sum({a, b}) : graph_.as_is(op, {a, b});
      case dag::Op::product:
        return constants(a, b) ? graph_.product({a, b}) : graph_.as_is(op, {a, b});
      case dag::Op::quotient:
        return graph_.quotient(a, b);
      case dag::Op::root:
        return graph_.root(a);
      case dag::Op::arctangent:
        return graph_.arctangent(a, b);
      default:
        throw std::logic_error("a leaf has no operands");
    }
  }
  bool constants(dag::Edge a, dag::Edge b) const { return graph_.is_constant(a) && graph_.is_constant(b); }
  dag::Edge make_leaf(const Leaf& leaf) {
    const auto plain = [&] {
      switch (leaf.op) {
        case dag::Op::constant:
          return graph_.constant(leaf.number);
        case dag::Op::symbol:
          return graph_.symbol(leaf.symbol);
        case dag::Op::sine:
          return graph_.sine(angles_.angles[leaf.angle]);
        default:
          return graph_.cosine(angles_.angles[leaf.angle]);
      }
    }();
    return leaf.negative ? -plain : plain;
  }

  const Classes& classes_;
  const AngleTable& angles_;
  const Network& network_;
  const Selection& selection_;
  std::vector<std::int32_t> free_;
  std::vector<std::optional<dag::Edge>> done_;
  dag::Graph graph_;
};

}  // namespace

dag::Function extract(const Classes& classes, const AngleTable& angles, const Network& network,
                      const Selection& selection, const std::vector<std::pair<std::string, Ref>>& outputs) {
  Extractor extractor(classes, angles, network, selection);
  dag::Function result;
  for (const auto& [name, ref] : outputs) result.outputs.push_back({name, extractor.edge(ref)});
  result.graph = extractor.take();
  return result;
}

}  // namespace qvgen::passes::search_detail
