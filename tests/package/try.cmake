# SPDX-License-Identifier: MIT
# cmake -DWAY=find_package|add_subdirectory -DQVGEN=source -DWORK=folder -DGENERATOR=... -DCXX=... -P try.cmake

# run(WHAT command...): fails the test with the command's output.
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/no_packages)
# pkg-config that finds nothing: a machine without GiNaC and CLN.
set(ENV{PKG_CONFIG_LIBDIR} ${WORK}/no_packages)
set(ENV{PKG_CONFIG_PATH} "")

set(common -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CXX}
           -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})

if(WAY STREQUAL "find_package")
  # QVGEN_GENERATOR is not said: without GiNaC it has to be off by itself.
  run("configuring qvgen" ${CMAKE_COMMAND} -S ${QVGEN} -B ${WORK}/qvgen ${common} -DQVGEN_TESTS=OFF)
  run("building qvgen" ${CMAKE_COMMAND} --build ${WORK}/qvgen --parallel 2)
  run("installing qvgen" ${CMAKE_COMMAND} --install ${WORK}/qvgen --prefix ${WORK}/prefix)
  # An installation is moved about and must not remember where it was built.
  file(REMOVE_RECURSE ${WORK}/qvgen)
  file(RENAME ${WORK}/prefix ${WORK}/moved)
  list(APPEND common -DCMAKE_PREFIX_PATH=${WORK}/moved)
else()
  list(APPEND common -DQVGEN_FOLDER=${QVGEN})
endif()

run("configuring the consumer" ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${WORK}/consumer ${common})
run("building the consumer" ${CMAKE_COMMAND} --build ${WORK}/consumer --parallel 2 --verbose)
if(output MATCHES "ginac|lcln|-lgmp")
  message(FATAL_ERROR "the consumer's build mentions GiNaC or CLN:\n${output}")
endif()
run("running the consumer" ${WORK}/consumer/consumer)
message(STATUS "${output}")
