// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/dialect.h"

namespace qvgen::emit {
namespace {

std::string joined(const Dialect::Arguments& arguments) {
  std::string text;
  for (const std::string& each : arguments)
    if (!each.empty()) text += (text.empty() ? "" : ", ") + each;
  return text;
}

std::string triple(const std::string& name) { return "{" + name + "_x, " + name + "_y, " + name + "_z}"; }

std::string array(const Dialect::Arguments& entries) { return "{{" + joined(entries) + "}}"; }

Dialect::Arguments screws(const PolishTask& task) {
  Dialect::Arguments list;
  for (std::size_t i = 0; i < task.axes.size(); ++i)
    list.push_back(std::string("inverse::Screw<Scalar>{") + (task.revolute[i] ? "true" : "false") + ", " +
                   triple(task.axes[i]) + ", " + triple(task.points[i]) + "}");
  return list;
}

Dialect::Arguments places(const Dialect::Arguments& names) {
  Dialect::Arguments list;
  for (const std::string& name : names) list.push_back("inverse::Triple<Scalar>" + triple(name));
  return list;
}

class Cpp : public Dialect {
 public:
  Spelling spelling() const override {
    Spelling result = cpp_spelling();
    // The functions of the inverse kinematics begin with `using std::sqrt;`.
    result.call = [other = result.call](const std::string& function, const std::string& value) {
      return function == "sqrt" ? function + "(" + value + ")" : other(function, value);
    };
    return result;
  }
  std::string scalar(const std::string& value) const override { return "Scalar(" + value + ")"; }
  std::string member(const std::string& of, const std::string& name) const override {
    return of + "." + name;
  }
  std::string reference(const std::string& place) const override { return place; }
  std::string rotor(const std::string& cosine, const std::string& sine) const override {
    return "inverse::Rotor<Scalar>{" + cosine + ", " + sine + "}";
  }
  std::string product(const std::string& a, const std::string& b) const override { return a + " * " + b; }
  std::string scaled(const std::string& factor, const std::string& rotor) const override {
    return factor + " * " + rotor;
  }
  std::string inverse(const std::string& rotor) const override { return "inverse::inverse(" + rotor + ")"; }
  std::string type(const std::string& name) const override { return "inverse::" + name + "<Scalar>"; }
  std::string braces(const std::string& /*type*/, const Arguments& members) const override {
    return "{" + joined(members) + "}";
  }
  std::string pi() const override { return "inverse::pi<Scalar>()"; }
  std::string function(const std::string& name) const override { return name; }
  std::string block(const std::string& name, const Arguments& arguments) const override {
    return "inverse::" + name + "<Scalar>(" + joined(arguments) + ")";
  }
  std::string direction_block(const std::string& name, bool opposites,
                              const Arguments& arguments) const override {
    return "inverse::" + name + (opposites ? "<Scalar, true>(" : "<Scalar>(") + joined(arguments) + ")";
  }
  std::string output_angle(const std::string& cosine, const std::string& sine,
                           const std::string& length) const override {
    return "inverse::output_angle(" + joined({cosine, sine, length}) + ")";
  }
  std::string turn_apart(const std::string& cosine, const std::string& sine,
                         const std::string& seed) const override {
    return "inverse::apart({" + cosine + ", " + sine + "}, " + seed + ")";
  }
  std::string slide_apart(const std::string& value, const std::string& seed) const override {
    return "inverse::apart(" + value + ", " + seed + ")";
  }
  std::string wrist_apart(const std::string& angles, const Arguments& seed) const override {
    return "inverse::apart(" + angles + ", {" + joined(seed) + "})";
  }
  std::string takes_other(const std::string& other, const std::string& other_apart, const std::string& branch,
                          const std::string& apart) const override {
    return "forks.takes_other(" + joined({other, other_apart, branch, apart}) + ")";
  }

  std::string number_type() const override { return "Scalar"; }
  std::string mathematical(const std::string& function) const override { return "std::" + function; }
  std::string joint_value(std::size_t i) const override { return "values[" + std::to_string(i) + "]"; }

