// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "emit/javascript/writer.h"

/// Documentation and types, as TypeScript and editors read them.
namespace qvgen::emit::javascript {

/// Lines of a comment of JSDoc.
Lines documented(const Lines& doc, const std::string& indent, const std::string& robot,
                 bool returns_last = false);

/// Type of a result or of a field.
std::string result_text(const blocks::Unit& unit, const blocks::TypeRef& type);

/// Parameters of a function with their types: "q: ArrayLike<number>, g?: Geometry".
std::string parameters_text(const Context& context, const blocks::Function& function);

}  // namespace qvgen::emit::javascript
