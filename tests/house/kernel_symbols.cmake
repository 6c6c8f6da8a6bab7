# SPDX-License-Identifier: MIT
# A kernel is compiled for machines that others are not. A function that it shares with other files
# could become the copy that everybody calls: its object files must define none.
foreach(object IN LISTS OBJECTS)
  execute_process(COMMAND ${NM} --defined-only ${object} OUTPUT_VARIABLE symbols
                  COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[0-9a-f]+ W [^\n]+" shared "${symbols}")
  if(shared)
    message(FATAL_ERROR "${object} shares functions with other files:\n${shared}")
  endif()
endforeach()
