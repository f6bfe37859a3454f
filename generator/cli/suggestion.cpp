// SPDX-License-Identifier: MIT
#include "cli/suggestion.h"

#include <algorithm>

#include "description/names.h"

namespace qvgen::cli {

std::string with_suggestion(const std::string& message, const std::string& name,
                            const std::vector<std::string>& known) {
  const std::string near = description::nearest(name, known);
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  return message + (near.empty() ? "; there are " + list : "; did you mean '" + near + "'?");
}

void check_names(const std::string& message, const std::vector<std::string>& names,
                 const std::vector<std::string>& known) {
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw UsageError(with_suggestion(message + " '" + name + "'", name, known));
}

}  // namespace qvgen::cli
