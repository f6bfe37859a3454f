// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include "document.h"
#include "verdict.h"

namespace qvgen::test::sources {

/// All sources judged, once for all tests: it takes most of their time.
inline const std::vector<Part>& judged_parts() {
  static const std::vector<Part> all = parts();
  return all;
}

/// The judgements of a section of the transcriptions, by its title, once for all tests.
inline const std::vector<Judgement>& judgements_of(const Section& section) {
  static std::map<std::string, std::vector<Judgement>> all;
  const auto found = all.find(section.title);
  return found != all.end() ? found->second : all.emplace(section.title, judge(section)).first->second;
}

}  // namespace qvgen::test::sources
