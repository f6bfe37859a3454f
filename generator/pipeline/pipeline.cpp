// SPDX-License-Identifier: MIT
#include "pipeline/pipeline.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include "emit/c/single_precision.h"
#include "emit/render.h"
#include "emit/template_values.h"
#include "model/followers.h"
#include "model/mechanism.h"
#include "pipeline/c_files.h"
#include "pipeline/images.h"
#include "pipeline/products/page.h"
#include "pipeline/products/product.h"
#include "pipeline/translation.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

std::string header_of(const std::string& robot, const std::string& part) {
  return "include/qvgen/robots/" + robot + "/" + part + ".h";
}

bool has_file(const RobotOutput& output, const std::string& path) {
  return std::any_of(output.files.begin(), output.files.end(),
                     [&](const OutputFile& file) { return file.path == path; });
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// True if a part has a header of its own; else it is a function of one.
bool is_header(const std::string& part) {
  const auto& products = all_products();
  return std::any_of(products.begin(), products.end(), [&](const Product& product) {
    return product.part == part || contains(product.headers, part);
  });
}

/// In place of the header of a part that could not be made: the reasons.
void add_headers_of_missing_parts(RobotOutput& output) {
  std::map<std::string, json> reasons;
  for (const Missing& missing : output.missing) {
    if (missing.kind == Missing::Kind::not_described || missing.kind == Missing::Kind::on_request ||
        !is_header(missing.part))
      continue;
    json& lines = reasons.emplace(missing.part, json::array()).first->second;
    for (const json& line : emit::lines_of(emit::split_lines(missing.reason))) lines.push_back(line);
  }
  for (const auto& [part, lines] : reasons)
    output.files.push_back(
        {header_of(output.robot, part),
         emit::render("cpp/missing.h", {{"name", output.robot}, {"part", part}, {"reasons", lines}})});
}

/// Includes the headers that there are, and says what there is not.
OutputFile umbrella_header(const RobotOutput& output) {
  json parts = json::array();
  for (const Product& product : all_products())
    if (has_file(output, header_of(output.robot, product.part))) parts.push_back({{"part", product.part}});
  const json missing = emit::lines_of(lines_of_missing(output));
  return {"include/qvgen/robots/" + output.robot + ".h",
          emit::render("cpp/robot.h", {{"name", output.robot},
                                       {"parts", parts},
                                       {"missing", missing},
                                       {"is_complete", missing.empty()}})};
}

/// Parts of mechanisms with loops, which are made beside the products and call their limbs' functions.
const std::array<const char*, 2> parts_of_loops{"assembly", "c_assembly"};
const std::array<const char*, 2> needs_of_loops{"kinematics", "jacobian"};

bool is_needed_by_loops(const std::string& product, const Parts& parts) {
  return std::find(needs_of_loops.begin(), needs_of_loops.end(), product) != needs_of_loops.end() &&
         std::any_of(parts_of_loops.begin(), parts_of_loops.end(),
                     [&](const char* part) { return contains(parts, part); });
}

/// True if a part that is named needs the product.
bool is_needed(const std::string& product, const Parts& parts) {
  const auto needs_it = [&](const auto& each) {
    return contains(parts, each.part) && contains(each.needs, product);
  };
  const auto& products = all_products();
  const auto& extras = all_extras();
  return is_needed_by_loops(product, parts) || std::any_of(products.begin(), products.end(), needs_it) ||
         std::any_of(extras.begin(), extras.end(), needs_it);
}

/// Every part rests on the model header.
bool is_wanted(const Product& product, const Parts& parts) {
  return (parts.empty() && !product.on_request) || is_needed(product.part, parts) ||
         product.part == all_products().front().part || contains(parts, product.part) ||
         std::any_of(product.headers.begin(), product.headers.end(),
                     [&](const std::string& header) { return contains(parts, header); });
}

/// The robot without requests that have been granted.
model::Robot asked_for(model::Robot robot, const Parts& parts) {
  auto& left = robot.on_request;
  const auto is_named = [&](const std::string& part) { return contains(parts, part); };
  left.erase(std::remove_if(left.begin(), left.end(), is_named), left.end());
  return robot;
}

std::vector<Product> wanted_products(const Parts& parts) {
  std::vector<Product> wanted;
  for (const Product& product : all_products())
    if (is_wanted(product, parts)) wanted.push_back(product);
  return wanted;
}

/// True if a product is of chains alone and the robot is none; its limbs have it then.
bool is_of_limbs(bool of_trees, const model::Robot& robot, const std::string& part, RobotOutput& output) {
  if (of_trees || model::is_chain(robot)) return false;
  const std::string why = robot.has_loops ? "the joints close loops" : "the joints branch";
  output.missing.push_back(
      {part, Missing::Kind::not_described, why + ": each limb has it, as a robot of its own"});
  return true;
}

RobotOutput generate_product(const Original& original, const Product& product, Language language) {
  const model::Robot& robot = original.robot;
  RobotOutput output{robot.name};
  output.images = original.images;
  if (is_of_limbs(product.of_trees, robot, product.part, output)) return output;
  const auto make = comes_from_c(language) ? product.generate_c : product.generate;
  if (const std::string lack = lack_of(row_of(language), product.part);
      is_of_devices(language) && !lack.empty()) {
    output.missing.push_back({product.part, Missing::Kind::not_in_language, lack});
    return output;
  }
  attempt(product.part, output, [&](RobotOutput& made) { make(robot, made); });
  return output;
}

std::vector<Extra> wanted_extras(const Parts& parts) {
  std::vector<Extra> wanted;
  for (const Extra& extra : all_extras())
    if (contains(parts, extra.part)) wanted.push_back(extra);
  return wanted;
}

RobotOutput generate_extra(const model::Robot& robot, const Extra& extra, Language language,
                           const nlohmann::ordered_json& counts) {
  RobotOutput output{robot.name};
  if (is_of_limbs(extra.of_trees, robot, extra.part, output)) return output;
  if (!extra.of_motors && model::has_followers(robot)) {
    output.missing.push_back({extra.part, Missing::Kind::not_derived, "joints follow others, or motors"});
    return output;
  }
  if (extra.in_c != (language == Language::c))
    output.missing.push_back(
        {extra.part, Missing::Kind::not_in_language,
         extra.in_c ? "it is made of C in double: --language c" : "it is written in C++"});
  else
    attempt(extra.part, output, [&](RobotOutput& made) {
      made.counts = counts;
      extra.add(robot, made);
    });
  return output;
}

/// True if a language takes the product from C as any other does.
bool is_shared(const Product& product, Language language) {
  return comes_from_c(language) &&
         (!is_of_devices(language) || lack_of(row_of(language), product.part).empty());
}

/// Makes the products of each robot, not put together yet, but for those that are kept from another language.
std::vector<RobotOutput> made(const std::vector<Original>& robots, const std::vector<Product>& products,
                              const Budget& budget, const std::function<void(const std::string&)>& progress,
                              Language language, KeptProducts& kept) {
  // The last products take longest and begin first, so that no core waits for one of them at the end.
  const auto product_at = [&](std::size_t i) { return products.size() - 1 - i % products.size(); };
  const auto work = [&](std::size_t i) {
    return to_text(generate_product(robots[i / products.size()], products[product_at(i)], language));
  };
  std::vector<std::size_t> open(robots.size(), products.size());
  const auto done = [&](std::size_t i) {
    const std::size_t robot = i / products.size();
    if (--open[robot] == 0 && progress) progress(robots[robot].robot.name);
  };
  const auto key_of = [&](std::size_t i) {
    return std::pair{robots[i / products.size()].robot.name, products[product_at(i)].part};
  };
  std::vector<Outcome> outcomes(robots.size() * products.size());
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const auto known = kept.find(key_of(i));
    if (known == kept.end() || !is_shared(products[product_at(i)], language)) {
      wanted.push_back(i);
      continue;
    }
    outcomes[i] = known->second;
    done(i);
  }
  const std::vector<Outcome> others = in_processes(
      wanted.size(), [&](std::size_t i) { return work(wanted[i]); }, budget,
      [&](std::size_t i) { done(wanted[i]); });
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    outcomes[wanted[i]] = others[i];
    if (is_shared(products[product_at(wanted[i])], language)) kept[key_of(wanted[i])] = others[i];
  }
  std::vector<RobotOutput> outputs;
  for (std::size_t robot = 0; robot < robots.size(); ++robot) {
    RobotOutput output{robots[robot].robot.name};
    for (std::size_t i = 0; i < products.size(); ++i) {
      const Outcome& outcome = outcomes[robot * products.size() + product_at(i)];
      if (outcome.done)
        append(output, robot_output_from_text(outcome.text));
      else
        output.missing.push_back({products[i].part, Missing::Kind::not_finished, outcome.text});
    }
    outputs.push_back(std::move(output));
  }
  return outputs;
}

