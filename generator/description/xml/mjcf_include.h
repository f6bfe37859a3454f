// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// Files that one run has read, for the bounds of all of them together.
struct FilesRead {
  std::size_t files = 0;
  std::size_t elements = 0;
};

/// Reads and parses a file that `by` names; nothing where that has been reported. Mistakes in the file stand
/// at their place there, and a note stands at `by`.
std::optional<Element> read_named_file(Context& context, const std::filesystem::path& path,
                                       const Attribute& by, FilesRead& read);

/// Replaces every <include> by the children of the file's root. As in MuJoCo a name is looked for in the
/// folder of the model first, then beside the including file, and no file comes twice.
void follow_includes(Context& context, Element& root, const std::filesystem::path& file, FilesRead& read);

}  // namespace qvgen::description::xml
