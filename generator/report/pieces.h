// SPDX-License-Identifier: MIT
// Pieces of pages on measured robots: paragraphs, lists, figures with their words, tables that scroll.
#pragma once

#include <string>
#include <vector>

#include "report/html.h"

namespace qvgen::report {

inline std::string paragraph(const std::string& text) { return "<p>" + escaped(text) + "</p>\n"; }

inline std::string bullets(const std::vector<std::string>& items) {
  std::string body;
  for (const std::string& each : items) body += "<li>" + escaped(each) + "</li>\n";
  return "<ul>\n" + body + "</ul>\n";
}

inline std::string figure(const std::string& svg, const std::string& words) {
  return "<figure>" + svg + "<figcaption>" + escaped(words) + "</figcaption></figure>\n";
}

inline std::string scrolled(const HtmlTable& table) {
  return "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Table\">" + html(table) +
         "</div>\n";
}

}  // namespace qvgen::report
