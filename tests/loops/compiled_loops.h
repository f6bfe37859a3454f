// SPDX-License-Identifier: MIT
// Mechanisms that a test describes: generated as C, or as C++ behind a header for C, compiled and loaded.
// Both have functions of the same names and arguments.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <dlfcn.h>

#include "mechanism_under_test.h"
#include "toolchain/generated.h"

namespace qvgen::test::loops {

/// A folder that is gone at the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "qvgen_rods_XXXXXX").string();
    path = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path path;
};

enum class Language { c, cxx };

/// The functions of a description, compiled.
class Compiled {
 public:
  Compiled(const std::filesystem::path& description, const std::string& parts,
           Language language = Language::c) {
    const std::filesystem::path made = description.parent_path() / "made", library = made / "loops.so";
    language == Language::c ? compile_c(description, parts, made, library)
                            : compile_cxx(description, parts, made, library);
    library_ = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library_ == nullptr) throw std::runtime_error(::dlerror());
    std::filesystem::remove_all(made);
  }
  ~Compiled() { ::dlclose(library_); }
  Compiled(const Compiled&) = delete;
  Compiled& operator=(const Compiled&) = delete;

  /// Returns the function of that name, whose type the caller knows. Throws if there is none.
  template <class Function>
  [[nodiscard]] Function* get(const std::string& function) const {
    if (!has(function)) throw std::runtime_error("no function " + function);
    return reinterpret_cast<Function*>(::dlsym(library_, function.c_str()));
  }
  [[nodiscard]] bool has(const std::string& function) const {
    return ::dlsym(library_, function.c_str()) != nullptr;
  }
  /// Calls a function that has the assemblies of `dof` joints for values of some.
  [[nodiscard]] Set solve(const std::string& function, const VectorXd& values, Eigen::Index dof) const {
    using Solve = int(const double*, const double*, const double*, int, double*, int*, int*, int*, int*);
    const auto call = get<Solve>(function);
    const int room = *static_cast<const int*>(::dlsym(library_, (function + "_capacity").c_str()));
    const auto rows = static_cast<std::size_t>(room);
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> q(room, dof);
    std::vector<int> branches(rows), frees(rows), meets(rows);
    int status = -1;
    const int count = call(values.data(), nullptr, nullptr, room, q.data(), branches.data(), frees.data(),
                           meets.data(), &status);
    Set set{static_cast<Status>(status), {}};
    for (int k = 0; k < count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      set.rows.push_back({q.row(k).transpose(), branches[at], frees[at] != 0, meets[at] != 0});
    }
    return set;
  }

 private:
  using Path = std::filesystem::path;

  static void compile_c(const Path& description, const std::string& parts, const Path& made,
                        const Path& library) {
    run({QVGEN_TOOL, "generate", description.string(), "--quiet", "--language", "c", "--only", parts,
         "--require", "assembly", "--output", made.string()});
    std::vector<std::string> words{QVGEN_CC, "-shared", "-fPIC", "-ffp-contract=off", "-o", library.string()};
    for (const auto& file : std::filesystem::directory_iterator(made / "c"))
      if (file.path().extension() == ".c") words.push_back(file.path().string());
    words.emplace_back("-lm");
    run(words);
  }
  /// Compiles what the header for C calls, and nothing else that the parts bring.
  static void compile_cxx(const Path& description, const std::string& parts, const Path& made,
                          const Path& library) {
    run({QVGEN_TOOL, "generate", description.string(), "--quiet", "--only",
         parts + ",kinematics,jacobian,c_assembly", "--require", "assembly", "--output", made.string()});
    const toolchain::Runtime runtime = toolchain::runtime_of(QVGEN_SOURCE_DIR);
    toolchain::Program program{
        toolchain::cxx_compiler(), toolchain::options_of_all(runtime), {}, {"-shared"}};
    program.options.insert(program.options.end(), {"-O0", "-fPIC", "-I" + (made / "include").string()});
#ifndef __clang__
    // Unique symbols would keep a library, and be those of the next one, which has the same names.
    program.options.emplace_back("-fno-gnu-unique");
#endif
    std::vector<Path> files;
    for (const auto& file : std::filesystem::recursive_directory_iterator(made / "source")) {
      const std::string name = file.path().filename().string();
      for (const char* needed :
           {"assembly.cpp", "c_assembly.cpp", "dynamics.cpp", "jacobian.cpp", "kinematics.cpp"})
        if (name == needed) files.push_back(file.path());
    }
    for (const Path& file : files) program.sources.push_back(toolchain::generated_source(file));
    toolchain::add_runtime(runtime, files, program);
    const toolchain::Outcome outcome = toolchain::build(program, library);
    if (!outcome.done) throw std::runtime_error(outcome.said);
  }
  static void run(const std::vector<std::string>& words) {
    const toolchain::Outcome outcome = toolchain::run(words);
    if (!outcome.done) throw std::runtime_error(outcome.said);
  }
  void* library_ = nullptr;
};

}  // namespace qvgen::test::loops
