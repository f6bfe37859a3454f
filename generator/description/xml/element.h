// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "description/context.h"

namespace qvgen::description::xml {

struct Attribute {
  std::string name;
  std::string value;
  Place place;  ///< of the value's first character
};

struct Element {
  std::string name;
  Place place;  ///< of its '<'
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  std::size_t begin = 0;     ///< byte of its '<' in the text as UTF-8
  std::size_t head_end = 0;  ///< byte behind its start tag
  std::size_t end = 0;       ///< byte behind its end tag

  [[nodiscard]] const Attribute* attribute(std::string_view key) const;
  /// The first child of that name, or none.
  [[nodiscard]] const Element* child(std::string_view key) const;
};

/// Returns an attribute's value, or another text where there is no such attribute.
std::string text_of(const Element& element, std::string_view key, const std::string& otherwise = {});

/// More than any robot description has, few enough for a message within a second.
inline constexpr std::size_t max_elements = 100'000;
inline constexpr std::size_t max_depth = 500;

/// The elements of a file, without its text and comments; what is wrong with it is reported. A document type
/// declaration is refused: it is where entities are defined, those of other files among them.
/// Places are in the context's file of that number.
std::optional<Element> parse(Context& context, std::string_view text, int file = 0);

}  // namespace qvgen::description::xml
