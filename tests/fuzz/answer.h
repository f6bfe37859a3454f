// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace qvgen::test {

/// Answer of `check` and `generate --only kinematics` to any text.
enum class Answer { refused, read, generated };

/// The answer to a text: a description is read or refused with a place, what is wrong and what would be
/// right; one of at most `most_joints` joints is then generated as far as its forward kinematics. Throws
/// std::logic_error if an answer is no good: a mistake without a place, a certificate that fails.
Answer answer(std::string_view text, std::size_t most_joints);

}  // namespace qvgen::test
