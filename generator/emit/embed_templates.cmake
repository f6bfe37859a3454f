# SPDX-License-Identifier: MIT
# cmake -DOUTPUT=file.cpp -DFOLDER=templates -P embed_templates.cmake: writes the templates as one C++ table, so that the
# tool is a single file that works from anywhere. A key is a file's path in the folder without ".mustache": "cpp/inverse.h".
file(GLOB_RECURSE paths RELATIVE "${FOLDER}" "${FOLDER}/*")
list(SORT paths)
set(entries "")
set(blocks "")
foreach(path IN LISTS paths)
  file(READ "${FOLDER}/${path}" text)
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
