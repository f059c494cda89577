# run(program arguments...): ends the script where the program fails, with what it printed.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    # FATAL_ERROR would fold the lines of a compiler's message.
    message("${output}")
    message(FATAL_ERROR "Failed with ${status}: ${command}")
  endif()
endfunction()
