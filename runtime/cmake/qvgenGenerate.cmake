# SPDX-License-Identifier: MIT
# qvgen_generate(TARGET name ROBOTS arm.toml [other.urdf|known_name...] [PARTS kinematics inverse ...]): a static library
# of the robots' functions, to be linked. The code is made in the build tree when the build runs: anew when a description,
# the tool or the list of parts changes, and not otherwise. What cannot be derived for a robot is said there.
include_guard(GLOBAL)

# The files that a robot's parts may have are known before it is derived; those that it lacks are empty.
set(qvgen_part_sources_kinematics kinematics)
set(qvgen_part_sources_inverse inverse inverse_avx2)
set(qvgen_part_sources_jacobian jacobian)
set(qvgen_part_sources_dynamics dynamics dynamics_derivatives dynamics_loads regressor)

function(qvgen_generate)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET" "ROBOTS;PARTS")
  if(NOT arg_TARGET OR NOT arg_ROBOTS OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "qvgen_generate(TARGET name ROBOTS descriptions... [PARTS parts...]): ${arg_UNPARSED_ARGUMENTS}")
  endif()
  set(parts ${arg_PARTS})
  if(NOT parts)
    set(parts kinematics inverse jacobian dynamics)
  endif()
  set(only "")
  if(arg_PARTS)
    list(JOIN arg_PARTS "," only)
    set(only --only ${only})
  endif()

  add_library(${arg_TARGET} INTERFACE)
  foreach(robot ${arg_ROBOTS})
    set(description ${robot})
    set(depends "")
    if(robot MATCHES "[./]")
      get_filename_component(description ${robot} ABSOLUTE)
      set(depends ${description})
    endif()
    get_filename_component(id ${robot} NAME_WE)
    set(library ${arg_TARGET}_${id})
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${library})
    set(sources "")
    foreach(part ${parts})
      if(NOT DEFINED qvgen_part_sources_${part})
        message(FATAL_ERROR "qvgen_generate: there is no part ${part}")
      endif()
      foreach(source ${qvgen_part_sources_${part}})
        list(APPEND sources ${folder}/sources/${source}.cpp)
      endforeach()
    endforeach()
    # The stamp is new whenever the tool has run; files that it leaves as they were are not compiled again.
    add_custom_command(
      OUTPUT ${folder}/stamp
      BYPRODUCTS ${sources}
      COMMAND qvgen::tool generate ${description} --output ${folder} ${only} --sources ${folder}/sources
              --depfile ${folder}/stamp.d --quiet
      COMMAND ${CMAKE_COMMAND} -E touch ${folder}/stamp
      DEPENDS ${depends} qvgen::tool
      DEPFILE ${folder}/stamp.d
      COMMENT "qvgen: ${robot}"
      VERBATIM)
    add_custom_target(${library}_code DEPENDS ${folder}/stamp)
    qvgen_robot(${library} INCLUDE ${folder}/include SOURCES ${sources})
    add_dependencies(${library} ${library}_code)
    if(TARGET ${library}_inverse)
      add_dependencies(${library}_inverse ${library}_code)
    endif()
    target_link_libraries(${arg_TARGET} INTERFACE ${library})
  endforeach()
endfunction()
