// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

/// Stands in for pluginlib's header of this name: what is exported can be made by its name.
namespace pluginlib {

template <class Base>
std::map<std::string, std::function<std::unique_ptr<Base>()>>& exported() {
  static std::map<std::string, std::function<std::unique_ptr<Base>()>> classes;
  return classes;
}

}  // namespace pluginlib

#define PLUGINLIB_EXPORT_CLASS(Class, Base)        \
  [[maybe_unused]] static const bool is_exported = \
      pluginlib::exported<Base>().emplace(#Class, [] { return std::make_unique<Class>(); }).second;
