// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>
#include <qvgen/map/evaluate.h>

namespace qvgen::map {

/// Subject of a map: all that its numbers depend on. Parts of one map agree in it.
struct About {
  std::string robot;
  std::string title;
  std::string program;        ///< a fingerprint of the sources that compute it
  std::string task;           ///< "pose", "position", ...
  std::string given;          ///< the joint whose values are tried; empty without
  bool own_reach = true;      ///< the sphere is as large as the arm's reach: beyond it nothing is reached
  bool limits_known = false;  ///< of a joint
  Plan plan;
};

nlohmann::ordered_json to_json(const About& about);
About about_from_json(const nlohmann::ordered_json& json);

/// Returns the name of the targets at a position: "orientations".
std::string target_name(const About& about);
/// How many there are: "100 orientations", or that only positions are asked for.
std::string targets_text(const About& about);

}  // namespace qvgen::map
