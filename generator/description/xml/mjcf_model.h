// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <memory>

#include "description/xml/mjcf_defaults.h"
#include "description/xml/mjcf_settings.h"

/// The files of an MJCF: what <include> names is put in its place, as MuJoCo does, before anything is read. A
/// file that <attach> takes a part of is a model with settings, classes and meshes of its own.
namespace qvgen::description::xml {

struct MjcfModel {
  Element root;                  ///< without any <include>
  std::filesystem::path folder;  ///< of the model's own file: where names of its files start
  MjcfSettings settings;
  MjcfDefaults defaults;
  std::map<std::string, Element> meshes;                     ///< by name, with what they inherit
  std::map<std::string, std::unique_ptr<MjcfModel>> models;  ///< that can be attached, by name
};

/// More than any robot has, few enough for a message within a second.
inline constexpr std::size_t max_files = 200;

/// Reads the files that a model names. Mistakes are reported at their places in those files.
std::unique_ptr<MjcfModel> load_model(Context& context, const Element& root);

/// The name without folders and extension, which is a mesh's or a model's where it has none.
std::string stem_of(const std::string& file);

}  // namespace qvgen::description::xml
