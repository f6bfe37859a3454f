// SPDX-License-Identifier: MIT
#include "emit/render.h"

#include <kainjow/mustache.hpp>

#include "emit/builtin_templates.h"
#include "emit/cpp/tidy.h"

namespace qvgen::emit {
namespace {

namespace mustache = kainjow::mustache;

mustache::data to_data(const nlohmann::json& value) {
  if (value.is_boolean()) return mustache::data(value.get<bool>());
  if (value.is_string()) return mustache::data(value.get<std::string>());
  if (value.is_array()) {
    mustache::data list(mustache::data::type::list);
    for (const auto& item : value) list.push_back(to_data(item));
    return list;
  }
  if (value.is_object()) {
    mustache::data object(mustache::data::type::object);
    for (const auto& [key, item] : value.items()) object.set(key, to_data(item));
    return object;
  }
  return mustache::data(value.dump());
}

/// Remembers the first key that nothing defines.
class StrictContext : public mustache::context<std::string> {
 public:
  explicit StrictContext(const mustache::data* values) : mustache::context<std::string>(values) {}

  const mustache::data* get(const std::string& name) const override {
    const mustache::data* found = mustache::context<std::string>::get(name);
    if (found == nullptr && missing_.empty()) missing_ = name;
    return found;
  }

  [[nodiscard]] const std::string& missing() const { return missing_; }

 private:
  mutable std::string missing_;
};

}  // namespace

std::string render(const std::string& template_name, const nlohmann::json& values) {
  const auto& known = builtin_templates();
  const auto place = known.find(template_name);
  if (place == known.end()) throw TemplateError("no template " + template_name);
  mustache::mustache text(place->second);
  if (!text.is_valid()) throw TemplateError("template " + template_name + ": " + text.error_message());
  text.set_custom_escape([](const std::string& plain) { return plain; });
  mustache::data data = to_data(values);
  for (const auto& [name, part] : known)
    if (const auto end = name.rfind(".partial"); end != std::string::npos)
      data.set(name.substr(name.rfind('/') + 1, end - name.rfind('/') - 1),
               part.substr(0, part.size() - 1));  // its last line ends where it is put
  StrictContext context(&data);
  const std::string result = text.render(context);
  if (!context.missing().empty())
    throw TemplateError("template " + template_name + ": no value for the key " + context.missing());
  const bool is_code =
      template_name.ends_with(".h") || template_name.ends_with(".cpp") || template_name.ends_with(".c");
  return is_code ? tidy(result) : result;
}

}  // namespace qvgen::emit
