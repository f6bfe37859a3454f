# SPDX-License-Identifier: MIT
# qvgen_inverse_suffix(HEADER RESULT): what the names of the first functions of an inverse.h end with, "_given_theta3" where a
# joint is given, otherwise nothing; nothing either where there is no such file.
function(qvgen_inverse_suffix header result)
  set(suffix "")
  if(EXISTS ${header})
    file(STRINGS ${header} declaration REGEX "^inline constexpr InverseInfo" LIMIT_COUNT 1)
    string(REGEX REPLACE "^inline constexpr InverseInfo inverse_info([A-Za-z0-9_]*){.*" "\\1" suffix "${declaration}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  endif()
  set(${result} "${suffix}" PARENT_SCOPE)
endfunction()
