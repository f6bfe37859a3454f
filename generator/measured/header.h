// SPDX-License-Identifier: MIT
// The header of a measured table: which column holds what, and in which unit. The caller says what it wants;
// a column that nobody wants, one that is missing and one that stands there twice are mistakes with a place.
#pragma once

#include <string>
#include <vector>

#include "description/reader.h"
#include "measured/cells.h"
#include "measured/units.h"

namespace qvgen::measured {

/// A column that the caller can use.
struct Wanted {
  std::string name = {};  ///< in the header, and in the table that comes back
  Quantity quantity = Quantity::number;
  bool required = true;                  ///< the file has to have it
  bool may_miss = false;                 ///< rows may have nan or nothing there
  std::vector<std::string> others = {};  ///< names that mean the same in a header: the joint's own variable
};

struct TableOptions {
  /// Units of columns whose header states none; radians and metres without.
  double angle_unit = 1, length_unit = 1;
  std::size_t fewest_rows = 1;       ///< fewer are a mistake
  bool others_are_mistakes = true;   ///< columns that nobody wants; else each is a note
  std::vector<std::string> ignored;  ///< names of columns that are left out without a word
};

/// One column of the header: which of the wanted ones, and the unit of its numbers.
struct HeaderColumn {
  std::size_t wanted = not_wanted;
  Unit unit;
  bool stated = false;  ///< the header states the unit
  static constexpr std::size_t not_wanted = static_cast<std::size_t>(-1);
};

/// Reads the cells of a header. Appends what is wrong with it to `mistakes`, with the line given.
std::vector<HeaderColumn> read_header(const std::vector<std::string_view>& cells, std::string_view line,
                                      const std::vector<Wanted>& wanted, const TableOptions& options,
                                      const description::Diagnostic& place,
                                      std::vector<description::Diagnostic>& mistakes);

/// Returns the mistake at a cell of a line: its column counts characters from 1.
description::Diagnostic mistake_at(const description::Diagnostic& place, std::string_view line,
                                   std::string_view cell, std::string message, std::string hint);

}  // namespace qvgen::measured
