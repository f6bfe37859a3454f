// SPDX-License-Identifier: MIT
// The instances that printed_values.h promises.
#include "printed_values.h"

namespace testing {

template std::string PrintToString(const bool&);
template std::string PrintToString(const int&);
template std::string PrintToString(const unsigned&);
template std::string PrintToString(const long&);
template std::string PrintToString(const unsigned long&);
template std::string PrintToString(const double&);
template std::string PrintToString(const std::string&);
template std::string PrintToString(const char* const&);

}  // namespace testing