/// Adds what is made from the products, each extra of each robot in a process of its own as well.
void add_extras(const std::vector<Original>& robots, const std::vector<Extra>& extras, const Budget& budget,
                Language language, std::vector<RobotOutput>& outputs) {
  const auto work = [&](std::size_t i) {
    const std::size_t robot = i / extras.size();
    return to_text(
        generate_extra(robots[robot].robot, extras[i % extras.size()], language, outputs[robot].counts));
  };
  const std::vector<Outcome> outcomes = in_processes(robots.size() * extras.size(), work, budget);
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    RobotOutput& output = outputs[i / extras.size()];
    if (outcomes[i].done)
      append(output, robot_output_from_text(outcomes[i].text));
    else
      output.missing.push_back(
          {extras[i % extras.size()].part, Missing::Kind::not_finished, outcomes[i].text});
  }
}

/// Puts a robot together from its products; without its model header nothing would compile.
RobotOutput whole(RobotOutput output, Language language) {
  const bool has_model = has_part(output.missing, all_products().front().part);
  if (!has_model) output.files.clear();
  if (!output.missing.empty()) output.counts["missing"] = missing_to_json(output.missing);
  if (!has_model) return output;
  if (comes_from_c(language)) output = with_c_files(std::move(output));
  if (is_translated(language)) return translated(std::move(output), language);
  if (comes_from_c(language)) {
    const auto stack = stack_of(output, language == Language::c_in_float ? 4 : 8);
    for (OutputFile& file : output.files)
      file.content = language == Language::c_in_float ? emit::c::in_single_precision(file.content)
                                                      : emit::c::in_double_precision(file.content);
    add_stack_lines(output, stack);
    return output;
  }
  add_headers_of_missing_parts(output);
  output.files.push_back(umbrella_header(output));
  return output;
}

