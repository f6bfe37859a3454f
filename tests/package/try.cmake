# SPDX-License-Identifier: MIT
# cmake -DWAY=find_package|add_subdirectory -DQVGEN=source -DBUILD=build -DWORK=folder -DGENERATOR=... -DCXX=...
#       -DFLAGS=... -P try.cmake

include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/no_packages)
# pkg-config that finds nothing: a machine without GiNaC and CLN.
set(ENV{PKG_CONFIG_LIBDIR} ${WORK}/no_packages)
set(ENV{PKG_CONFIG_PATH} "")

find_program(ccache ccache)
if(ccache)
  set(ENV{CMAKE_CXX_COMPILER_LAUNCHER} ${ccache})
endif()
# The flags of the build, so that a library with sanitizers meets a consumer with them. -O1 and double alone are the quickest to compile.
set(common -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${FLAGS} -O1 -DQVGEN_NO_FLOAT")

if(WAY STREQUAL "find_package")
  run("installing qvgen" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
  # An installation may be moved, and must not remember where it was built.
  file(RENAME ${WORK}/prefix ${WORK}/moved)
  file(GLOB_RECURSE scripts ${WORK}/moved/*.cmake)
  foreach(script ${scripts})
    file(READ ${script} text)
    foreach(folder ${QVGEN} ${BUILD} ${WORK})
      string(FIND "${text}" ${folder} place)
      if(NOT place EQUAL -1)
        message(FATAL_ERROR "${script} mentions ${folder}")
      endif()
    endforeach()
  endforeach()
  list(APPEND common -DCMAKE_PREFIX_PATH=${WORK}/moved)
else()
  # QVGEN_GENERATOR is not said: without GiNaC it has to be off by itself.
  list(APPEND common -DQVGEN_FOLDER=${QVGEN})
endif()

run("configuring the consumer" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/consumer ${common})
run("building the consumer" ${CMAKE_COMMAND} --build ${WORK}/consumer --parallel 2 --verbose)
if(output MATCHES "ginac|lcln|-lgmp")
  message(FATAL_ERROR "the consumer's build mentions GiNaC or CLN:\n${output}")
endif()
run("running the consumer" ${WORK}/consumer/consumer)
message(STATUS "${output}")
