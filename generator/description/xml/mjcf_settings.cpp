// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_settings.h"

#include "description/xml/decimals.h"

namespace qvgen::description::xml {
namespace {

bool is_euler_sequence(const std::string& text) {
  return text.size() == 3 && text.find_first_not_of("xyzXYZ") == std::string::npos;
}

/// Sets a truth value that the element gives.
void read_truth(Context& context, const Element& element, const std::string& key, bool& value) {
  const Attribute* attribute = element.attribute(key);
  if (attribute == nullptr) return;
  value = attribute->value == "true";
  if (!value && attribute->value != "false")
    context.error(attribute->place, key + "=\"" + attribute->value + "\" is neither true nor false",
                  "write true or false");
}

void read_number(Context& context, const Element& element, const std::string& key, cln::cl_RA& value) {
  value = read_decimal(context, element, key, value).value;
}

void read_angles(Context& context, const Element& compiler, MjcfSettings& settings) {
  if (const Attribute* angle = compiler.attribute("angle")) {
    settings.degrees = angle->value != "radian";
    if (angle->value != "radian" && angle->value != "degree")
      context.error(angle->place, "unknown angle '" + angle->value + "'", "write degree or radian");
  }
  if (const Attribute* sequence = compiler.attribute("eulerseq")) {
    if (is_euler_sequence(sequence->value))
      settings.euler_sequence = sequence->value;
    else
      context.error(sequence->place, "'" + sequence->value + "' is no sequence of Euler angles",
                    "write three letters, e.g. xyz");
  }
  const Attribute* coordinate = compiler.attribute("coordinate");
  if (coordinate != nullptr && coordinate->value != "local")
    context.error(coordinate->place, "coordinate=\"" + coordinate->value + "\" is not read",
                  "load and save the model with MuJoCo 2.3.3 or older, which writes local coordinates");
}

void read_source_of_inertia(Context& context, const Element& compiler, MjcfInertiaSettings& settings) {
  const Attribute* from = compiler.attribute("inertiafromgeom");
  if (from == nullptr) return;
  settings.from_geoms = from->value == "true"    ? MjcfInertiaSettings::always
                        : from->value == "false" ? MjcfInertiaSettings::never
                                                 : MjcfInertiaSettings::where_none_is_given;
  if (settings.from_geoms == MjcfInertiaSettings::where_none_is_given && from->value != "auto")
    context.error(from->place, "unknown inertiafromgeom '" + from->value + "'", "write auto, true or false");
}

void read_inertia(Context& context, const Element& compiler, MjcfInertiaSettings& settings) {
  read_source_of_inertia(context, compiler, settings);
  if (const auto groups = read_decimals(context, compiler, "inertiagrouprange", 2)) {
    settings.first_group = (*groups)[0].value;
    settings.last_group = (*groups)[1].value;
  }
  read_number(context, compiler, "boundmass", settings.least_mass);
  read_number(context, compiler, "boundinertia", settings.least_moment);
  read_number(context, compiler, "settotalmass", settings.total_mass);
  read_truth(context, compiler, "balanceinertia", settings.balanced);
  read_truth(context, compiler, "exactmeshinertia", settings.exact_meshes);
}

}  // namespace

MjcfSettings read_settings(Context& context, const Element& root) {
  MjcfSettings settings;
  const Attribute* asset_folder = nullptr;
  const Attribute* mesh_folder = nullptr;
  for (const Element& compiler : root.children) {
    if (compiler.name != "compiler") continue;
    read_angles(context, compiler, settings);
    read_inertia(context, compiler, settings.inertia);
    read_truth(context, compiler, "autolimits", settings.automatic_limits);
    read_truth(context, compiler, "strippath", settings.strip_paths);
    if (const Attribute* folder = compiler.attribute("assetdir")) asset_folder = folder;
    if (const Attribute* folder = compiler.attribute("meshdir")) mesh_folder = folder;
  }
  const Attribute* folder = mesh_folder == nullptr ? asset_folder : mesh_folder;
  if (folder != nullptr) settings.mesh_folder = folder->value;
  return settings;
}

}  // namespace qvgen::description::xml
