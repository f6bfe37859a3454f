# SPDX-License-Identifier: MIT
# How generated code is compiled, wherever it was generated: qvgen_robot(TARGET INCLUDE folder SOURCES a.cpp...
# [PRECOMPILED target] [NEEDS library...]) makes a static library of one robot, which links the libraries of the runtime that
# it needs: all without NEEDS.
#
# Inverse kinematics rounds products and sums one by one, so that it gives the same bits whatever the machine; it is a
# library of its own, since GCC takes that option from a precompiled header, whatever the command says. The vector forms
# are called only where the machine has AVX2; they see no Eigen, whose layouts change with it.
#
# Batches are compiled once for each instruction set, as libraries of their own, chosen at run time. Their functions are
# whole there: what they include leaves nothing behind that another file's code could be taken for.
include_guard(GLOBAL)

# qvgen_avx2_options(variable): GCC 12 copies what lanes are made of in halves of a register, and whoever then reads a whole
# one waits for both.
function(qvgen_avx2_options variable)
  set(options -mavx2)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 12)
    list(APPEND options -mmove-max=256)
  endif()
  set(${variable} ${options} PARENT_SCOPE)
endfunction()

# qvgen_light(TARGET): with QVGEN_LIGHT a robot's functions are optimised lightly, which takes two thirds of the time to
# compile. Inverse kinematics has the same bits: products and sums are rounded one by one, in the order in which they are written.
function(qvgen_light target)
  if(QVGEN_LIGHT AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# qvgen_scalars(TARGET): with QVGEN_LIGHT functions are compiled for double alone, which takes a quarter to a third less, unless
# QVGEN_IN_FLOAT is set.
function(qvgen_scalars target)
  if(QVGEN_LIGHT AND NOT QVGEN_IN_FLOAT)
    target_compile_definitions(${target} PRIVATE QVGEN_NO_FLOAT)
  endif()
endfunction()

# qvgen_robot_headers(variable NAME): makes one precompiled header for robots, NAME, and one for their inverse kinematics,
# NAME_inverse: both are what qvgen_robot takes as PRECOMPILED.
function(qvgen_robot_headers variable name)
  set(targets ${name} ${name}_inverse)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp CONTENT "// Nothing but the header.\n")
  foreach(target ${targets})
    add_library(${target} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp)
    target_link_libraries(${target} PRIVATE qvgen::core)
    target_compile_features(${target} PRIVATE cxx_std_17)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
      target_compile_options(${target} PRIVATE -fno-math-errno)
    endif()
    qvgen_light(${target})
    target_precompile_headers(${target} PRIVATE <Eigen/Geometry> <array> <cmath> <limits>)
  endforeach()
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${name}_inverse PRIVATE -ffp-contract=off -DQVGEN_NO_CONTRACTION)
  endif()
  set(${variable} ${targets} PARENT_SCOPE)
endfunction()

# qvgen_libraries_of(variable FILES file...): the libraries of the runtime that generated files include headers of. They are read
# again when one of them changes.
function(qvgen_libraries_of variable)
  cmake_parse_arguments(PARSE_ARGV 1 of "" "" "FILES")
  set(libraries qvgen::core)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${of_FILES})
  foreach(file ${of_FILES})
    file(STRINGS ${file} includes REGEX "^#include <qvgen/")
    foreach(include ${includes})
      if(include MATCHES "<qvgen/inverse/(elimination|arm_angle|given_joint|nearest_pose|certified)")
        list(APPEND libraries qvgen::${CMAKE_MATCH_1})
      elseif(include MATCHES "<qvgen/(inverse|batch|map)/")
        list(APPEND libraries qvgen::${CMAKE_MATCH_1})
      endif()
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES libraries)
  set(${variable} ${libraries} PARENT_SCOPE)
endfunction()

