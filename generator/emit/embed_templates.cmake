# SPDX-License-Identifier: MIT
# cmake -DOUTPUT=file.cpp -DFOLDER=templates -DRUNTIME=runtime/include/qvgen -P embed_templates.cmake: writes the templates
# as one C++ table, so that the tool is a single file that works from anywhere. A key is a file's path in the folder without
# ".mustache": "cpp/inverse.h". In C each tolerance_NAME and constant_NAME becomes the number that a header of the runtime
# gives that name by `inline constexpr double NAME = ...;`, so that a number stands once. Headers of the runtime that C is
# made of (HEADERS) are entries, too: "runtime/roots.h", with numbers in the place of tolerance::NAME and constant::NAME.
set(numbers "")
function(read_numbers prefix header)
  file(READ "${RUNTIME}/${header}" text)
  string(REGEX MATCHALL "inline constexpr double [a-z_0-9]+ = [^;]+" found "${text}")
  list(TRANSFORM found REPLACE "inline constexpr double " "${prefix}_")
  set(numbers ${numbers} ${found} PARENT_SCOPE)
endfunction()
read_numbers(tolerance inverse/tolerances.h)
read_numbers(tolerance unit_tolerance.h)
read_numbers(tolerance assembly.h)
read_numbers(constant inverse/constants.h)

# Puts the numbers of the runtime in the place of their names.
function(with_numbers text result)
  foreach(definition IN LISTS numbers)
    string(REGEX REPLACE "^([a-z_0-9]+) = (.*)" "\\1" name "${definition}")
    string(REGEX REPLACE "^([a-z_0-9]+) = (.*)" "\\2" number "${definition}")
    string(REGEX REPLACE "${name}([^a-z_0-9])" "${number}\\1" text "${text}")
  endforeach()
  if(text MATCHES "((tolerance|constant)_[a-z_0-9]*[a-z0-9])[^a-z_0-9A-Z]")
    message(FATAL_ERROR "${path}: no header of the runtime has the number ${CMAKE_MATCH_1}")
  endif()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE paths RELATIVE "${FOLDER}" "${FOLDER}/*")
list(SORT paths)
set(entries "")
foreach(path IN LISTS paths)
  file(READ "${FOLDER}/${path}" text)
  if(path MATCHES "^c/")
    with_numbers("${text}" text)
  endif()
  string(REGEX REPLACE "\\.mustache$" "" key "${path}")
  string(APPEND entries "      {\"${key}\", R\"~template~(${text})~template~\"},\n")
endforeach()
foreach(name IN LISTS HEADERS)
  set(path "runtime/${name}")
  file(READ "${RUNTIME}/inverse/${name}" text)
  string(REPLACE "tolerance::digits(" "digits(" text "${text}")
  string(REGEX REPLACE "(tolerance|constant)::" "\\1_" text "${text}")
  with_numbers("${text}" text)
  string(APPEND entries "      {\"${path}\", R\"~template~(${text})~template~\"},\n")
endforeach()
file(WRITE "${OUTPUT}.new" "#include \"emit/builtin_templates.h\"

namespace qvgen::emit {

const std::map<std::string, std::string>& builtin_templates() {
  static const std::map<std::string, std::string> templates{
${entries}  };
  return templates;
}

}  // namespace qvgen::emit
")
file(COPY_FILE "${OUTPUT}.new" "${OUTPUT}" ONLY_IF_DIFFERENT)
