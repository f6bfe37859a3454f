// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_fragment.h"

#include <algorithm>
#include <set>

#include "description/xml/file_text.h"
#include "description/xml/mjcf_model.h"

namespace qvgen::description::xml {
namespace {

namespace fs = std::filesystem;

// A folder with more entries is no robot's folder.
constexpr std::size_t most_entries = 10'000;
constexpr std::size_t most_bytes = 50'000'000;

struct Neighbour {
  fs::path path;
  bool is_model = false;
  std::set<fs::path> includes;
};

void add_includes(const Element& element, const std::vector<fs::path>& folders, Neighbour& neighbour) {
  const Attribute* file = element.name == "include" ? element.attribute("file") : nullptr;
  if (file != nullptr)
    for (const fs::path& folder : folders) neighbour.includes.insert(plain_path(folder / file->value));
  for (const Element& child : element.children) add_includes(child, folders, neighbour);
}

/// Returns the entries of a folder, in the order of names; none if it cannot be read.
std::set<fs::path> entries_of(const fs::path& folder) {
  std::set<fs::path> result;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (result.size() < most_entries) result.insert(entry->path());
  return result;
}

/// XML files in the folder, the one above, and those beside it.
std::vector<fs::path> files_around(const fs::path& folder) {
  std::error_code ignored;
  std::set<fs::path> folders{folder, folder.parent_path()};
  for (const fs::path& entry : entries_of(folder.parent_path()))
    if (fs::is_directory(entry, ignored)) folders.insert(entry);
  std::vector<fs::path> files;
  std::size_t seen = 0;
  for (const fs::path& each : folders)
    for (const fs::path& entry : entries_of(each))
      if (++seen <= most_entries && entry.extension() == ".xml") files.push_back(entry);
  return files;
}

/// Models and fragments with an <include>.
std::vector<Neighbour> neighbours_of(const fs::path& file) {
  std::vector<Neighbour> result;
  const fs::path own = plain_path(file).parent_path();
  std::size_t bytes = 0;
  for (const fs::path& path : files_around(own)) {
    const FileText text = read_text_of(path, max_file_size);
    bytes += text.text.size();
    if (bytes > most_bytes) break;
    if (text.text.find("<include") == std::string::npos) continue;
    Context apart(text.text, path.string(), {});
    const auto root = parse(apart, text.text);
    if (!root) continue;
    Neighbour& neighbour = result.emplace_back();
    neighbour.path = path;
    neighbour.is_model = root->name == "mujoco";
    add_includes(*root, {path.parent_path(), own}, neighbour);
  }
  return result;
}

/// The models that include the file, or a fragment that does; in the order of their names.
std::set<fs::path> models_with(const fs::path& file) {
  const auto neighbours = neighbours_of(file);
  std::set<fs::path> models, known{plain_path(file)};
  std::vector<fs::path> open{plain_path(file)};
  while (!open.empty()) {
    const fs::path wanted = open.back();
    open.pop_back();
    for (const Neighbour& neighbour : neighbours) {
      if (neighbour.includes.count(wanted) == 0) continue;
      if (neighbour.is_model)
        models.insert(neighbour.path);
      else if (known.insert(plain_path(neighbour.path)).second)
        open.push_back(plain_path(neighbour.path));
    }
  }
  return models;
}

std::string list(const std::set<fs::path>& models) {
  static constexpr std::size_t shown = 5;
  std::string text;
  std::size_t count = 0;
  for (const fs::path& model : models)
    if (++count <= shown) text += (count == 1 ? "" : ", ") + model.string();
  return count > shown ? text + " and " + std::to_string(count - shown) + " more" : text;
}

bool is_section(const std::string& name) {
  static const std::set<std::string> names{"compiler",   "option",   "size",      "visual",   "statistic",
                                           "default",    "custom",   "extension", "asset",    "contact",
                                           "deformable", "equality", "tendon",    "actuator", "sensor",
                                           "keyframe",   "worldbody"};
  return names.count(name) != 0;
}

bool has(const Element& element, const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& name) { return element.child(name) != nullptr; });
}

void refuse_part(Context& context, const Element& root, const std::string& what,
                 const std::set<fs::path>& models) {
  context.error(
      root.place, what + " is a part of a model, for an <include>",
      models.empty() ? "give the model that includes it" : "give a model that includes it: " + list(models));
}

}  // namespace

bool is_part_of_model(Context& context, const Element& root) {
  if (has(root, {"worldbody", "include"})) return false;
  const auto models = models_with(context.source.file());
  if (!models.empty()) refuse_part(context, root, "a <mujoco> without <worldbody>", models);
  return !models.empty();
}

std::optional<Element> model_of_fragment(Context& context, const Element& root) {
  const auto models = models_with(context.source.file());
  const bool is_body = has(root, {"joint", "freejoint", "inertial"});
  if (!models.empty() || (!is_body && !has(root, {"body", "frame", "worldbody", "replicate"}))) {
    refuse_part(context, root, "<mujocoinclude>", models);
    return std::nullopt;
  }
  context.note(root.place, "<mujocoinclude> is read as a model of its own: no file near by includes it",
               "without <compiler> its angles are in degrees");
  Element model{"mujoco", root.place, root.attributes, {}};
  Element world{"worldbody", root.place, {}, {}};
  Element body{"body", root.place, {{"name", stem_of(context.source.file()), root.place}}, {}};
  for (const Element& child : root.children)
    (is_section(child.name) ? model : is_body ? body : world).children.push_back(child);
  if (is_body) world.children.push_back(std::move(body));
  if (!world.children.empty()) model.children.push_back(std::move(world));
  return model;
}

}  // namespace qvgen::description::xml
