// SPDX-License-Identifier: MIT
#include "compare/measure.h"

#include <algorithm>

#include "compare/certify.h"
#include "compare/storage.h"
#include "dag/rebuild.h"
#include "passes/constants.h"
#include "passes/pass.h"
#include "passes/search/search.h"
#include "verify/same_pose.h"

namespace qvgen::compare {
namespace {

/// The algorithm as a function; where entries are unknown, with what they are.
struct Recorded {
  dag::Function function;
  dag::Function kept;  ///< the unknown entries, by their symbols
  dag::OperationCounts asked;
  int stored_numbers = 0;
};

Recorded record(const Formulation& formulation, const model::Robot& robot, Entries entries) {
  Recorder recorder(entries);
  const Results results = formulation.run(recorder, robot);
  Recorded recorded;
  for (const Result& result : results)
    recorded.function.outputs.push_back({result.name, result.value.edge()});
  for (const auto& [symbol, meaning] : recorder.kept()) recorded.kept.outputs.push_back({symbol, meaning});
  recorded.function.graph = recorded.kept.graph = recorder.graph();
  recorded.asked = recorder.asked();
  recorded.stored_numbers = recorder.stored_numbers();
  return recorded;
}

bool has_named_constants(const dag::Function& function) {
  const dag::Graph& graph = function.graph;
  for (const std::uint32_t id : dag::reachable(function)) {
    const dag::Node& node = graph.node(id);
    if (node.op == dag::Op::symbol && passes::is_named_constant(graph.symbol_of(node))) return true;
    if (node.op != dag::Op::sine && node.op != dag::Op::cosine) continue;
    for (const auto& term : graph.angle_of(node).terms)
      if (passes::is_named_constant(term.first)) return true;
  }
  return false;
}

Measured textbook(const Recorded& recorded) {
  return {recorded.asked, recorded.stored_numbers, most_alive(recorded.function, is_opaque),
          recorded.function};
}

Measured counted(dag::Function function, const dag::IsFree& is_free) {
  return {dag::count(function, is_free), constants_of(function, is_free), most_alive(function, is_free),
          std::move(function)};
}

dag::Function searched(const dag::Function& specialised, What what, const dag::IsFree& is_free) {
  passes::SearchOptions options;
  options.iterations = what == What::dynamics ? 200'000 : 50'000;
  options.is_free_symbol = is_free;
  return passes::search({passes::simplify(specialised), specialised}, {}, options);
}

}  // namespace

const std::vector<std::string>& level_names() {
  static const std::vector<std::string> names{"textbook", "specialised", "optimised"};
  return names;
}

namespace {

/// A canonical arm that is the described one, certified.
Subject::View view_of(What what, const model::Robot& described, canonical::Arm arm) {
  verify::certify_same_pose(described, arm);
  return {arm, definition_of(what, arm.robot)};
}

/// Inertias belong to the described links.
canonical::Arm with_own_links(const model::Robot& described) {
  return {canonical::for_dynamics(described), std::vector<exact::Angle>(described.joints.size())};
}

}  // namespace

Subject::Subject(const model::Robot& described, What wanted)
    : what(wanted),
      plain(
          view_of(what, described,
                  what == What::dynamics ? with_own_links(described) : canonical::for_kinematics(described))),
      along_normals(what == What::forward ? view_of(what, described, canonical::along_normals(described))
                                          : plain) {}

Measured measure(const Subject& subject, const Formulation& formulation, Level level) {
  const auto& [arm, definition] = subject.of(formulation);
  const dag::IsFree is_free = free_symbols(arm.robot);
  if (formulation.emitted) return counted(passes::fold_constants(formulation.emitted(arm.robot)), is_free);
  const Recorded recorded =
      record(formulation, arm.robot, level == Level::textbook ? Entries::unknown : Entries::known);
  if (level == Level::textbook) {
    certify(with_entries(recorded.function, recorded.kept), definition, formulation.name);
    return textbook(recorded);
  }
  const dag::Function specialised = passes::fold_constants(recorded.function);
  Measured measured = counted(
      level == Level::specialised ? specialised : searched(specialised, subject.what, is_free), is_free);
  if (has_named_constants(recorded.function)) {
    // Exactly, as long as named constants are symbols; what is folded after that in decimals.
    certify(recorded.function, definition, formulation.name);
    certify_same(measured.function, recorded.function, formulation.name);
  } else {
    certify(measured.function, definition, formulation.name);
  }
  return measured;
}

}  // namespace qvgen::compare
