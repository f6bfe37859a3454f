// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "arm.h"

// write_arms FOLDER [DIGITS]: every arm as NAME.urdf and NAME.xml; angles with so many digits behind the
// point.
int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: write_arms FOLDER [DIGITS]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const int digits = argc > 2 ? std::atoi(argv[2]) : 0;
  std::filesystem::create_directories(folder);
  for (const arms::Arm& arm : arms::read_table(QVGEN_SOURCE_DIR "/tests/interop/arms.txt")) {
    std::ofstream(folder / (arm.name + ".urdf")) << arms::urdf(arm, digits);
    std::ofstream(folder / (arm.name + ".xml")) << arms::mjcf(arm, digits);
  }
}
