# Installs the libraries into a scratch folder, and builds and imports the Python module on them.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE ${scratch})
run(${CMAKE_COMMAND} --install ${build} --prefix ${scratch}/prefix --component dev)
file(COPY ${source}/python DESTINATION ${scratch})
run(${CMAKE_COMMAND} -S ${scratch}/python -B ${scratch}/build -G ${generator}
    -D CMAKE_PREFIX_PATH=${scratch}/prefix -D Python_EXECUTABLE=${python}
    -D CMAKE_CXX_COMPILER=${compiler} "-D CMAKE_CXX_FLAGS=${flags}"
    -D CMAKE_CXX_COMPILER_LAUNCHER=${launcher})
run(${CMAKE_COMMAND} --build ${scratch}/build --parallel 2)
run(${CMAKE_COMMAND} --install ${scratch}/build --prefix ${scratch}/installed)
# What is imported must be what was installed, and do what the module of the build folder does.
set(script "import sys, clast
assert clast.__file__.startswith(sys.argv[1]), clast.__file__
block = clast.reconstruct(sys.argv[2], density=2650.0, vertices=40)
print(clast.__version__, block.mass.hex(), block.inertia.tobytes().hex(), block.to_dict())
")
function(ask result place)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${place} PYTHONDONTWRITEBYTECODE=1
      ${python} -X dev -W error -c "${script}" ${place} ${source}/samples/blocks/B04_elongated.ply
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "the module in ${place} failed: ${error}")
  endif()
  set(${result} "${output}" PARENT_SCOPE)
endfunction()
ask(installed ${scratch}/installed/lib/python3/dist-packages)
ask(built ${build}/python)
if(NOT installed STREQUAL built)
  message(FATAL_ERROR "both modules should say the same:\n${installed}${built}")
endif()
# The libraries are large; a passed test leaves nothing behind.
file(REMOVE_RECURSE ${scratch})
