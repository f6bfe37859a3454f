// SPDX-License-Identifier: MIT
#pragma once

#include <cln/rational.h>

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// How an MJCF's bodies get their inertia.
struct MjcfInertiaSettings {
  enum FromGeoms { never, where_none_is_given, always };
  FromGeoms from_geoms = where_none_is_given;
  cln::cl_RA first_group = 0, last_group = 5;  ///< of the geoms that count
  cln::cl_RA least_mass = 0, least_moment = 0;
  bool balanced = false;      ///< moments that no body can have become equal
  cln::cl_RA total_mass = 0;  ///< of the whole model, by scaling; 0 or less: as it is
  bool exact_meshes = false;  ///< of meshes that do not say how
};

/// <compiler>: how the numbers of an MJCF are meant.
struct MjcfSettings {
  bool degrees = true;
  std::string euler_sequence = "xyz";  ///< lower case: about the turned axes; upper: about the fixed ones
  bool automatic_limits = true;        ///< a range limits although nobody says limited="true"
  std::string mesh_folder;             ///< meshdir, or assetdir
  bool strip_paths = false;            ///< of mesh files only the last part of the name counts
  MjcfInertiaSettings inertia;
};

/// Reads every <compiler> of the file: of each setting the last counts.
MjcfSettings read_settings(Context& context, const Element& root);

}  // namespace qvgen::description::xml
