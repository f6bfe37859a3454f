// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "dag/graph.h"
#include "passes/search/classes.h"
#include "passes/search/fingerprint.h"

namespace qvgen::passes::search_detail {

/// Leaves shared by all forms: the angles, and how the leaf pairs are to be made again.
struct AngleTable {
  std::vector<dag::Angle> angles;
  std::vector<bool> free;
  std::uint32_t index(const dag::Angle& angle, bool is_free);
};

/// Reads forms into one set of value classes, in an order that depends on the structure of the expressions
/// alone.
class Loader {
 public:
  Loader(Classes& classes, Fingerprint& fingerprint, AngleTable& angles,
         std::function<bool(const std::string&)> is_free);
  /// The class of every output, by name.
  std::map<std::string, Ref> load(const dag::Function& form);

 private:
  Ref visit(const dag::Graph& graph, dag::Edge edge);
  Ref make(const dag::Graph& graph, const dag::Node& node);
  Ref make_leaf(const dag::Graph& graph, const dag::Node& node);

  Classes& classes_;
  Fingerprint& fingerprint_;
  AngleTable& angles_;
  std::function<bool(const std::string&)> is_free_symbol_;
  std::vector<std::optional<Ref>> done_;
};

/// a1 + a2 + ... or a1 a2 ...: up to four operands in every order, more in groups of four.
Ref combine(Classes& classes, dag::Op op, const std::vector<Ref>& operands);

}  // namespace qvgen::passes::search_detail
