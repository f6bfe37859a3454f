// SPDX-License-Identifier: MIT
#include "description/xml/urdf_edit.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "description/xml/decimals.h"
#include "description/xml/reader.h"
#include "description/xml/text.h"

namespace qvgen::description::xml {
namespace {

std::string words(const std::array<double, 3>& v) { return fmt::format("{} {} {}", v[0], v[1], v[2]); }

std::string origin_tag(const UrdfOrigin& origin) {
  return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", words(origin.xyz), words(origin.rpy));
}

UrdfStep step_of(Context& context, const UrdfLink& link) {
  UrdfStep step;
  step.joint = link.joint->attribute("name")->value;
  step.moves = link.moves;
  step.origin = read_origin(context, *link.joint);
  step.axis = read_triple(context, link.joint->child("axis"), "xyz", step.axis);
  const Element* mimic = link.joint->child("mimic");
  step.has_offset =
      link.moves && mimic != nullptr && !cln::zerop(read_decimal(context, *mimic, "offset", 0).value);
  return step;
}

}  // namespace

/// The text with what is replaced and inserted, sorted by bytes.
class UrdfEdit::File {
 public:
  File(const std::string& text, const ReadOptions& options) : text_(text), context_(text_, "", options) {
    if (is_utf16_xml(text))
      throw std::runtime_error("the URDF is in UTF-16: save it as UTF-8, and it can be changed in its place");
    root_ = parse(context_, text);
    if (!root_ || root_->name != "robot")
      throw std::runtime_error("only a URDF can be changed in its place, and this description is none");
    links_ = urdf_chain(context_, *root_);
    if (links_.empty()) throw std::runtime_error("the URDF has no chain with these options");
    for (const UrdfLink& link : links_) steps.push_back(step_of(context_, link));
  }

  std::vector<UrdfStep> steps;

  [[nodiscard]] const UrdfLink& link(std::size_t step) const { return links_.at(step); }
  [[nodiscard]] const Element& root() const { return *root_; }

  void replace(std::size_t begin, std::size_t end, const std::string& by) { changes_[{begin, end}] += by; }

  /// Removes an element with the line that it leaves empty.
  void remove(const Element& element) {
    const std::size_t before = text_.find_last_not_of(" \t", element.begin - 1);
    const bool alone = before != std::string::npos && text_[before] == '\n' && text_[element.end] == '\n';
    replace(alone ? before : element.begin, element.end, "");
  }

  /// Replaces a child by a text, or adds it as the first child.
  void set_child(const Element& parent, const std::string& name, const std::string& by) {
    if (const Element* child = parent.child(name)) return replace(child->begin, child->end, by);
    const std::string line = "\n" + indent_of(parent) + "  " + by;
    if (parent.head_end < parent.end) return replace(parent.head_end, parent.head_end, line);
    const std::size_t slash = text_.rfind('/', parent.end);
    replace(slash, parent.end, ">" + line + "\n" + indent_of(parent) + "</" + parent.name + ">");
  }

  [[nodiscard]] std::string indent_of(const Element& element) const {
    const std::size_t before = text_.find_last_not_of(" \t", element.begin - 1);
    const bool alone = element.begin > 0 && before != std::string::npos && text_[before] == '\n';
    return alone ? text_.substr(before + 1, element.begin - before - 1) : "";
  }

  [[nodiscard]] std::string text() const {
    std::string result;
    std::size_t at = 0;
    for (const auto& [bytes, by] : changes_) {
      result += text_.substr(at, bytes.first - at) + by;
      at = bytes.second;
    }
    return result + text_.substr(at);
  }

 private:
  std::string text_;
  Context context_;
  std::optional<Element> root_;
  std::vector<UrdfLink> links_;
  std::map<std::pair<std::size_t, std::size_t>, std::string> changes_;
};

UrdfEdit::UrdfEdit(const std::string& text, const ReadOptions& options)
    : file_(std::make_unique<File>(text, options)) {}
UrdfEdit::~UrdfEdit() = default;

const std::vector<UrdfStep>& UrdfEdit::steps() const { return file_->steps; }

void UrdfEdit::set_origin(std::size_t step, const UrdfOrigin& origin) {
  file_->set_child(*file_->link(step).joint, "origin", origin_tag(origin));
}

void UrdfEdit::set_axis(std::size_t step, const std::array<double, 3>& axis) {
  file_->set_child(*file_->link(step).joint, "axis", fmt::format("<axis xyz=\"{}\"/>", words(axis)));
}

void UrdfEdit::set_inertia(std::size_t step, const UrdfInertia& inertia) {
  const UrdfLink& link = file_->link(step);
  const std::string indent = "\n" + file_->indent_of(*link.link) + "    ";
  const auto& t = inertia.inertia;
  const std::string tensor =
      fmt::format("<inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>", t[0], t[3],
                  t[5], t[1], t[4], t[2]);
  file_->set_child(*link.link, "inertial",
                   fmt::format("<inertial>{0}{1}{0}<mass value=\"{2}\"/>{0}{3}{4}</inertial>", indent,
                               origin_tag({inertia.centre, {}}), inertia.mass, tensor,
                               indent.substr(0, indent.size() - 2)));
  for (const Element* rigid : link.rigid)
    if (const Element* inertial = rigid->child("inertial")) file_->remove(*inertial);
}

void UrdfEdit::set_friction(std::size_t step, double viscous, double coulomb) {
  file_->set_child(*file_->link(step).joint, "dynamics",
                   fmt::format("<dynamics damping=\"{}\" friction=\"{}\"/>", viscous, coulomb));
}

std::string UrdfEdit::add_tip(const UrdfOrigin& origin) {
  std::set<std::string> taken;
  for (const Element& child : file_->root().children)
    if (const Attribute* name = child.attribute("name")) taken.insert(name->value);
  const std::string tip = file_->link(file_->steps.size() - 1).link->attribute("name")->value;
  std::string name = tip + "_calibrated";
  while (taken.contains(name) || taken.contains(name + "_joint")) name += "_";
  const Element& last = file_->root().children.back();
  file_->replace(last.end, last.end,
                 fmt::format("\n  <link name=\"{0}\"/>\n  <joint name=\"{0}_joint\" type=\"fixed\">\n"
                             "    <parent link=\"{1}\"/>\n    <child link=\"{0}\"/>\n    {2}\n  </joint>",
                             name, tip, origin_tag(origin)));
  return name;
}

void UrdfEdit::add_comment(const std::string& lines) {
  std::istringstream stream(lines);
  std::string comment;
  for (std::string line; std::getline(stream, line);) {
    // Two hyphens end a comment.
    for (std::size_t at = 0; (at = line.find("--", at)) != std::string::npos;) line.insert(at + 1, " ");
    comment += "\n  <!-- " + line + " -->";
  }
  const std::size_t begin = file_->root().head_end;
  file_->replace(begin, begin, comment);
}

std::string UrdfEdit::text() const { return file_->text(); }

}  // namespace qvgen::description::xml
