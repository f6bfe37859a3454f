// SPDX-License-Identifier: MIT
#pragma once

namespace qvgen::cli {

/// Calls that show what can be done, one a line, each with what it does.
extern const char* const examples;
extern const char* const compare_examples;
extern const char* const report_examples;
extern const char* const map_examples;
extern const char* const calibrate_examples;
extern const char* const identify_examples;
extern const char* const path_examples;
/// Exit codes of the tool, and why it has them; see ExitCode.
extern const char* const exit_codes;

}  // namespace qvgen::cli
