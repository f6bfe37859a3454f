// SPDX-License-Identifier: MIT
#include "description/xml/mjcf_contents.h"

#include <algorithm>

#include <cln/integer.h>

#include "description/xml/decimals.h"

namespace qvgen::description::xml {
namespace {

/// The number of a copy, with as many digits as the count has.
std::string number_of(long copy, long count) {
  const std::string number = std::to_string(copy);
  const std::size_t digits = std::to_string(count).size();
  return std::string(digits - std::min(digits, number.size()), '0') + number;
}

/// The element inside another one.
Placed inside(const Placed& around, const Element& element) {
  Placed placed = around;
  placed.element = &element;
  return placed;
}

/// Opens an element: notes its class for children, if it has one.
Placed opened(Placed holder) {
  if (const Attribute* own = holder.element->attribute("childclass")) holder.childclass = own->value;
  return holder;
}

const Element* world_of(const MjcfModel& model) { return model.root.child("worldbody"); }

}  // namespace

std::string Placed::name() const {
  const std::string own = text_of(*element, "name");
  return own.empty() ? own : prefix + own + suffix;
}

Element Placed::completed(Context& context) const {
  return model->defaults.completed(context, *element, childclass);
}

bool MjcfContents::within_bounds(const Element& element) {
  const bool many = ++elements_ > max_elements;
  if ((many || depth_ > max_depth) && !refused_) {
    refused_ = true;
    context_->error(
        element.place,
        many ? "with all copies more than " + std::to_string(max_elements) + " elements"
             : "frames and attached bodies nested more than " + std::to_string(max_depth) + " deep",
        many ? "copy less" : "a body does not attach one that holds it");
  }
  return !refused_;
}

std::vector<Placed> MjcfContents::of(const Placed& body) {
  Placed around = opened(body);
  around.around = nullptr;
  std::vector<Placed> all;
  add(*body.element, around, all);
  return all;
}

void MjcfContents::add(const Element& holder, const Placed& around, std::vector<Placed>& all) {
  ++depth_;
  for (const Element& child : holder.children) {
    if (!within_bounds(child)) break;
    const Placed placed = inside(around, child);
    if (child.name == "frame")
      add_frame(placed, all);
    else if (child.name == "replicate")
      add_copies(placed, all);
    else if (child.name == "attach")
      add_attached(placed, all);
    else
      all.push_back(placed);
  }
  --depth_;
}

/// The frame around what it holds, with those around it.
std::shared_ptr<const Around> MjcfContents::within(const Placed& frame, long copy) {
  const std::size_t depth = frame.around == nullptr ? 1 : frame.around->depth + 1;
  if (depth > max_frames && !refused_) {
    refused_ = true;
    context_->error(frame.element->place, "frames nested more than " + std::to_string(max_frames) + " deep",
                    "put them together");
  }
  return std::make_shared<Around>(Around{frame.around, frame.model, frame.element, copy, depth});
}

void MjcfContents::add_frame(const Placed& frame, std::vector<Placed>& all) {
  Placed around = opened(frame);
  around.around = within(frame, 0);
  add(*frame.element, around, all);
}

long MjcfContents::copies(const Element& replicate) {
  const auto count = read_decimals(*context_, replicate, "count", 1);
  if (!count) {
    if (replicate.attribute("count") == nullptr)
      context_->error(replicate.place, "<replicate> without 'count'", "add count=\"...\"");
    return 0;
  }
  const Decimal& number = count->front();
  if (cln::denominator(number.value) == 1 && !cln::minusp(number.value) && number.value <= max_copies)
    return cln::cl_I_to_long(cln::numerator(number.value));
  context_->error(number.place, "a count of " + number.text,
                  "write a whole number of copies, at most " + std::to_string(max_copies));
  return 0;
}

void MjcfContents::add_copies(const Placed& replicate, std::vector<Placed>& all) {
  const long count = copies(*replicate.element);
  for (long copy = 0; copy < count && within_bounds(*replicate.element); ++copy) {
    Placed around = opened(replicate);
    around.around = within(replicate, copy);
    around.suffix = text_of(*replicate.element, "sep") + number_of(copy, count) + replicate.suffix;
    add(*replicate.element, around, all);
  }
}

std::optional<Placed> MjcfContents::find(const Placed& holder, const std::string& kind,
                                         const std::string& name) {
  if (!within_bounds(*holder.element)) return std::nullopt;
  std::optional<Placed> found;
  std::vector<Placed> open;
  if (kind == "frame") {  // of(...) writes frames out: they are looked for in the file
    for (const Element& child : holder.element->children) {
      const Placed placed = inside(opened(holder), child);
      if (child.name == "frame" && placed.name() == name) return placed;
      if (child.name == "body" || child.name == "frame") open.push_back(placed);
    }
  } else {
    for (const Placed& placed : of(holder)) {
      if (placed.element->name != "body") continue;
      if (placed.name() == name) return placed;
      open.push_back(placed);
    }
  }
  ++depth_;
  for (const Placed& placed : open)
    if (!found) found = find(placed, kind, name);
  --depth_;
  return found;
}

void MjcfContents::add_attached(const Placed& attach, std::vector<Placed>& all) {
  const Element& element = *attach.element;
  const std::string name = text_of(element, "model");
  const auto model = attach.model->models.find(name);
  const bool other = element.attribute("model") != nullptr;
  if (other && model == attach.model->models.end())
    return context_->error(element.place, "there is no model '" + name + "' to attach",
                           "add <model name=\"" + name + "\" file=\"...\"/> to <asset>");
  Placed source = attach;
  source.model = other ? model->second.get() : attach.model;
  source.element = world_of(*source.model);
  source.childclass = source.prefix = source.suffix = "";
  source.around = nullptr;
  const std::string kind = element.attribute("body") != nullptr ? "body" : "frame";
  const std::string part = text_of(element, kind);
  if (source.element == nullptr || (part.empty() && !other))
    return context_->error(element.place, "nothing to attach",
                           "name a body of a model: model=\"...\" body=\"...\"");
  auto found = part.empty() ? source : find(source, kind, part);
  if (!found)
    return context_->error(element.attribute(kind)->place,
                           "there is no " + kind + " '" + part + "' to attach",
                           "name one that the model has");
  found->prefix = attach.prefix + text_of(element, "prefix") + found->prefix;
  found->suffix += attach.suffix;
  found->around = attach.around;
  if (part.empty()) return add(*found->element, *found, all);
  if (kind == "frame") return add_frame(*found, all);
  all.push_back(*found);
}

}  // namespace qvgen::description::xml
