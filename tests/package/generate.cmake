# SPDX-License-Identifier: MIT
# cmake -DQVGEN=source -DBUILD=build -DWORK=folder -DGENERATOR=... -DCXX=... -P generate.cmake: the tool and the runtime are
# installed and moved; a project describes an arm, builds, changes it, and builds again.
cmake_minimum_required(VERSION 3.21)

function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
foreach(component runtime tool)
  run("installing ${component}" ${CMAKE_COMMAND} --install ${BUILD} --component ${component} --prefix ${WORK}/prefix)
endforeach()
file(RENAME ${WORK}/prefix ${WORK}/moved)
set(tool ${WORK}/moved/bin/qvgen)
foreach(folder ${QVGEN} ${BUILD})
  execute_process(COMMAND grep -c -a -F ${folder} ${tool} OUTPUT_VARIABLE lines OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(lines GREATER 0)
    message(FATAL_ERROR "the installed tool mentions ${folder}")
  endif()
endforeach()
run("showing a known robot" ${tool} show ns)

file(COPY ${CMAKE_CURRENT_LIST_DIR}/generator/ DESTINATION ${WORK}/project)
file(COPY_FILE ${QVGEN}/tests/c/robots/urdf_arm.urdf ${WORK}/project/some-arm.urdf)
function(describe length)
  file(WRITE ${WORK}/project/my_arm.toml "name = \"my_arm\"\ntitle = \"two links\"\n
[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"theta1\"\nlimits = [-3, ${length}]
link = [${length}, 0, 0]\n
[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"theta2\"\nlink = [0.3, 0, 0]\n")
endfunction()
set(build ${CMAKE_COMMAND} --build ${WORK}/build --parallel 2)
describe(0.4)
run("configuring" ${CMAKE_COMMAND} -S ${WORK}/project -B ${WORK}/build -G "${GENERATOR}" -DCMAKE_CXX_COMPILER=${CXX}
    -DCMAKE_PREFIX_PATH=${WORK}/moved)
run("building" ${build})
run("running" ${WORK}/build/own_arms 0.4)
run("running C" ${WORK}/build/own_arms_in_c 0.4)
run("building what has not changed" ${build})
if(output MATCHES "qvgen: |Building C")
  message(FATAL_ERROR "something was made anew though nothing has changed:\n${output}")
endif()
describe(0.5)
run("building what has changed" ${build})
if(NOT output MATCHES "qvgen: my_arm.toml" OR output MATCHES "qvgen: rr_planar")
  message(FATAL_ERROR "not what has changed was made anew:\n${output}")
endif()
run("running again" ${WORK}/build/own_arms 0.5)
run("running C again" ${WORK}/build/own_arms_in_c 0.5)
