// SPDX-License-Identifier: MIT
#include "counts.h"

#include <stdexcept>

namespace qvgen::test::sources {
namespace {

/// "right", but not "right iff ...", "right; circular" or "right with one sign, ...": they need more to be
/// said.
std::size_t kind_of(const std::string& verdict) {
  if (verdict == "right") return 0;
  if (verdict.rfind("right", 0) == 0) return 1;
  if (verdict.rfind("wrong", 0) == 0) return 2;
  if (verdict == "name") return 3;
  if (verdict.rfind("definition", 0) == 0) return 4;
  if (verdict.rfind("not judged", 0) == 0) return 5;
  throw std::logic_error("a verdict that is not counted: " + verdict);
}

}  // namespace

Counts counts_of(const Part& part) {
  Counts counts{};
  for (const Table& table : part.tables)
    for (const Row& row : table.rows) ++counts.at(kind_of(row.verdict));
  return counts;
}

bool is_erratum(const Row& row) {
  const std::size_t kind = kind_of(row.verdict);
  return kind == 1 || kind == 2;
}

namespace {

Part rows_that(const Part& part, bool errata) {
  Part result{part.title, part.numbers, {}};
  for (const Table& table : part.tables) {
    Table kept{table.title, table.pages, {}};
    for (const Row& row : table.rows)
      if (is_erratum(row) == errata) kept.rows.push_back(row);
    if (!kept.rows.empty()) result.tables.push_back(std::move(kept));
  }
  return result;
}

}  // namespace

Part errata_of(const Part& part) { return rows_that(part, true); }

Part rest_of(const Part& part) { return rows_that(part, false); }

int errata_in(const std::vector<Part>& parts) {
  int rows = 0;
  for (const Part& part : parts) rows += rows_of(errata_of(part));
  return rows;
}

int rows_of(const Part& part) {
  int rows = 0;
  for (const Table& table : part.tables) rows += static_cast<int>(table.rows.size());
  return rows;
}

std::string introduction() {
  return "What the sources print, equation by equation, and what it is worth. Written from the "
         "transcriptions and "
         "judged by computation; a test compares. An equation is judged by itself, all that it names having "
         "its "
         "true value: those of links, poses and motions at twenty random configurations of arms of random "
         "lengths, "
         "those that solve for a joint at every solution of a hundred random poses.";
}

std::string about_errata(const std::vector<Part>& parts) {
  return std::to_string(errata_in(parts)) +
         " rows, by document and page: those that are wrong, and those that hold for some solutions only. A "
         "reader who "
         "corrects these has the sources as they should be. Pages of the thesis are those of its table of "
         "contents; the scan of the lecture keeps few numbers of its slides, so that its lines are counted "
         "within each example.";
}

std::string about_rest() {
  return "Rows that are right as printed, names, definitions, and rows that are not judged, with the reason.";
}

std::string heading_of(const Table& table) {
  return table.pages.empty() ? table.title : table.pages + ": " + table.title;
}

std::string legend() {
  return "c1, s1 are cosine and sine of theta1, hc1, hs1 of its half, hc(4+6) of half a sum; w, a, b, c the "
         "pose's "
         "quaternion, px, py, pz its position, phi its angle about z, r11, ... its rotation matrix; N41 to "
         "N44 the "
         "quaternion left for the wrist, w11, ... its matrix; [s, v] a quaternion, (q, p) a pair, x and . "
         "the "
         "products of vectors; a dot is a prime: theta1'; a prime is an asterisk: u3*; pm is a printed sign. "
         "Names that would clash have "
         "an "
         "underscore: a_. \"Right iff\": a branch is lost or a sign left out, and this is when it is right. "
         "\"Right "
         "with one sign, which it does not tell\": its other sign gives a value that no solution with the "
         "same "
         "earlier joints has. \"Circular\": it needs a joint that is itself computed from this one. Slips: "
         "sign, "
         "index, prime, name, half angle, function (sine for cosine), axis, value, bracket, form (a term or "
         "what stands around it). Evidence: \"gives 0.593 for 0.618\" is the printed value and the true one "
         "at the first configuration, \"off by\" the largest difference of all. A name that the arm does not "
         "have is a slip wherever it stands, a joint's own name included.";
}

}  // namespace qvgen::test::sources
