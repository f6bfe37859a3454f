// SPDX-License-Identifier: MIT
#include "description/context.h"

#include <utility>

namespace qvgen::description {

Diagnostic Context::diagnostic(Place place, std::string message, std::string hint) const {
  return {source.file(), place.line, place.column, Diagnostic::error, std::move(message), std::move(hint)};
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
