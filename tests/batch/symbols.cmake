# SPDX-License-Identifier: MIT
# Every symbol of OBJECTS that other files' may be merged with has an instruction set in its name.
foreach(object ${OBJECTS})
  execute_process(COMMAND ${NM} -C --defined-only ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+ [WVuw] [^\n]+" weak "${symbols}")
  list(LENGTH weak count)
  if(count EQUAL 0)
    message(FATAL_ERROR "${object}: no template instances; is this a batch?")
  endif()
  list(FILTER weak EXCLUDE REGEX "qvgen::simd::Avx")
  if(weak)
    message(FATAL_ERROR "${object}: ${weak}")
  endif()
endforeach()
