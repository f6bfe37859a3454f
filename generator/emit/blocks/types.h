// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "emit/blocks/unit.h"

/// Types of the subset as values, and the type that C gives a result of two numbers.
namespace qvgen::emit::blocks {

/// Basic types, and types made of others.
TypeRef basic(Type::Kind kind);
TypeRef structure_type(const std::string& name);
/// `constant`: the name that says the size, if one does.
TypeRef array_of(const TypeRef& element, int size, const std::string& constant = "");
TypeRef pointer_to(const TypeRef& element, bool constant, int size = 0);
TypeRef reference_to(const TypeRef& type, bool constant);

bool is_number(const TypeRef& type);
/// Type of a result of both.
TypeRef common(const TypeRef& a, const TypeRef& b);

}  // namespace qvgen::emit::blocks
