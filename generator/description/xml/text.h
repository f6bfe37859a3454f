// SPDX-License-Identifier: MIT
// The text of an XML file as Expat takes it: files of makers and editors have marks and declarations where
// the rules of XML have none, and other readers take them.
#pragma once

#include <string>
#include <string_view>

#include "description/context.h"

namespace qvgen::description::xml {

struct Text {
  std::string utf8;      ///< no byte has another place than in the file, unless that is UTF-16
  std::string encoding;  ///< that Expat is told; empty: the file says it, or UTF-8
};

/// Returns the text with what stands before the root element made right, and warns of it: a declaration
/// behind a comment or blanks is left out, UTF-16 is converted, a byte-order mark is no text.
/// Places are in the context's file of that number.
Text readable(Context& context, std::string_view bytes, int file);

/// True if a file in UTF-16 begins with an element.
bool is_utf16_xml(std::string_view file);

}  // namespace qvgen::description::xml
