// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "counts.h"

namespace qvgen::test::sources {
namespace {

constexpr const char* head = R"(\documentclass{article}
\usepackage[a4paper,landscape,margin=9mm]{geometry}
\usepackage{amsmath,longtable,array}
\newcolumntype{L}[1]{>{\raggedright\arraybackslash}p{#1}}
\setlength{\parindent}{0pt}
\setlength{\tabcolsep}{3pt}
\setlength{\arraycolsep}{2pt}
\begin{document}
\scriptsize
)";

/// Words, with what LaTeX would take for its own.
std::string words(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '^') {
      result += "\\textasciicircum{}";
      continue;
    }
    if (c == '<' || c == '>') {
      result += c == '<' ? "$<$" : "$>$";
      continue;
    }
    if (std::string("_&%#").find(c) != std::string::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string typed(std::string text) {
  std::string result;
  // A line may end after a product's sign too.
  for (const char c : text) result += c == '*' ? std::string("*\\allowbreak ") : words(std::string(1, c));
  return result.empty() ? "" : "{\\ttfamily " + result + "}";
}

/// In a row's text lines break at sums, and after commas where this allows them.
std::string formula(const Written& written) {
  if (written.latex.empty()) return typed(written.plain);
  std::string math;
  int braces = 0;
  for (const char c : written.latex) {
    braces += c == '{' ? 1 : c == '}' ? -1 : 0;
    math += c;
    if (c == ',' && braces == 0 && math.find("\\begin") == std::string::npos &&
        (math.size() < 2 || math[math.size() - 2] != '\\'))
      math += "\\allowbreak ";
  }
  return "$" + math + "$";
}

bool has_matrix(const Row& row) { return row.printed.latex.find("\\begin") != std::string::npos; }

/// A line of its own across all columns, on the page of the one above.
std::string across(const std::string& text) {
  return "\\multicolumn{6}{L{262mm}}{\\hspace{5mm}" + text + "} \\\\\n";
}

/// Matrices are too wide for a column.
std::string wide_row(const Row& row) {
  const std::string right =
      row.right.plain.empty() ? "" : "\\nopagebreak\n" + across("right: " + formula(row.right));
  return fmt::format("{} & {} & & {} & & {} \\\\ \\nopagebreak\n", words(row.number), formula(row.of),
                     words(row.verdict), words(row.remarks)) +
         across(formula(row.printed)) + right;
}

std::string row(const Row& row) {
  if (has_matrix(row)) return wide_row(row);
  const std::string of = row.of.plain.empty() ? "" : formula(row.of);
  return fmt::format("{} & {} & {} & {} & {} & {} \\\\\n", words(row.number), of, formula(row.printed),
                     words(row.verdict), formula(row.right), words(row.remarks));
}

std::string table(const Table& table) {
  std::string text = fmt::format(
      "\\subsection*{{{}}}\n\\begin{{longtable}}{{L{{13mm}}L{{15mm}}L{{94mm}}L{{22mm}}L{{94mm}}L{{26mm}}}}\n"
      "equation & of & printed & verdict & right & remarks \\\\ \\hline \\endhead\n",
      words(heading_of(table)));
  for (const Row& each : table.rows) text += row(each);
  return text + "\\end{longtable}\n";
}

std::string section(const std::string& before, const Part& part) {
  std::string text = fmt::format("\\section*{{{}}}\n", words(before + part.title));
  for (const Table& each : part.tables) text += table(each);
  return text;
}

std::string overview(const std::vector<Part>& parts) {
  std::string text = "\\begin{tabular}{lrrrrrrrr}\nsource & numbers & judged rows";
  for (const char* name : verdict_names) text += fmt::format(" & {}", name);
  text += " \\\\ \\hline\n";
  for (const Part& part : parts) {
    text += fmt::format("{} & {} & {}", part.title, part.numbers == 0 ? "" : std::to_string(part.numbers),
                        rows_of(part));
    for (const int count : counts_of(part)) text += fmt::format(" & {}", count);
    text += " \\\\\n";
  }
  return text + "\\end{tabular}\n";
}

}  // namespace

std::string latex_document(const std::vector<Part>& parts) {
  std::string text = std::string(head) + "\\section*{Printed equations, judged}\n" + introduction() +
                     "\n\n\\medskip\n" + overview(parts) + "\n\\medskip\n" + words(legend()) +
                     "\n\\section*{Errata}\n" + words(about_errata(parts)) + "\n";
  for (const Part& part : parts)
    if (const Part errata = errata_of(part); !errata.tables.empty()) text += section("Errata, ", errata);
  text += "\\section*{The rest}\n" + words(about_rest()) + "\n";
  for (const Part& part : parts) text += section("The rest, ", rest_of(part));
  return text + "\\end{document}\n";
}

}  // namespace qvgen::test::sources
