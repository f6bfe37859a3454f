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
# What generated C has in common, not to be filled in.
file(GLOB paths "${FOLDER}/c_inverse/*.c")
list(SORT paths)
string(APPEND entries "      {\"c_inverse_blocks\",\n")
foreach(path IN LISTS paths)
  file(READ "${path}" text)
  string(APPEND entries "       R\"~template~(${text}\n)~template~\"\n")
endforeach()
string(APPEND entries "      },\n")
# Pages: filled in where the name says so, else as they are.
file(GLOB paths "${FOLDER}/report/*")
list(SORT paths)
foreach(path IN LISTS paths)
  get_filename_component(name "${path}" NAME)
  string(REGEX REPLACE "\\.mustache$" "" name "${name}")
  file(READ "${path}" text)
  string(APPEND entries "      {\"report/${name}\", R\"~template~(${text})~template~\"},\n")
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
