# Installs the build into a scratch folder; then the example of the documents is configured, built
# and run against it.
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

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
# The libraries are large; a passed test leaves nothing behind.
file(REMOVE_RECURSE ${scratch})
