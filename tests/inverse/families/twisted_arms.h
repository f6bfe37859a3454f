// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

namespace qvgen::test {

/// A row of a table of Denavit and Hartenberg: what slides or turns, a, alpha and d.
struct TableRow {
  const char* type;
  const char* a;
  const char* alpha;
  const char* d;
};

/// Arms whose wrists come before or after twists that are symbols, or are made of twists without exact sines.
inline constexpr std::array<std::array<TableRow, 6>, 7> twisted_tables{{
    // An elbow between skew axes.
    {{{"revolute", "0", "s", "l1"},
      {"revolute", "l2", "0", "0"},
      {"revolute", "1/50", "t", "l3"},
      {"revolute", "0", "90 deg", "l2"},
      {"revolute", "0", "-90 deg", "0"},
      {"revolute", "0", "0", "1/10"}}},
    // No two of the first three axes parallel or meeting: a quartic.
    {{{"revolute", "1/5", "s", "l1"},
      {"revolute", "l2", "u", "1/9"},
      {"revolute", "1/50", "t", "l3"},
      {"revolute", "0", "90 deg", "l2"},
      {"revolute", "0", "-90 deg", "0"},
      {"revolute", "0", "0", "1/10"}}},
    // A wrist with oblique axes.
    {{{"revolute", "0", "s", "l1"},
      {"revolute", "l2", "0", "0"},
      {"revolute", "1/50", "t", "l3"},
      {"revolute", "0", "60 deg", "l2"},
      {"revolute", "0", "-45 deg", "0"},
      {"revolute", "0", "u", "1/10"}}},
    // The wrist first.
    {{{"revolute", "0", "90 deg", "l1"},
      {"revolute", "0", "-90 deg", "0"},
      {"revolute", "0", "s", "l2"},
      {"revolute", "l2", "0", "0"},
      {"revolute", "1/50", "t", "l3"},
      {"revolute", "1/4", "u", "1/10"}}},
    // A slide at a skew angle.
    {{{"revolute", "0", "s", "l1"},
      {"prismatic", "l2", "t", "0"},
      {"revolute", "1/50", "u", "l3"},
      {"revolute", "0", "90 deg", "l2"},
      {"revolute", "0", "-90 deg", "0"},
      {"revolute", "0", "0", "1/10"}}},
    // Numbers, but whose sines are no roots of rational ones.
    {{{"revolute", "0", "s", "l1"},
      {"revolute", "l2", "0", "0"},
      {"revolute", "1/50", "t", "l3"},
      {"revolute", "0", "45 deg", "l2"},
      {"revolute", "0", "-50 deg", "0"},
      {"revolute", "0", "20 deg", "1/10"}}},
    // Parts of symbols, which functions of the generated code have under names of their own.
    {{{"revolute", "0", "s/3", "l1"},
      {"revolute", "l2", "0", "0"},
      {"revolute", "1/50", "t/2 + 0.1", "l3"},
      {"revolute", "0", "90 deg", "l2"},
      {"revolute", "0", "-90 deg", "0"},
      {"revolute", "0", "0", "1/10"}}},
}};

inline std::string twisted_arm(const std::string& name, std::size_t which) {
  std::string text = "name = \"" + name +
                     "\"\ntitle = \"arm with symbolic twists\"\nconvention = \"standard\"\n[defaults]\n" +
                     "s = -1.4\nt = 1.2\nl1 = 0.6\nl2 = 0.43\nl3 = 0.15\n";
  for (const TableRow& row : twisted_tables.at(which))
    if (std::string(row.alpha) == "u") text += "u = 0.7\n";
  for (std::size_t i = 0; i < 6; ++i) {
    const TableRow& row = twisted_tables.at(which)[i];
    const bool slides = std::string(row.type) == "prismatic";
    text += std::string("[[dh]]\ntype = \"") + row.type + "\"\nvariable = \"q" + std::to_string(i + 1) +
            "\"\na = \"" + row.a + "\"\nalpha = \"" + row.alpha + "\"\n" +
            (slides ? "theta = \"" : "d = \"") + row.d + "\"\n";
  }
  return text;
}

}  // namespace qvgen::test
