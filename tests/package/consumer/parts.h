// SPDX-License-Identifier: MIT
#pragma once

bool runtime_works();
bool vector_file_works();
