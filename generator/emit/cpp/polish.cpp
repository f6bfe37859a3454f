// SPDX-License-Identifier: MIT
// Newton's steps as the runtime's templates want them.
#include "emit/cpp/printer.h"

namespace qvgen::emit {
namespace {

std::string triple(const std::string& name) { return "{" + name + "_x, " + name + "_y, " + name + "_z}"; }

/// Entries of an array, as `each` writes the i-th.
template <class Each>
std::string array(std::size_t count, const Each& each) {
  std::string entries;
  for (std::size_t i = 0; i < count; ++i) entries += (i == 0 ? "" : ", ") + each(i);
  return "{{" + entries + "}}";
}

}  // namespace

ast::Lines CppPrinter::polish(const ast::Polish& task) const {
  const auto screw = [&](std::size_t i) {
    return std::string("inverse::Screw<Scalar>{") + (task.revolute[i] ? "true" : "false") + ", " +
           triple(task.axes[i]) + ", " + triple(task.points[i]) + "}";
  };
  const auto places = [](const std::vector<std::string>& names) {
    return array(names.size(), [&](std::size_t i) { return "inverse::Triple<Scalar>" + triple(names[i]); });
  };
  const auto texts = [&](const ast::Expressions& values) {
    return array(values.size(), [&](std::size_t i) { return text(values[i]); });
  };
  const std::string joints = std::to_string(task.axes.size());
  const std::string type = "inverse::JointValues<Scalar, " + joints + ">";
  ast::Lines result = {
      type + " values" + texts(task.from) + ";",
      "const " + type + " seed" + texts(task.seed) + ";",
      "const inverse::PointMatching<Scalar, " + joints + ", " + std::to_string(task.start.size()) + "> task{",
      "    " + array(task.axes.size(), screw) + ",",
      "    " + places(task.start) + ",",
      "    " + places(task.goal) + ", " + text(task.size_square) + "};",
      "if (!tracker.settle(label, task, t.boundary, t.preference->seeded ? "
      "&seed : nullptr, values, w.branch)) return false;"};
  for (const std::string& each : lines(task.back)) result.push_back(each);
  result.emplace_back("return true;");
  return result;
}

}  // namespace qvgen::emit
