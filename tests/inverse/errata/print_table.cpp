// SPDX-License-Identifier: MIT
#include <cstdio>

#include "errata.h"

int main() { std::fputs(qvgen::test::errata::table().c_str(), stdout); }
