# SPDX-License-Identifier: MIT
# cmake -DOUTPUT=file.cpp -DFOLDER=templates -DTOLERANCES=a.h|b.h -P embed_templates.cmake: writes the templates as one C++
# table, so that the tool is a single file that works from anywhere. A key is a file's path in the folder without
# ".mustache": "cpp/inverse.h". In C each tolerance_NAME becomes the number that `inline constexpr double NAME = ...;` says in
# the headers of the runtime that are named, so that a number stands once.
string(REPLACE "|" ";" headers "${TOLERANCES}")
set(tolerances "")
foreach(header IN LISTS headers)
  file(READ "${header}" text)
  string(REGEX MATCHALL "inline constexpr double [a-z_]+ = [^;]+" found "${text}")
  list(APPEND tolerances ${found})
endforeach()

# Puts the numbers of the runtime in the place of their names.
function(with_tolerances text result)
  foreach(definition IN LISTS tolerances)
    string(REGEX REPLACE "inline constexpr double ([a-z_]+) = (.*)" "\\1" name "${definition}")
    string(REGEX REPLACE "inline constexpr double ([a-z_]+) = (.*)" "\\2" number "${definition}")
    string(REGEX REPLACE "tolerance_${name}([^a-z_])" "${number}\\1" text "${text}")
  endforeach()
  if(text MATCHES "(tolerance_[a-z_]*[a-z])[^a-z_A-Z]" AND NOT CMAKE_MATCH_1 STREQUAL "")
    message(FATAL_ERROR "${path}: no header of the runtime has the number ${CMAKE_MATCH_1}")
  endif()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE paths RELATIVE "${FOLDER}" "${FOLDER}/*")
list(SORT paths)
set(entries "")
set(blocks "")
foreach(path IN LISTS paths)
  file(READ "${FOLDER}/${path}" text)
  if(path MATCHES "^c/")
    with_tolerances("${text}" text)
  endif()
  if(path MATCHES "^c/inverse/")
    # All robots in C share these blocks, which are put one behind the other and not filled in.
    string(APPEND blocks "       R\"~template~(${text}\n)~template~\"\n")
    continue()
  endif()
  string(REGEX REPLACE "\\.mustache$" "" key "${path}")
  string(APPEND entries "      {\"${key}\", R\"~template~(${text})~template~\"},\n")
endforeach()
string(APPEND entries "      {\"c/inverse_blocks\",\n${blocks}      },\n")
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