  Lines new_work(const std::string& name, bool all_zero) const override {
    return {"Work<double> " + name + (all_zero ? "{};" : ";")};
  }
  Lines copied_work(const std::string& name, const std::string& from) const override {
    return {"Work<double> " + name + " = " + from + ";"};
  }
  std::string assign_work(const std::string& name, const std::string& from) const override {
    return name + " = " + from + ";";
  }
  std::string new_row(int size) const override { return "qvgen::Joints<" + std::to_string(size) + "> q;"; }
  std::string save_branch(const std::string& name, const std::string& work) const override {
    return "const inverse::Branch<double> " + name + " = " + work + ".branch;";
  }
  std::string resume_branch(const std::string& work, const std::string& name) const override {
    return work + ".branch.resume(" + name + ");";
  }
  std::string constant(const std::string& /*type*/, const std::string& name,
                       const std::string& value) const override {
    return "const auto " + name + " = " + value + ";";
  }
  std::string variable(const std::string& /*type*/, const std::string& name,
                       const std::string& value) const override {
    return "auto " + name + " = " + value + ";";
  }
  std::string chosen(const std::string& /*type*/, const std::string& name,
                     const std::string& value) const override {
    return "const auto& " + name + " = " + value + ";";
  }
  std::string entry(const std::string& array, const std::string& index) const override {
    return array + "[static_cast<std::size_t>(" + index + ")]";
  }
  std::string rows_found() const override { return "found.size()"; }
  std::string append(const std::string& label, const std::string& work) const override {
    return "inverse::append(found, q, " + label + ", " + work + ".branch.continuum);";
  }
  std::string append_nearest(const std::string& work) const override { return append("forks.label", work); }
  std::string is_settled(const std::string& label, bool /*visits*/) const override {
    return "tracker.settled(" + label + ")";
  }
  std::string close(const std::string& label) const override { return "tracker.close(" + label + ");"; }
  std::string reopen(const std::string& label, const std::string& work, bool /*visits*/) const override {
    return "tracker.reopen(" + label + ", " + work + ".branch.continuum);";
  }
  Lines polish_lines(const PolishTask& task) const override {
    const std::string joints = std::to_string(task.axes.size());
    const std::string type = "inverse::JointValues<Scalar, " + joints + ">";
    Lines lines = {type + " values" + array(task.from) + ";",
                   "const " + type + " seed" + array(task.seed) + ";",
                   "const inverse::PointMatching<Scalar, " + joints + ", " +
                       std::to_string(task.start.size()) + "> task{",
                   "    " + array(screws(task)) + ",",
                   "    " + array(places(task.start)) + ",",
                   "    " + array(places(task.goal)) + ", " + task.size_square + "};",
                   "if (!tracker.settle(label, task, t.boundary, t.preference->seeded ? "
                   "&seed : nullptr, values, w.branch)) return false;"};
    lines.insert(lines.end(), task.back.begin(), task.back.end());
    lines.emplace_back("return true;");
    return lines;
  }
  std::string polishes(const std::string& step, const std::string& target, const std::string& label,
                       const std::string& work, bool /*of_seed*/) const override {
    return "solve_" + step + "(" + joined({target, label, "tracker", work}) + ")";
  }
  std::string take_nearer(const std::string& other, const std::string& other_apart, const std::string& work,
                          const std::string& apart) const override {
    return "inverse::take_nearer(" + joined({other, other_apart, work, apart}) + ", forks);";
  }
  Lines nearest_root(const std::string& number, const std::string& take, const std::string& apart,
                     int branches) const override {
    const std::string k = "k" + number, each = "each" + number, nearest = "nearest" + number;
    return {"inverse::NearestRoot<Work<double>> " + nearest + "(w);",
            "for (int " + k + " = 0; " + k + " < roots.count; ++" + k + ") {",
            "  Work<double> " + each + " = w;",
            "  " + take,
            "  " + nearest + ".add(" + each + ", " + apart + ", " + k + ");",
            "}",
            "forks.label = " + std::to_string(branches) + " * forks.label + " + nearest + ".index;",
            "w = " + nearest + ".work;"};
  }
};

class CppLanes : public Cpp {
 public:
  std::string mathematical(const std::string& function) const override { return function; }
};

}  // namespace

const Dialect& cpp_dialect() {
  static const Cpp cpp;
  return cpp;
}

const Dialect& cpp_lane_dialect() {
  static const CppLanes lanes;
  return lanes;
}

}  // namespace qvgen::emit
