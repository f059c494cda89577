# Installs the build into a scratch folder; then the examples of the documents are configured, built
# and run against it.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

function(expect_output text)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  string(FIND "${output}" "${text}" found)
  if(found EQUAL -1)
    message(FATAL_ERROR "'${text}' was expected of ${ARGN}, which printed:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${scratch})
run(${CMAKE_COMMAND} --install ${build} --prefix ${scratch}/prefix)
run(${CMAKE_COMMAND} -S ${source}/docs/example -B ${scratch}/build -G ${generator}
    -D CMAKE_BUILD_TYPE=Release -D CMAKE_PREFIX_PATH=${scratch}/prefix
    -D CMAKE_CXX_COMPILER=${compiler} "-D CMAKE_CXX_FLAGS=${flags}"
    -D CMAKE_CXX_COMPILER_LAUNCHER=${launcher})
run(${CMAKE_COMMAND} --build ${scratch}/build)
file(READ ${source}/samples/campaign.toml campaign)
string(REPLACE "../out/blocks.h5" "out/blocks.h5" campaign "${campaign}")
string(REPLACE "terrain/quarry" "${source}/samples/terrain/quarry" campaign "${campaign}")
file(WRITE ${scratch}/campaign.toml "${campaign}")
run(${scratch}/build/scan_to_report ${source}/samples/blocks ${scratch}/campaign.toml
    ${scratch}/out)
foreach(file blocks.h5 results.h5 report/runs.csv report/report.html)
  if(NOT EXISTS ${scratch}/out/${file})
    message(FATAL_ERROR "the example did not write ${file}")
  endif()
endforeach()
file(STRINGS ${scratch}/out/report/runs.csv runs)
list(LENGTH runs lines)
if(NOT lines EQUAL 13)
  message(FATAL_ERROR "a heading and 12 runs were expected in runs.csv, there are ${lines} lines")
endif()
# A box of 2 m x 1 m x 0.5 m, whose mass properties are known.
file(WRITE ${scratch}/box.obj "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 0.5\nv 2 0 0.5\nv 2 1 0.5\nv 0 1 0.5\n"
     "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n")
expect_output("mass     2650 kg" ${scratch}/build/mass_properties ${scratch}/box.obj 2650)
expect_output("at rest after" ${scratch}/build/falling_blocks)
# The libraries are large; a passed test leaves nothing behind.
file(REMOVE_RECURSE ${scratch})
