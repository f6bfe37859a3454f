// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_model.h"

#include <algorithm>

#include "description/xml/file_text.h"
#include "description/xml/mjcf_include.h"

namespace qvgen::description::xml {
namespace {

namespace fs = std::filesystem;

class Loader {
 public:
  explicit Loader(Context& context) : context_(&context) {}

  std::unique_ptr<MjcfModel> load(Element root, const fs::path& file) {
    auto model = std::make_unique<MjcfModel>();
    open_.push_back(plain_path(file));
    model->folder = file.parent_path();
    follow_includes(*context_, root, file, read_);
    model->root = std::move(root);
    model->settings = read_settings(*context_, model->root);
    model->defaults = MjcfDefaults(*context_, model->root);
    for (const Element& section : model->root.children)
      if (section.name == "asset") read_assets(section, *model);
    open_.pop_back();
    return model;
  }

 private:
  void read_assets(const Element& section, MjcfModel& model) {
    for (const Element& asset : section.children) {
      if (asset.name == "mesh") add_mesh(asset, model);
      if (asset.name == "model") add_model(asset, model);
    }
  }

  void add_mesh(const Element& asset, MjcfModel& model) {
    const Attribute* name = asset.attribute("name");
    const Attribute* file = asset.attribute("file");
    const std::string key = name != nullptr ? name->value : file != nullptr ? stem_of(file->value) : "";
    if (!key.empty()) model.meshes.emplace(key, model.defaults.completed(*context_, asset, ""));
  }

  void add_model(const Element& asset, MjcfModel& model) {
    const Attribute* file = asset.attribute("file");
    if (file == nullptr) return context_->error(asset.place, "<model> without 'file'", "add file=\"...\"");
    const fs::path path = model.folder / file->value;
    if (std::find(open_.begin(), open_.end(), plain_path(path)) != open_.end())
      return context_->error(file->place, "'" + file->value + "' holds itself, through its models",
                             "attach a file that does not lead back to this one");
    auto root = read_named_file(*context_, path, *file, read_);
    if (!root) return;
    const Attribute* name = asset.attribute("name");
    const Attribute* own = root->attribute("model");
    const std::string key = name != nullptr  ? name->value
                            : own != nullptr ? own->value
                                             : "MuJoCo Model";  // what MuJoCo calls it
    model.models[key] = load(std::move(*root), path);
  }

  Context* context_;
  std::vector<fs::path> open_;  ///< models that are being read, the outermost first
  FilesRead read_;
};

}  // namespace

std::string stem_of(const std::string& file) { return fs::path(file).stem().string(); }

std::unique_ptr<MjcfModel> load_model(Context& context, const Element& root) {
  return Loader(context).load(root, context.source.file());
}

}  // namespace qvgen::description::xml