/// Puts all robots together, each in a process of its own: what is rendered here counts as well. A robot that
/// exceeds the budget is lost, and says so.
std::vector<RobotOutput> whole(std::vector<RobotOutput> outputs, const Budget& budget, Language language) {
  const auto work = [&](std::size_t i) { return to_text(whole(outputs[i], language)); };
  const std::vector<Outcome> outcomes = in_processes(outputs.size(), work, budget);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outcomes[i].done) {
      outputs[i] = robot_output_from_text(outcomes[i].text);
      continue;
    }
    outputs[i].missing.push_back(
        {all_products().front().part, Missing::Kind::not_finished, outcomes[i].text});
    outputs[i] = whole(std::move(outputs[i]), language);
  }
  return outputs;
}

}  // namespace

std::string folder_name(const std::string& robot, Language language) {
  return (comes_from_c(language) ? row_of(language).name + "/" : "") + robot;
}

bool is_in(Language language, const std::string& folder_name) {
  const std::size_t slash = folder_name.find('/');
  const std::string folder =
      slash == std::string::npos ? languages().front().name : folder_name.substr(0, slash);
  return folder == row_of(language).name;
}

std::vector<std::string> product_names() {
  std::vector<std::string> names;
  for (const Product& product : all_products()) {
    names.push_back(product.part);
    names.insert(names.end(), product.headers.begin(), product.headers.end());
  }
  for (const Extra& extra : all_extras()) names.push_back(extra.part);
  names.insert(names.end(), parts_of_loops.begin(), parts_of_loops.end());
  return names;
}

std::vector<std::string> extra_names() {
  std::vector<std::string> names;
  for (const Product& product : all_products())
    if (product.on_request) names.push_back(product.part);
  for (const Extra& extra : all_extras()) names.push_back(extra.part);
  return names;
}

std::vector<std::string> part_names() {
  std::vector<std::string> names;
  for (const Product& product : all_products()) {
    names.push_back(product.part);
    names.insert(names.end(), product.headers.begin(), product.headers.end());
    names.insert(names.end(), product.functions.begin(), product.functions.end());
  }
  for (const char* part : {"assembly", "assemble", "assemble_from_outputs"}) names.emplace_back(part);
  for (const Extra& extra : all_extras()) names.push_back(extra.part);
  return names;
}

std::string product_of(const std::string& part) {
  for (const Product& product : all_products())
    if (contains(product.headers, part) || contains(product.functions, part)) return product.part;
  return part;
}

bool has_part(const std::vector<Missing>& missing, const std::string& part) {
  const std::string product = product_of(part);
  return std::none_of(missing.begin(), missing.end(),
                      [&](const Missing& each) { return each.part == part || each.part == product; });
}

std::vector<RobotOutput> generate(const std::vector<model::Robot>& described, const Parts& parts,
                                  const Budget& budget,
                                  const std::function<void(const std::string&)>& progress, Language language,
                                  std::vector<std::string> limb_of, KeptProducts* kept) {
  std::vector<model::Robot> robots;
  for (const model::Robot& robot : described) robots.push_back(asked_for(robot, parts));
  KeptProducts own;
  KeptProducts& products = kept == nullptr ? own : *kept;
  const auto derive = [&](const std::vector<Original>& some) {
    std::vector<RobotOutput> outputs =
        made(some, wanted_products(parts), budget, progress, language, products);
    add_extras(some, wanted_extras(parts), budget, language, outputs);
    return outputs;
  };
  limb_of.resize(robots.size());
  if (comes_from_c(language)) limb_of.assign(robots.size(), "");
  std::vector<RobotOutput> outputs = whole(derived_once(robots, limb_of, derive, progress), budget, language);
  for (std::size_t i = 0; i < robots.size(); ++i) outputs[i].robot = folder_name(robots[i].name, language);
  return outputs;
}

RobotOutput generate_page_functions(const model::Robot& robot, const Budget& budget) {
  KeptProducts kept;
  return whole(made({{robot}}, page_products(), budget, {}, Language::c, kept).front(), Language::c);
}

std::vector<OutputFile> shared_files() {
  return {{"README.md", emit::render("cpp/readme.md", json::object())}};
}

}  // namespace qvgen::pipeline
