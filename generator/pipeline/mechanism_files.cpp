// SPDX-License-Identifier: MIT
#include "pipeline/mechanism_files.h"

#include <algorithm>
#include <iterator>

#include "pipeline/assembly.h"
#include "pipeline/limbs.h"

namespace qvgen::pipeline {

std::vector<RobotOutput> mechanism_in_c(const model::Mechanism& mechanism, const Parts& parts,
                                        const Budget& budget) {
  std::vector<model::Robot> robots = limbs_of(mechanism);
  robots.insert(robots.begin(), mechanism.robot);
  std::vector<RobotOutput> outputs = generate(robots, parts, budget, {}, Language::c);
  PartsOfLoops called{{outputs.begin() + 1, outputs.end()}, {}};
  for (const ChainRobot& chain : chain_robots(mechanism))
    called.chains.push_back(generate({chain.robot}, {chain.part}, budget, {}, Language::c).front());
  add_assembly(mechanism, called, Language::c, false, outputs.front());
  std::copy(called.chains.begin(), called.chains.end(), std::back_inserter(outputs));
  return outputs;
}

}  // namespace qvgen::pipeline
