# SPDX-License-Identifier: MIT
# cmake -DQVGEN=source -DBUILD=build -DWORK=folder -DGENERATOR=... -DCXX=... -DFLAGS=... -P folder.cmake: runtime/examples copied,
# built beside an installation and run, as a newcomer would.
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

file(REMOVE_RECURSE ${WORK})
foreach(component runtime robots tool)
  run("installing ${component}" ${CMAKE_COMMAND} --install ${BUILD} --component ${component} --prefix ${WORK}/prefix)
endforeach()
file(COPY ${QVGEN}/runtime/examples/ DESTINATION ${WORK}/copy)
# -O0, double alone and one instruction set less are the quickest to compile.
run("configuring" ${CMAKE_COMMAND} -S ${WORK}/copy -B ${WORK}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${CXX}
    "-DCMAKE_CXX_FLAGS=${FLAGS} -O0 -DQVGEN_NO_FLOAT -Wall -Wextra -Werror" "-DCMAKE_C_FLAGS=-O0 -Wall -Wextra -Werror" -DCMAKE_PREFIX_PATH=${WORK}/prefix -DQVGEN_WITHOUT_SETS=AVX512)
run("building" ${CMAKE_COMMAND} --build ${WORK}/build --parallel 2)
foreach(program control_loop planner_batch firmware)
  run("${program}" ${WORK}/build/${program})
  message(STATUS "${program}: ${output}")
endforeach()
