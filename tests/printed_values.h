// SPDX-License-Identifier: MIT
// Values as failed comparisons print them, compiled once (printed_values.cpp) and not in each of two hundred
// files.
#pragma once

#include <string>

#include <gtest/gtest.h>

namespace testing {

extern template std::string PrintToString(const bool&);
extern template std::string PrintToString(const int&);
extern template std::string PrintToString(const unsigned&);
extern template std::string PrintToString(const long&);
extern template std::string PrintToString(const unsigned long&);
extern template std::string PrintToString(const double&);
extern template std::string PrintToString(const std::string&);
extern template std::string PrintToString(const char* const&);

}  // namespace testing
