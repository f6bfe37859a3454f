# SPDX-License-Identifier: MIT
# cmake -DQVGEN=source -DBUILD=build -DWORK=folder -DGENERATOR=... -DCXX=... -P generate.cmake: the tool and the runtime are
# installed and moved; a project describes an arm, builds, changes it, and builds again.
cmake_minimum_required(VERSION 3.21)

include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

file(REMOVE_RECURSE ${WORK})
foreach(component runtime tool)
  run("installing ${component}" ${CMAKE_COMMAND} --install ${BUILD} --component ${component} --prefix ${WORK}/prefix)
endforeach()
file(RENAME ${WORK}/prefix ${WORK}/moved)
run("installing the runtime alone" ${CMAKE_COMMAND} --install ${BUILD} --component runtime --prefix ${WORK}/runtime)
set(tool ${WORK}/moved/bin/qvgen)
foreach(folder ${QVGEN} ${BUILD})
  execute_process(COMMAND grep -c -a -F ${folder} ${tool} OUTPUT_VARIABLE lines OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(lines GREATER 0)
    message(FATAL_ERROR "the installed tool mentions ${folder}")
  endif()
endforeach()
foreach(document man/man1/qvgen.1 bash-completion/completions/qvgen
        zsh/vendor-completions/_qvgen fish/vendor_completions.d/qvgen.fish)
  file(READ ${WORK}/moved/share/${document} text)
  if(NOT text MATCHES "singularities")
    message(FATAL_ERROR "share/${document} lacks an option")
  endif()
endforeach()
run("showing a known robot" ${tool} show ns)

file(COPY ${CMAKE_CURRENT_LIST_DIR}/generator/ DESTINATION ${WORK}/project)
file(COPY_FILE ${QVGEN}/tests/c/robots/urdf_arm.urdf ${WORK}/project/some-arm.urdf)
file(COPY_FILE ${QVGEN}/tests/loops/robots/four_bar.toml ${WORK}/project/four_bar.toml)
function(describe length)
  file(WRITE ${WORK}/project/my_arm.toml "name = \"my_arm\"\ntitle = \"two links\"\n
[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"theta1\"\nlimits = [-3, ${length}]
link = [${length}, 0, 0]\n
[[joint]]\ntype = \"revolute\"\naxis = \"+z\"\nvariable = \"theta2\"\nlink = [0.3, 0, 0]\n")
endfunction()
set(build ${CMAKE_COMMAND} --build ${WORK}/build --parallel 2)
describe(0.4)
set(where -DCMAKE_PREFIX_PATH=${WORK}/moved)
if(GENERATOR MATCHES "Makefiles")
  set(where -DQVGEN_FOLDER=${QVGEN} -DQVGEN_TOOL=${tool})
endif()
# Double alone is quicker to compile.
set(configure ${CMAKE_COMMAND} -S ${WORK}/project -G "${GENERATOR}" -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=-DQVGEN_NO_FLOAT)
run("configuring" ${configure} -B ${WORK}/build ${where})
run("building" ${build})
run("running" ${WORK}/build/own_arms 0.4)
run("running C" ${WORK}/build/own_arms_in_c 0.4)
run("running loops in C" ${WORK}/build/own_linkage_in_c)
if(GENERATOR STREQUAL Ninja)
  run("running loops" ${WORK}/build/own_linkage)
endif()
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

# Without a tool it is said what is missing; an installed runtime takes a tool from elsewhere.
execute_process(COMMAND ${configure} -B ${WORK}/no_tool -DQVGEN_FOLDER=${QVGEN} RESULT_VARIABLE result ERROR_VARIABLE output
                OUTPUT_QUIET)
if(result EQUAL 0 OR NOT output MATCHES "no tool that generates")
  message(FATAL_ERROR "a build without a tool does not say so:\n${output}")
endif()
run("configuring with a tool from elsewhere" ${configure} -B ${WORK}/elsewhere -DCMAKE_PREFIX_PATH=${WORK}/runtime -DQVGEN_TOOL=${tool})

# Fetched as sources: arms and linkages in C, which need no library. A project that compiles several files as one does not do so with C.
if(GENERATOR STREQUAL Ninja)
  run("configuring with sources" ${configure} -B ${WORK}/fetched -DCMAKE_UNITY_BUILD=ON -DQVGEN_FOLDER=${QVGEN} -DQVGEN_TOOL=${tool})
  run("building C with sources" ${CMAKE_COMMAND} --build ${WORK}/fetched --parallel 2 --target own_arms_in_c own_linkage_in_c)
  run("running C of sources" ${WORK}/fetched/own_arms_in_c 0.5)
  run("running loops in C of sources" ${WORK}/fetched/own_linkage_in_c)
endif()
