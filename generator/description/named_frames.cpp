// SPDX-License-Identifier: MIT
#include "description/named_frames.h"

#include <algorithm>
#include <cctype>

#include "description/characters.h"
#include "description/entries.h"
#include "description/frames.h"
#include "description/names.h"

namespace qvgen::description {
namespace {

/// Beyond this a name is cut off.
constexpr std::size_t longest_frame_name = 48;

/// link1, link2, ... are the frames of the links themselves.
bool is_name_of_link(const std::string& name) {
  return name.size() > 4 && name.substr(0, 4) == "link" &&
         std::all_of(name.begin() + 4, name.end(), is_digit);
}

bool is_taken(const std::string& name, const std::vector<model::Frame>& frames) {
  return std::any_of(frames.begin(), frames.end(),
                     [&](const model::Frame& frame) { return frame.name == name; });
}

/// The frame's name; reported if it cannot be one. `kind` is how messages call it.
std::string read_name(const Table& table, const std::string& kind, const std::vector<model::Frame>& frames) {
  Context& context = table.context();
  if (table.require("name", "name = \"camera\"") == nullptr) return "";
  const std::string name = table.text("name").value_or("");
  const Place place = table.place_of("name");
  const std::string told = "the " + kind + " '" + name + "': ";
  if (const NameProblem problem = check_identifier(name); !problem.message.empty())
    context.error(place, told + problem.message, problem.hint);
  else if (is_name_of_link(name))
    context.error(place, told + "link1, link2, ... are the links' own frames", "give it another name");
  else if (is_taken(name, frames))
    context.error(place, told + "another " + kind + " has this name",
                  "give each " + kind + " a name of its own");
  return name;
}

/// The joint that moves the frame's link: the last one if none is named.
std::size_t read_joint(const Table& table, const std::vector<model::Joint>& joints) {
  if (joints.empty()) return 0;
  if (!table.has("joint")) return joints.size() - 1;
  const std::string name = table.text("joint").value_or("");
  if (const auto whole = table.context().composed.find(name); whole != table.context().composed.end())
    return whole->second;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].variable == name) return i;
    names.push_back(joints[i].variable);
  }
  const std::string near = nearest(name, names);
  table.context().error(table.place_of("joint"), "there is no joint with the variable '" + name + "'",
                        near.empty()
                            ? "name the joint that moves the frame's link; what is fixed to the base "
                              "needs no function"
                            : "did you mean '" + near + "'?");
  return 0;
}

}  // namespace

std::vector<model::Frame> read_frame_tables(const Table& root, const std::string& key,
                                            const model::Robot& robot) {
  std::vector<model::Frame> frames;
  for (const Table& table : root.tables(key)) {
    table.allow_only({"name", "joint", "translation", "rpy", "turns"});
    if (frames.size() == most_frames) {
      root.context().error(table.place(), "more than " + std::to_string(most_frames) + " " + key + "s",
                           "leave out those that no program asks for");
      break;
    }
    model::Frame frame{read_name(table, key, frames), read_joint(table, robot.joints), {}};
    frame.placement.turns = read_turns(table);
    frame.placement.translation = vector_or_zero(table, "translation", {});
    frames.push_back(std::move(frame));
  }
  return frames;
}

void read_named_frames(const Table& root, model::Robot& robot) {
  if (root.has("frame")) robot.frames = read_frame_tables(root, "frame", robot);
}

std::string frame_identifier(const std::string& text, const std::vector<model::Frame>& frames) {
  std::string name;
  for (const char c : text.substr(0, longest_frame_name)) {
    const bool is_word = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (is_word)
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty() || is_digit(name.front())) name = name.empty() ? "frame" : "frame_" + name;
  if (!check_identifier(name).message.empty() || is_name_of_link(name)) name += "_frame";
  if (!is_taken(name, frames)) return name;
  std::size_t number = 2;  // one of the first frames.size() + 1 is free
  while (is_taken(name + "_" + std::to_string(number), frames)) ++number;
  return name + "_" + std::to_string(number);
}

}  // namespace qvgen::description
