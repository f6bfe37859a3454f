// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_include.h"

#include "description/xml/file_text.h"
#include "description/xml/mjcf_model.h"

namespace qvgen::description::xml {
namespace {

namespace fs = std::filesystem;

std::string text_of(const Context& context, Place place) {
  return context.file_of(place) + ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
}

std::size_t count(const Element& element) {
  std::size_t sum = 1;
  for (const Element& child : element.children) sum += count(child);
  return sum;
}

class Includes {
 public:
  Includes(Context& context, const fs::path& file, Place place, FilesRead& read)
      : context_(&context), read_(&read), folder_(file.parent_path()) {
    first_[plain_path(file)] = place;
  }

  /// `beside`: the folder of the file in which the element stands.
  void follow(Element& parent, const fs::path& beside, std::size_t depth) {
    std::vector<Element> children;
    for (Element& child : parent.children) {
      if (child.name != "include") {
        if (depth < max_depth)
          follow(child, beside, depth + 1);
        else
          refuse_depth(child.place);
        children.push_back(std::move(child));
      } else if (auto content = included(child, beside, depth)) {
        for (Element& element : *content) children.push_back(std::move(element));
      }
    }
    parent.children = std::move(children);
  }

 private:
  void refuse_depth(Place place) {
    if (!too_deep_)
      context_->error(place, "elements nested more than " + std::to_string(max_depth) + " deep",
                      "close them earlier");
    too_deep_ = true;
  }

  /// The children of the included file's root, without any <include>.
  std::optional<std::vector<Element>> included(const Element& include, const fs::path& beside,
                                               std::size_t depth) {
    const Attribute* name = include.attribute("file");
    if (name == nullptr || name->value.empty()) {
      context_->error(include.place, "<include> without 'file'", "add file=\"...\"");
      return std::nullopt;
    }
    if (!include.children.empty()) {
      context_->error(include.place, "<include> has content", "put it behind it, or into the file");
      return std::nullopt;
    }
    const auto path = find(*name, beside);
    if (!path) return std::nullopt;
    const auto [first, is_new] = first_.emplace(plain_path(*path), name->place);
    if (!is_new) {
      context_->error(
          name->place,
          "'" + name->value + "' is included again, first at " + text_of(*context_, first->second),
          "MuJoCo takes a file once: include it in one place, or attach it as a model");
      return std::nullopt;
    }
    auto root = read_named_file(*context_, *path, *name, *read_);
    if (!root) return std::nullopt;
    follow(*root, path->parent_path(), depth + 1);
    return std::move(root->children);
  }

  std::optional<fs::path> find(const Attribute& name, const fs::path& beside) {
    std::error_code ignored;
    for (const fs::path& folder : {folder_, beside})
      if (fs::exists(folder / name.value, ignored)) return folder / name.value;
    const std::string also = beside == folder_ ? "" : ", nor " + (beside / name.value).string();
    context_->error(
        name.place,
        "the included file '" + name.value + "' is not there: no " + (folder_ / name.value).string() + also,
        "names start in the folder of the model, or of the file that includes");
    return std::nullopt;
  }

  Context* context_;
  FilesRead* read_;
  fs::path folder_;
  std::map<fs::path, Place> first_;  ///< where each file is included
  bool too_deep_ = false;
};

}  // namespace

std::optional<Element> read_named_file(Context& context, const fs::path& path, const Attribute& by,
                                       FilesRead& read) {
  if (++read.files > max_files) {
    context.error(by.place, "more than " + std::to_string(max_files) + " files", "put them together");
    return std::nullopt;
  }
  const FileText file = read_text_of(path, max_file_size);
  if (!file.problem.empty()) {
    context.error(by.place, "cannot read " + path.string() + ": " + file.problem, "name a readable file");
    return std::nullopt;
  }
  context.files.push_back(path.string());
  auto root = parse(context, file.text, static_cast<int>(context.files.size()));
  if (!root) {
    context.note(by.place, "the mistake in " + path.string() + " counts because of this line", "");
    return std::nullopt;
  }
  read.elements += count(*root);
  if (read.elements <= max_elements) return root;
  context.error(by.place,
                "with " + path.string() + " more than " + std::to_string(max_elements) + " elements",
                "give one robot a file");
  return std::nullopt;
}

void follow_includes(Context& context, Element& root, const fs::path& file, FilesRead& read) {
  Includes(context, file, root.place, read).follow(root, file.parent_path(), 0);
}

}  // namespace qvgen::description::xml
