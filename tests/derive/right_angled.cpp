// SPDX-License-Identifier: MIT
#include "right_angled.h"

#include <sstream>
#include <utility>
#include <vector>

#include "reference/chain.h"
#include "reference/linear_algebra.h"
#include "reference/load.h"

namespace qvgen::test {

RightAngled::RightAngled(std::uint32_t seed, int joints, int slides) : random_(seed) {
  std::vector<int> slide(static_cast<std::size_t>(joints), 0);
  for (int i = 0; i < slides; ++i) slide[static_cast<std::size_t>(i)] = 1;
  for (int i = joints; i > 1; --i)
    std::swap(slide[static_cast<std::size_t>(i) - 1], slide[static_cast<std::size_t>(below(i))]);
  std::ostringstream text;
  text << "name = \"right_angled\"\ntitle = \"an arm at right angles\"\n";
  for (int i = 0; i < joints; ++i) {
    text << "[[joint]]\ntype = \"" << (slide[static_cast<std::size_t>(i)] == 1 ? "prismatic" : "revolute")
         << "\"\naxis = \""
         << "+-"[below(2)] << "xyz"[below(3)] << "\"\nvariable = \"q" << i + 1 << "\"\nlink = [";
    for (int k = 0; k < 3; ++k)
      text << (k > 0 ? ", " : "") << (below(10) < 7 ? 0 : 0.001 * (below(800) - 400));
    text << "]\n";
  }
  text_ = text.str();
}

bool RightAngled::moves_in_all_ways() {
  const reference::Chain chain = reference::load_text(text_);
  for (int place = 0; place < 3; ++place) {
    reference::VectorXd q(chain.size());
    for (double& each : q) each = std::uniform_real_distribution<double>(-1, 1)(random_);
    if (reference::smallest_singular_value(reference::jacobian(chain, q)) > 1e-4) return true;
  }
  return false;
}

}  // namespace qvgen::test
