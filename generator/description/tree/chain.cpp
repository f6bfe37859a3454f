// SPDX-License-Identifier: MIT
#include <algorithm>

#include "description/tree/tree_reader.h"

namespace qvgen::description::tree {

void read_chain(Context& context, const std::vector<Node>& nodes, Ends ends, const ReadSegment& read,
                model::Robot& robot) {
  const auto path = path_between(nodes, ends).value();
  const auto moving =
      std::count_if(path.begin(), path.end(), [&](std::size_t node) { return nodes[node].moves; });
  const std::string names = "from " + nodes[ends.base].name + " to " + nodes[ends.tip].name;
  if (moving == 0) {
    context.error(nodes[ends.tip].place, "no joint " + names + " moves", "choose another --base or --tip");
  } else if (moving > static_cast<long>(max_joints)) {
    context.error(nodes[ends.tip].place, std::to_string(moving) + " joints " + names + " move",
                  "a robot has at most " + std::to_string(max_joints) + " joints");
  } else if (path.size() > most_links) {
    context.error(nodes[ends.tip].place, std::to_string(path.size()) + " links " + names,
                  "an arm has at most " + std::to_string(most_links));
  } else {
    TreeReader reader(context, nodes, read, ends.tip);
    reader.read(path, robot);
    reader.tie(robot);
    robot.tool = reader.place_of(ends.tip).placement;
  }
}

}  // namespace qvgen::description::tree
