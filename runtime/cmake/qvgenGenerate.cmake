# SPDX-License-Identifier: MIT
# qvgen_generate(TARGET name ROBOTS arm.toml [other.urdf|known_name...] [PARTS kinematics inverse ...] [LANGUAGE cxx c]
# [NAMESPACE name] [BASE link] [TIP link] [SNAP tolerance|off|auto] [TIPS all|links...] [FIXED joints...] [FLOATING]): a static
# library of the robots' functions, to be linked. The last seven are for a single robot. NAMESPACE is another name for it: its
# functions are in qvgen::robots::name. The others say how a URDF or MJCF is read, as the options of `qvgen generate` do.
# Limbs of a robot that branches are in its library, in C++.
#
# The code is made in the build tree when the build runs: anew when a description, the tool or the list of parts changes, and
# not otherwise. What cannot be derived for a robot is said there. Batch forms are made of the other parts named: PARTS
# kinematics batch. C99 has headers qvgen_NAME.h, and with
# _inverse, _metrics and _velocity behind the name, and needs libm alone.
include_guard(GLOBAL)

# The tool is installed or built with the runtime, or else named.
if(NOT TARGET qvgen::tool AND QVGEN_TOOL)
  add_executable(qvgen::tool IMPORTED GLOBAL)
  set_target_properties(qvgen::tool PROPERTIES IMPORTED_LOCATION ${QVGEN_TOOL})
endif()

# The files that a robot's part may have are known before it is derived; those that it lacks are empty.
function(qvgen_part_sources sources part)
  set(kinematics kinematics)
  set(inverse inverse inverse_avx2)
  set(arm_angle arm_angle)
  set(jacobian jacobian)
  set(batch batch batch_derivatives inverse_batch)
  set(certified certified)
  set(dynamics dynamics dynamics_derivatives dynamics_loads regressor)
  set(mass mass)
  set(frames frames)
  set(geometry_jacobian geometry_jacobian)
  set(regressor_with_drives regressor_with_drives)
  set(given_joint "")  # headers alone
  set(nearest_pose "")
  if(NOT part MATCHES "^(kinematics|inverse|arm_angle|jacobian|batch|certified|dynamics|mass|frames|geometry_jacobian|regressor_with_drives|given_joint|nearest_pose)$")
    message(FATAL_ERROR "qvgen_generate: there is no part ${part}")
  endif()
  set(${sources} ${${part}} PARENT_SCOPE)
endfunction()

# The libraries of the runtime that the parts of any robot may need: who wants kinematics alone builds no more. What an inverse
# kinematics is like is known when it is derived, so it links elimination too.
function(qvgen_libraries_of_parts libraries)
  set(needs qvgen::core)
  foreach(part ${ARGN})
    if(part STREQUAL inverse)
      list(APPEND needs qvgen::inverse qvgen::elimination)
    elseif(part MATCHES "^(arm_angle|batch|certified|given_joint|nearest_pose)$")
      list(APPEND needs qvgen::${part})
    endif()
  endforeach()
  set(${libraries} ${needs} PARENT_SCOPE)
endfunction()

function(qvgen_generate)
  cmake_parse_arguments(PARSE_ARGV 0 arg "FLOATING" "TARGET;NAMESPACE;BASE;TIP;SNAP" "ROBOTS;PARTS;LANGUAGE;TIPS;FIXED")
  if(NOT TARGET qvgen::tool)
    message(FATAL_ERROR "qvgen_generate: here is no tool that generates. -DQVGEN_TOOL=path names one that is there, "
                        "-DQVGEN_GENERATOR=ON has it built with qvgen's sources (needs GiNaC and CLN); of an installation "
                        "it is the component 'tool'")
  endif()
  if(NOT arg_TARGET OR NOT arg_ROBOTS OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "qvgen_generate(TARGET name ROBOTS descriptions... [PARTS parts...] "
                        "[LANGUAGE cxx c] [NAMESPACE name] [BASE link] [TIP link] [SNAP tolerance] [TIPS links] "
                        "[FIXED joints] [FLOATING]): ${arg_UNPARSED_ARGUMENTS}")
  endif()
  list(LENGTH arg_ROBOTS count)
  foreach(word NAMESPACE BASE TIP SNAP TIPS FIXED)
    if(DEFINED arg_${word} AND NOT count EQUAL 1)
      message(FATAL_ERROR "qvgen_generate: ${word} ${arg_${word}} is for one robot, and here are ${count}")
    endif()
  endforeach()
  set(reading "")
  foreach(word BASE TIP SNAP)
    if(DEFINED arg_${word})
      string(TOLOWER ${word} option)
      list(APPEND reading --${option} ${arg_${word}})
    endif()
  endforeach()
  foreach(word TIPS FIXED)
    if(DEFINED arg_${word})
      string(TOLOWER ${word} option)
      list(JOIN arg_${word} "," names)
      list(APPEND reading --${option} ${names})
    endif()
  endforeach()
  if(arg_FLOATING)
    list(APPEND reading --floating)
  endif()
  if(NOT arg_LANGUAGE)
    set(arg_LANGUAGE cxx)
  endif()

  add_library(${arg_TARGET} INTERFACE)
  foreach(robot ${arg_ROBOTS})
    get_filename_component(id ${robot} NAME_WE)
    foreach(language ${arg_LANGUAGE})
      if(language STREQUAL cxx)
        qvgen_generate_cxx(${arg_TARGET}_${id} ${robot} "${arg_NAMESPACE}" "${reading}" "${arg_PARTS}")
        target_link_libraries(${arg_TARGET} INTERFACE ${arg_TARGET}_${id})
      elseif(language STREQUAL c)
        qvgen_generate_c(${arg_TARGET}_${id}_c ${robot} "${arg_NAMESPACE}" "${reading}" "${arg_PARTS}")
        target_link_libraries(${arg_TARGET} INTERFACE ${arg_TARGET}_${id}_c)
      else()
        message(FATAL_ERROR "qvgen_generate: there is no language ${language}; there are cxx and c")
      endif()
    endforeach()
  endforeach()
