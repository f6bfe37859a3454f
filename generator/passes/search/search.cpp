// SPDX-License-Identifier: MIT
#include "passes/search/search.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "passes/search/anneal.h"
#include "passes/search/classes.h"
#include "passes/search/extract.h"
#include "passes/search/load.h"
#include "passes/search/network.h"
#include "passes/search/random.h"
#include "passes/search/saturate.h"

namespace qvgen::passes {
namespace {

using namespace search_detail;
using Outputs = std::vector<std::pair<std::string, Ref>>;

void check(const dag::Function& form, const Outputs& wanted, const std::map<std::string, Ref>& found) {
  std::size_t results = 0;
  for (const dag::Output& output : form.outputs) results += output.name.front() == suggestion ? 0U : 1U;
  if (results != wanted.size()) throw std::invalid_argument("forms with different numbers of outputs");
  for (const auto& [name, ref] : wanted) {
    const auto place = found.find(name);
    if (place == found.end()) throw std::invalid_argument("a form lacks the output " + name);
    if (place->second != ref) throw std::invalid_argument("two forms disagree on the value of " + name);
  }
}

class Search {
 public:
  Search(const std::vector<dag::Function>& forms, const CostModel& cost, const SearchOptions& options)
      : forms_(forms), cost_(cost), options_(options), fingerprint_(options.seed) {
    load();
    enrich();
  }

  dag::Function run() {
    std::vector<Ref> targets;
    for (const auto& output : outputs_) targets.push_back(output.second);
    const Network network = make_network(classes_, angles_, targets, cost_);
    return extract(classes_, angles_, network, best(network), outputs_);
  }

 private:
  void load() {
    Loader loader(classes_, fingerprint_, angles_, options_.is_free_symbol);
    for (const dag::Function& form : forms_) {
      const auto found = loader.load(form);
      if (&form == &forms_.front())
        for (const dag::Output& output : form.outputs)
          if (output.name.front() != suggestion) outputs_.emplace_back(output.name, found.at(output.name));
      check(form, outputs_, found);
    }
  }

  void enrich() {
    relate_angles(classes_, angles_, fingerprint_);
    share_reciprocals(classes_);
    classes_.propagate_free();
    factor(classes_, options_.limit);
    classes_.propagate_free();
    gather_free_factors(classes_, options_.limit);
    classes_.propagate_free();
    if (options_.closure) close(classes_);
    classes_.propagate_free();
  }

  /// The form's own choices: its classes as read alone, looked up among all. Everything else keeps its first
  /// node, made when its operands existed and the class did not, so the whole is acyclic.
  Selection selection_of(const dag::Function& form, const Network& network) {
    Classes own;
    AngleTable angles;
    Loader(own, fingerprint_, angles, options_.is_free_symbol).load(form);
    Selection selection(classes_.size(), 0);
    for (std::uint32_t id = 2; id < own.size(); ++id) {
      const Ref here = *classes_.find(own[id].value);
      const EClass& entry = classes_[here.id];
      if (entry.free || own[id].leaf || entry.nodes.empty()) continue;
      selection[here.id] = choice_index(network, here.id, own, own[id].nodes.front());
    }
    return selection;
  }

  std::uint32_t choice_index(const Network& network, std::uint32_t id, const Classes& own,
                             const ENode& wanted) {
    const std::uint32_t a = classes_.find(own.value(wanted.a))->id;
    const std::uint32_t b = classes_.find(own.value(wanted.b))->id;
    for (std::uint32_t i = 0; i < network.choice_count(id); ++i) {
      const Choice& choice = network.choices[network.first[id] + i];
      if (choice.node < 0) continue;
      const ENode& d = classes_[id].nodes[static_cast<std::size_t>(choice.node)];
      const bool same = (d.a.id == a && d.b.id == b) || (d.a.id == b && d.b.id == a);
      if (same && d.op == wanted.op) return i;
    }
    throw std::logic_error("a form's own node is missing");
  }

  Selection best(const Network& network) {
    Selection best;
    std::int64_t lowest = -1;
    const auto consider = [&](Selection selection) {
      const std::int64_t cost = cost_of(network, selection);
      if (lowest >= 0 && cost >= lowest) return;
      lowest = cost;
      best = std::move(selection);
    };
    for (const dag::Function& form : forms_) consider(selection_of(form, network));
    const Selection start = best;
    const std::int64_t steps =
        std::min<std::int64_t>(options_.iterations / options_.restarts, sufficient_steps(network, start));
    for (int i = 0; i < options_.restarts; ++i) {
      const std::uint64_t seed = mix(options_.seed + static_cast<std::uint64_t>(i));
      consider(anneal(network, start, {seed, steps}));
    }
    return best;
  }

  const std::vector<dag::Function>& forms_;
  const CostModel& cost_;
  const SearchOptions& options_;
  Fingerprint fingerprint_;
  Classes classes_;
  AngleTable angles_;
  Outputs outputs_;
};

}  // namespace

dag::Function search(const std::vector<dag::Function>& forms, const CostModel& cost,
                     const SearchOptions& options) {
  if (forms.empty()) throw std::invalid_argument("a search needs at least one form");
  return Search(forms, cost, options).run();
}

}  // namespace qvgen::passes
