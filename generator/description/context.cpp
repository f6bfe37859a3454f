// SPDX-License-Identifier: MIT
#include "description/context.h"

#include <utility>

namespace qvgen::description {

const std::string& Context::file_of(Place place) const {
  return place.file == 0 ? source.file() : files.at(static_cast<std::size_t>(place.file) - 1);
}

Diagnostic Context::diagnostic(Place place, std::string message, std::string hint) const {
  return {file_of(place), place.line, place.column, Diagnostic::error, std::move(message), std::move(hint)};
}

void Context::error(Place place, std::string message, std::string hint) {
  has_error = true;
  diagnostics.push_back(diagnostic(place, std::move(message), std::move(hint)));
}

void Context::warning(Place place, std::string message, std::string hint) {
  Diagnostic entry = diagnostic(place, std::move(message), std::move(hint));
  if (!options.strict) entry.severity = Diagnostic::warning;
  diagnostics.push_back(std::move(entry));
}

void Context::note(Place place, std::string message, std::string hint) {
  Diagnostic entry = diagnostic(place, std::move(message), std::move(hint));
  entry.severity = Diagnostic::note;
  diagnostics.push_back(std::move(entry));
}

}  // namespace qvgen::description
