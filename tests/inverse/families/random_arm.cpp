// SPDX-License-Identifier: MIT
#include "random_arm.h"

#include <array>
#include <vector>

#include "cut_arms.h"
#include "directed_arms.h"
#include "five_arms.h"
#include "heading_arms.h"
#include "inclined_arms.h"
#include "other_zeros.h"
#include "pitched_arms.h"
#include "random_writer.h"
#include "seven_arms.h"
#include "sliding_arms.h"
#include "sliding_machines.h"
#include "turned_arms.h"
#include "twisted_arms.h"
#include "unstructured_arms.h"

namespace qvgen::test {

std::string arm_name(const std::string& family, std::uint32_t seed) {
  const std::string number = std::to_string(seed);
  return family + "_" + std::string(number.size() < 3 ? 3 - number.size() : 0, '0') + number;
}

namespace {

constexpr std::array<const char*, 16> codes{"cc", "cn", "cr", "cs", "nc", "nn", "nr", "ns",
                                            "rc", "rn", "rr", "rs", "sc", "sn", "sr", "ss"};

/// Arms with five joints, or four, of arms with six; every sixteenth turn the codes are a joint shorter.
std::string fewer(const std::string& family, std::uint32_t seed) {
  const std::string name = arm_name(family, seed);
  if (family == "codes")
    return cut_arm(committed(codes[(5 * seed) % codes.size()]), 2 + static_cast<int>((seed + seed / 4) % 4),
                   name);
  if (family == "five" && seed < five_arms.size())
    return "name = \"" + name + "\"\ntitle = \"five joints\"\n" + five_arms[seed];
  const std::string whole = arm_description(seed % 3 == 2 ? "parallel" : "pieper", seed);
  return cut_arm(whole, family == "five" ? 5 : 4, name);
}

/// An arm as it is built, behind the lines that all of its family have, or a random one.
template <class Arms>
std::string built_or_random(const std::string& name, std::uint32_t seed, const Arms& arms,
                            const std::string& head, std::string (RandomWriter::*random)()) {
  if (seed < arms.size()) return "name = \"" + name + "\"\n" + head + text_of({arms[seed]});
  RandomWriter writer(name, seed);
  return (writer.*random)();
}

}  // namespace

std::string arm_description(const std::string& family, std::uint32_t seed) {
  const std::string name = arm_name(family, seed);
  if (family == "five" || family == "four" || family == "codes") return fewer(family, seed);
  if (family == "seven") {
    return seed < seven_arms.size()
               ? "name = \"" + name + "\"\ntitle = \"seven joints\"\n" + seven_arms[seed].text()
               : RandomWriter(name, seed).seven();
  }
  if (family == "unstructured")
    return built_or_random(name, seed, unstructured_arms, "title = \"without structure\"\n",
                           &RandomWriter::unstructured);
  if (family == "pitch")
    return built_or_random(name, seed, pitched_arms,
                           "title = \"with a pitch\"\ntask = \"position_and_pitch\"\n",
                           &RandomWriter::pitched);
  if (family == "inclined")
    return built_or_random(name, seed, inclined_arms,
                           "title = \"inclined\"\ntask = \"position_and_inclination\"\n",
                           &RandomWriter::inclined);
  if (family == "heading")
    return built_or_random(name, seed, heading_arms,
                           "title = \"with a heading\"\ntask = \"position_and_inclination\"\n",
                           &RandomWriter::heading);
  if (family == "directed") {
    const std::string keys = "task = \"position_and_direction\"\n";
    return seed < directed_arms.size() ? "name = \"" + name + "\"\ntitle = \"with a direction\"\n" + keys +
                                             text_of(directed_arms[seed].arm)
                                       : RandomWriter(name, seed).directed(keys);
  }
  if (family == "machines")
    return built_or_random(name, seed, sliding_machines, "title = \"three slides\"\n",
                           &RandomWriter::three_slides);
  if (family == "slides") return sliding_arm(name, seed);
  if (family == "turned") return turned_arm(name, seed);
  if (family == "twists") return twisted_arm(name, seed);
  if (family == "zeros") return "name = \"" + name + "\"\ntitle = \"other zeros\"\n" + other_zeros.at(seed);
  return family == "pieper" ? RandomWriter(name, seed).pieper() : RandomWriter(name, seed).parallel_axes();
}

}  // namespace qvgen::test
