// SPDX-License-Identifier: MIT
// random_arm SEED FILE: the description of a random arm with inertias.
#include <cstdlib>
#include <fstream>

#include "random_description.h"

int main(int, char** arguments) {
  const auto seed = static_cast<std::uint32_t>(std::strtoul(arguments[1], nullptr, 10));
  std::ofstream file(arguments[2]);
  file << qvgen::test::random_description_with_inertia(seed);
  return file.good() ? 0 : 1;
}