endfunction()

function(qvgen_generate_cxx library robot namespace reading only)
  set(parts ${only})
  if(NOT parts)
    set(parts kinematics inverse jacobian dynamics)
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${library})
  set(sources "")
  foreach(part ${parts})
    qvgen_part_sources(part_sources ${part})
    foreach(source ${part_sources})
      list(APPEND sources ${folder}/sources/${source}.cpp)
    endforeach()
  endforeach()
  qvgen_generated_code(${library} ${robot} "${namespace}" "${reading}" cxx "${only}" ${sources})
  qvgen_libraries_of_parts(needs ${parts})
  qvgen_robot(${library} INCLUDE ${folder}/include SOURCES ${sources} NEEDS ${needs})
  add_dependencies(${library} ${library}_code)
  foreach(part inverse batch batch_AVX2 batch_AVX512 batch_NEON)
    if(TARGET ${library}_${part})
      add_dependencies(${library}_${part} ${library}_code)
    endif()
  endforeach()
endfunction()

function(qvgen_generate_c library robot namespace reading only)
  if(NOT CMAKE_C_COMPILER)
    message(FATAL_ERROR "qvgen_generate: LANGUAGE c needs a project with the language C")
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${library})
  set(sources ${folder}/sources/robot.c)
  if(NOT only OR "inverse" IN_LIST only)
    list(APPEND sources ${folder}/sources/inverse.c ${folder}/sources/metrics.c)
  endif()
  if(NOT only OR "jacobian" IN_LIST only)
    list(APPEND sources ${folder}/sources/velocity.c)
  endif()
  qvgen_generated_code(${library} ${robot} "${namespace}" "${reading}" c "${only}" ${sources})
  add_library(${library} STATIC ${sources})
  add_dependencies(${library} ${library}_code)
  set_target_properties(${library} PROPERTIES C_STANDARD 99 C_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${library} PUBLIC ${folder}/c)
  if(UNIX)
    target_link_libraries(${library} PUBLIC m)
  endif()
endfunction()

# The target ${library}_code writes the sources into the folder ${library}; `reading`: options of the tool; `only`: parts, all
# of them if empty.
#
# Ninja compiles again what uses a declared output that has changed, and learns of other headers one build too late: a
# header that every user of the code reads is declared, and the tool makes it newer when anything has changed.
function(qvgen_generated_code library robot namespace reading language only)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${library})
  if(namespace)
    set(name ${namespace})
    set(naming --name ${namespace})
  else()
    qvgen_robot_name(name naming ${robot})
  endif()
  set(header ${folder}/include/qvgen/robots/${name}/model.h)
  if(language STREQUAL c)
    set(header ${folder}/c/qvgen_${name}.h)
  endif()
  set(description ${robot})
  set(depends "")
  if(robot MATCHES "[./]")
    get_filename_component(description ${robot} ABSOLUTE)
    set(depends ${description})
  endif()
  set(options ${naming} ${reading})
  if(only)
    list(JOIN only "," only)
    list(APPEND options --only ${only})
  endif()
  # The stamp is new whenever the tool has run; files that it leaves as they were are not compiled again.
  add_custom_command(
    OUTPUT ${folder}/stamp
    BYPRODUCTS ${ARGN} ${header}
    COMMAND qvgen::tool generate ${description} --output ${folder} --language ${language} ${options}
            --sources ${folder}/sources --depfile ${folder}/stamp.d --quiet
    COMMAND ${CMAKE_COMMAND} -E touch ${folder}/stamp
    DEPENDS ${depends} qvgen::tool
    DEPFILE ${folder}/stamp.d
    COMMENT "qvgen: ${robot}"
    VERBATIM)
  add_custom_target(${library}_code DEPENDS ${folder}/stamp)
endfunction()

# The name that the robot has in the generated code, and the options by which the tool gives it that name.
function(qvgen_robot_name name naming robot)
  get_filename_component(id ${robot} NAME_WE)
  set(options "")
  if(robot MATCHES "[./]")
    get_filename_component(description ${robot} ABSOLUTE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${description})
    set(text "")
    if(EXISTS ${description})
      file(READ ${description} text)
    endif()
    if(robot MATCHES "\\.toml$")
      if("\n${text}" MATCHES "\n[ \t]*name[ \t]*=[ \t]*[\"']([^\"'\n]*)[\"']")
        set(id ${CMAKE_MATCH_1})
      endif()
    else()
      if(text MATCHES "<(robot|mujoco)[^>]*[ \t\r\n](name|model)[ \t]*=[ \t]*[\"']([^\"']*)[\"']")
        set(id ${CMAKE_MATCH_3})
      endif()
      string(MAKE_C_IDENTIFIER "${id}" id)
      string(TOLOWER ${id} id)
      string(REGEX REPLACE "^_" "robot_" id ${id})
      set(options --name ${id})
    endif()
  endif()
  set(${name} ${id} PARENT_SCOPE)
  set(${naming} ${options} PARENT_SCOPE)
endfunction()