function(qvgen_robot target)
  cmake_parse_arguments(PARSE_ARGV 1 robot "" "INCLUDE" "SOURCES;PRECOMPILED;NEEDS")
  if(NOT robot_NEEDS)
    set(robot_NEEDS qvgen::runtime)
  endif()
  set(inverse_sources ${robot_SOURCES})
  list(FILTER inverse_sources INCLUDE REGEX "/inverse\\.cpp$")
  set(vector_sources ${robot_SOURCES})
  list(FILTER vector_sources INCLUDE REGEX "_avx2\\.cpp$")
  set(batch_sources ${robot_SOURCES})
  list(FILTER batch_sources INCLUDE REGEX "/(batch|batch_derivatives|inverse_batch)\\.cpp$")
  list(FILTER robot_SOURCES EXCLUDE REGEX "/(inverse|batch|batch_derivatives|inverse_batch)\\.cpp$")

  set(knows_gcc_options FALSE)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    set(knows_gcc_options TRUE)
  endif()
  if(vector_sources)
    set_source_files_properties(${vector_sources} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    if(knows_gcc_options AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
      qvgen_avx2_options(avx2)
      set_source_files_properties(${vector_sources} PROPERTIES
                                  COMPILE_OPTIONS "${avx2};-ffp-contract=off;-DQVGEN_NO_CONTRACTION")
    endif()
  endif()

  add_library(${target} STATIC ${robot_SOURCES})
  if(QVGEN_LIGHT)  # what a robot's files have in common takes longer than the rest
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
  qvgen_scalars(${target})
  set(libraries ${target})
  if(inverse_sources)
    add_library(${target}_inverse OBJECT ${inverse_sources})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_inverse>)
    target_include_directories(${target}_inverse PRIVATE ${robot_INCLUDE})
    target_link_libraries(${target}_inverse PRIVATE ${robot_NEEDS})
    if(knows_gcc_options)
      target_compile_options(${target}_inverse PRIVATE -ffp-contract=off -DQVGEN_NO_CONTRACTION)
    endif()
    list(APPEND libraries ${target}_inverse)
  endif()
  if(batch_sources)
    qvgen_robot_batch(${target} ${robot_INCLUDE} "${robot_NEEDS}" ${batch_sources})
  endif()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${robot_INCLUDE}>)
  target_link_libraries(${target} PUBLIC ${robot_NEEDS})
  foreach(library ${libraries})
    set_target_properties(${library} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_features(${library} PRIVATE cxx_std_17)
    qvgen_light(${library})
    if(knows_gcc_options)
      target_compile_options(${library} PRIVATE -fno-math-errno)  # a square root is one instruction
    endif()
  endforeach()
  # Reading Eigen takes longer than compiling a robot.
  if(robot_PRECOMPILED)
    list(GET robot_PRECOMPILED 0 plain)
    list(GET robot_PRECOMPILED 1 without_contraction)
    target_precompile_headers(${target} REUSE_FROM ${plain})
    if(inverse_sources)
      target_precompile_headers(${target}_inverse REUSE_FROM ${without_contraction})
    endif()
  endif()
endfunction()

# Adds the objects of sources of batches to the library: for the baseline, which chooses, and for what else the compiler
# knows, but for the sets in QVGEN_WITHOUT_SETS.
function(qvgen_robot_batch target include needs)
  set(known_sets "")
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
    set(known_sets AVX2 AVX512)
  elseif(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
    set(known_sets NEON)
  endif()
  if(QVGEN_WITHOUT_SETS)
    list(REMOVE_ITEM known_sets ${QVGEN_WITHOUT_SETS})
  endif()
  qvgen_avx2_options(options_AVX2)
  list(APPEND options_AVX2 -mfma)
  set(options_AVX512 -mavx2 -mfma -mavx512f -mavx512dq -mavx512vl)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # There are more numbers than registers: in a better order fewer of them wait in memory. Derivatives and regressors,
    # the longest functions, lose by it.
    foreach(source ${ARGN})
      if(source MATCHES "/batch\\.cpp$")
        set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "-fschedule-insns;-fsched-pressure")
      elseif(source MATCHES "/inverse_batch\\.cpp$")
        set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "-fno-tree-pre;-fschedule-insns;-fsched-pressure")
      endif()
    endforeach()
  endif()
  foreach(set "" ${known_sets})
    if(set)
      set(library ${target}_batch_${set})
      set(definitions QVGEN_BATCH_${set})
    else()
      set(library ${target}_batch)
      list(TRANSFORM known_sets PREPEND QVGEN_BATCH_HAS_ OUTPUT_VARIABLE definitions)
    endif()
    add_library(${library} OBJECT ${ARGN})
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${library}>)
    target_include_directories(${library} PRIVATE ${include})
    target_link_libraries(${library} PRIVATE ${needs})
    target_compile_features(${library} PRIVATE cxx_std_17)
    target_compile_definitions(${library} PRIVATE ${definitions} EIGEN_NO_DEBUG)
    qvgen_scalars(${library})
    set_target_properties(${library} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
      # Without optimisation functions are not whole; beyond -O2 they grow without getting faster.
      target_compile_options(${library} PRIVATE ${options_${set}} -O2 -ffp-contract=off -fno-math-errno)
    endif()
  endforeach()
endfunction()
