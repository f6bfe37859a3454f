// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// The one table of languages: `--language`, the folders of the output and `qvgen languages` read it.
namespace qvgen::pipeline {

/// Language of the output; C and kernels of devices in double or in float.
enum class Language {
  cxx,
  c,
  c_in_float,
  rust,
  javascript,
  octave,
  opencl,
  opencl_in_float,
  cuda,
  cuda_in_float
};

/// True for languages that are made of a robot's whole C.
inline bool is_translated(Language language) {
  return language != Language::cxx && language != Language::c && language != Language::c_in_float;
}
/// True for kernels of devices.
inline bool is_of_devices(Language language) {
  return language == Language::opencl || language == Language::opencl_in_float ||
         language == Language::cuda || language == Language::cuda_in_float;
}
/// True for languages that compute in float.
inline bool is_in_float(Language language) {
  return language == Language::c_in_float || language == Language::opencl_in_float ||
         language == Language::cuda_in_float;
}
/// Returns the language in float, or itself if it has no such form.
inline Language in_float(Language language) {
  return language == Language::c        ? Language::c_in_float
         : language == Language::opencl ? Language::opencl_in_float
         : language == Language::cuda   ? Language::cuda_in_float
                                        : language;
}

/// Parts that a language has not, and why.
struct Lack {
  std::vector<std::string> parts;
  std::string reason;
};

struct LanguageRow {
  Language language;
  std::string name;     ///< as `--language` calls it, and the folder of its files
  std::string gives;    ///< files of a robot
  std::string numbers;  ///< scalars, and whose bits the results have
  std::vector<Lack> lacks;
};

/// Languages that `--language` takes, C++ first.
const std::vector<LanguageRow>& languages();

/// Returns the row of a language; those in float have the rows of double.
const LanguageRow& row_of(Language language);

/// The reason for which a language lacks a part; empty if it has it.
std::string lack_of(const LanguageRow& row, const std::string& part);

}  // namespace qvgen::pipeline
