# SPDX-License-Identifier: MIT
# cmake -DOUTPUT=file.cpp -DFOLDER=templates -P embed_templates.cmake: the templates as one C++ table, so that the
# tool is a single file that works from anywhere.
file(GLOB paths "${FOLDER}/*.mustache")
list(SORT paths)
set(entries "")
foreach(path IN LISTS paths)
  get_filename_component(name "${path}" NAME)
  string(REGEX REPLACE "\\.mustache$" "" name "${name}")
  file(READ "${path}" text)
  string(APPEND entries "      {\"${name}\", R\"~template~(${text})~template~\"},\n")
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
