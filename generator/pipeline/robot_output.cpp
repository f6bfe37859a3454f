// SPDX-License-Identifier: MIT
#include "pipeline/robot_output.h"

#include <cctype>
#include <new>

#include "emit/render.h"
#include "emit/template_values.h"
#include "pipeline/parallel.h"
#include "verify/certificate.h"

namespace qvgen::pipeline {

using nlohmann::ordered_json;

NLOHMANN_JSON_SERIALIZE_ENUM(Missing::Kind, {{Missing::Kind::not_described, "not described"},
                                             {Missing::Kind::on_request, "on request"},
                                             {Missing::Kind::not_derived, "not derived"},
                                             {Missing::Kind::not_in_language, "not in this language"},
                                             {Missing::Kind::not_finished, "not finished"},
                                             {Missing::Kind::refuted, "refuted"}})

namespace {

/// A reason stands in comments of the generated code, whoever gives it: a library's message may have several
/// lines.
std::string one_line(std::string text) {
  for (char& c : text)
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = ' ';
  const std::size_t last = text.find_last_not_of(" \\");
  return text.substr(0, last + 1);
}

}  // namespace

std::string defect_text(const std::string& check) {
  return "a check of the generator itself has failed (" + check +
         "): a defect of this tool, not of the description; please report it with the description";
}

void attempt(const std::string& part, RobotOutput& output,
             const std::function<void(RobotOutput&)>& generate) {
  RobotOutput made{output.robot, {}, ordered_json::object(), {}, output.images};
  const auto leave_out = [&](Missing::Kind kind, const std::string& reason) {
    output.missing.push_back({part, kind, one_line(reason)});
  };
  try {
    generate(made);
    append(output, made);
  } catch (const verify::CertificateError& error) {
    leave_out(Missing::Kind::refuted, defect_text(error.what()));
  } catch (const emit::TemplateError& error) {
    leave_out(Missing::Kind::refuted, defect_text(error.what()));
  } catch (const std::bad_alloc&) {
    leave_out(Missing::Kind::not_finished, "it takes more memory than it may have");
  } catch (const std::exception& error) {
    leave_out(Missing::Kind::not_derived, error.what());
  }
}

void attempt_all(const std::vector<PartOfOutput>& parts, RobotOutput& output) {
  const auto work = [&](std::size_t i) {
    RobotOutput made{output.robot};
    attempt(parts[i].part, made, parts[i].generate);
    return to_text(made);
  };
  const std::vector<Outcome> outcomes = in_processes(parts.size(), work, own_budget());
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (outcomes[i].done)
      append(output, robot_output_from_text(outcomes[i].text));
    else
      output.missing.push_back({parts[i].part, Missing::Kind::not_finished, outcomes[i].text});
}

std::vector<PartOfOutput> without_requested(std::vector<PartOfOutput> parts,
                                            const std::vector<std::string>& on_request, RobotOutput& output) {
  const auto is_left = [&](const PartOfOutput& part) {
    return std::find(on_request.begin(), on_request.end(), part.part) != on_request.end();
  };
  for (const PartOfOutput& part : parts)
    if (is_left(part))
      output.missing.push_back(
          {part.part, Missing::Kind::on_request, "made on request, by --only " + part.part});
  parts.erase(std::remove_if(parts.begin(), parts.end(), is_left), parts.end());
  return parts;
}

std::vector<std::string> lines_of_missing(const RobotOutput& output) {
  std::vector<std::string> lines;
  for (const Missing& missing : output.missing)
    for (const std::string& line : emit::split_lines(missing.part + ": " + missing.reason))
      lines.push_back(line);
  return lines;
}

void append(RobotOutput& output, const RobotOutput& more) {
  output.files.insert(output.files.end(), more.files.begin(), more.files.end());
  output.missing.insert(output.missing.end(), more.missing.begin(), more.missing.end());
  for (const auto& [function, entry] : more.counts.items()) output.counts[function] = entry;
}

ordered_json missing_to_json(const std::vector<Missing>& missing) {
  ordered_json list = ordered_json::array();
  for (const Missing& part : missing)
    list.push_back({{"part", part.part}, {"kind", part.kind}, {"reason", part.reason}});
  return list;
}

std::vector<Missing> missing_from_json(const ordered_json& json) {
  std::vector<Missing> missing;
  for (const auto& part : json)
    missing.push_back({part.at("part"), part.at("kind").get<Missing::Kind>(), part.at("reason")});
  return missing;
}

std::vector<std::string> functions_in(const ordered_json& entry) {
  std::vector<std::string> names;
  const auto is_counted = [](const std::string& name) { return name != "missing" && name != "targets"; };
  for (const auto& [name, value] : entry.items()) {
    if (is_counted(name)) names.push_back(name);
    if (name != "targets") continue;
    for (const auto& [function, targets] : value.items())
      if (!entry.contains(function)) names.push_back(function);
  }
  return names;
}

std::string to_text(const RobotOutput& output) {
  ordered_json files = ordered_json::array();
  for (const OutputFile& file : output.files)
    files.push_back({{"path", file.path}, {"content", file.content}});
  return ordered_json{{"robot", output.robot},
                      {"files", files},
                      {"counts", output.counts},
                      {"missing", missing_to_json(output.missing)}}
      .dump();
}

RobotOutput robot_output_from_text(const std::string& text) {
  const ordered_json json = ordered_json::parse(text);
  RobotOutput output{json.at("robot"), {}, json.at("counts"), missing_from_json(json.at("missing"))};
  for (const auto& file : json.at("files")) output.files.push_back({file.at("path"), file.at("content")});
  return output;
}

}  // namespace qvgen::pipeline
