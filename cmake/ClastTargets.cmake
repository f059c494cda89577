# clast_library, clast_executable, clast_test, clast_benchmark: the only ways a target is made here.
include(GNUInstallDirs)

option(CLAST_COMPILE_TOGETHER "Compile several files of a target as one, in a third of the time" ON)
set(CLAST_FILES_TOGETHER 20)

add_library(clast_options INTERFACE)
target_compile_features(clast_options INTERFACE cxx_std_20)
target_compile_options(clast_options INTERFACE
  # GCC 12 reports -Wrestrict falsely inside std::string.
  # A name of one file may be shadowed in another that is compiled with it.
  -Wall -Wextra -Wpedantic -Wnon-virtual-dtor $<$<NOT:$<BOOL:${CLAST_COMPILE_TOGETHER}>>:-Wshadow>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<BOOL:${CLAST_WERROR}>:-Werror>
  # Same bits everywhere: no fused multiply-add unless the source asks for it.
  -ffp-contract=off)

# clast_compile_together(target): compiles the files of a target twenty at a time. A file that includes
# CGAL or PCL is compiled alone, because it takes up to 2.4 GB of memory, unless clast_group names it.
function(clast_compile_together target)
  if(NOT CLAST_COMPILE_TOGETHER)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  set(count 0)
  foreach(source ${sources})
    get_source_file_property(group ${source} UNITY_GROUP)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE file)
    if(group OR NOT source MATCHES "\\.cpp$" OR NOT EXISTS ${file})
      continue()
    endif()
    file(STRINGS ${file} heavy REGEX "#include <(CGAL|pcl)/" LIMIT_COUNT 1)
    if(NOT heavy)
      math(EXPR group "${count} / ${CLAST_FILES_TOGETHER}")
      math(EXPR count "${count} + 1")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${target}_${group})
    endif()
  endforeach()
endfunction()

# clast_compile_apart(group sources...): compiles sources of the library that is defined next together
# with each other, and not with its other sources.
function(clast_compile_apart group)
  set(count 0)
  foreach(source IN LISTS ARGN)
    math(EXPR part "${count} / ${CLAST_FILES_TOGETHER}")
    math(EXPR count "${count} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group}_${part})
  endforeach()
endfunction()

# clast_optimise(target level): the level of optimisation of a release.
function(clast_optimise target level)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O${level}>)
endfunction()

# clast_group(name files...): compiles files together that instantiate the same templates of CGAL.
function(clast_group name)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${name})
endfunction()

# clast_library(name [HOT] HEADERS ... SOURCES ... [DETAIL ...] [PUBLIC ...] [PRIVATE ...])
# One static library for the folder it is called in, with alias clast::name. HEADERS are installed
# and each is checked to compile alone; DETAIL headers stay inside the project. HOT: the loops of the
# library are what users wait for, and a release compiles them with -O3; -O2 does for the rest.
function(clast_library name)
  cmake_parse_arguments(ARG "HOT" "" "HEADERS;SOURCES;DETAIL;PUBLIC;PRIVATE" ${ARGN})
  add_library(clast_${name} STATIC ${ARG_SOURCES} ${ARG_DETAIL})
  add_library(clast::${name} ALIAS clast_${name})
  target_sources(clast_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
                 FILES ${ARG_HEADERS})
  set_target_properties(clast_${name} PROPERTIES EXPORT_NAME ${name}
                        VERIFY_INTERFACE_HEADER_SETS ON POSITION_INDEPENDENT_CODE ON)
  target_compile_features(clast_${name} PUBLIC cxx_std_20)
  target_link_libraries(clast_${name} PUBLIC ${ARG_PUBLIC}
                        PRIVATE $<BUILD_INTERFACE:clast_options> ${ARG_PRIVATE})
  if(NOT ARG_HOT)
    clast_optimise(clast_${name} 2)
  endif()
  clast_compile_together(clast_${name})
  set_property(GLOBAL APPEND PROPERTY CLAST_LIBRARIES clast_${name})
endfunction()

# clast_assets(result HEADER FILES...): a source that holds text files as string_views of the namespace
# clast::FOLDER_detail::assets, page.css as page_css, declared by hand in FOLDER/HEADER. It is made
# again when one of them changes; `result` is set to its path.
function(clast_assets result header)
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE files)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/assets.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedAssets.cmake)
  add_custom_command(OUTPUT ${source} DEPENDS ${files} ${script} VERBATIM
    COMMAND ${CMAKE_COMMAND} -D folder=${folder} -D header=${folder}/${header} -D source=${source} "-D files=${files}" -P ${script})
  set(${result} ${source} PARENT_SCOPE)
endfunction()

# clast_executable(name SOURCES ... LINK ...): a program that is not a test.
function(clast_executable name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE clast_options ${ARG_LINK})
  clast_optimise(${name} 2)
endfunction()

# clast_test(name LABEL label SOURCES ... LINK ... [LONG tests...] [SLOW tests...] [WHOLE suites...]
# [TIMEOUT seconds]): the GoogleTest program of a folder for one label. Each test is registered with
# ctest under the label, those of LONG under `long` and those of SLOW under `slow`; a suite of WHOLE
# is one test, because its tests share a costly set-up. Tests that may take longest start first, so
# that none is left over at the end. Programs of the label `slow` are built by the target slow_tests.
function(clast_test name)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;LINK;LONG;SLOW;WHOLE" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE clast_options ${ARG_LINK} GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE
    CLAST_SOURCE_DIR="${PROJECT_SOURCE_DIR}" CLAST_PROGRAM="$<TARGET_FILE:clast>")
  clast_optimise(${name} 1)
  clast_compile_together(${name})
  if(ARG_LABEL STREQUAL slow)
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_dependencies(slow_tests ${name})
  endif()
  foreach(suite ${ARG_WHOLE})
    clast_add_test(${name} ${ARG_LABEL} ${suite} ${ARG_TIMEOUT} "${suite}.*")
  endforeach()
  foreach(label long slow)
    string(TOUPPER ${label} tests)
    if(ARG_${tests})
      list(JOIN ARG_${tests} ":" filter)
      clast_discover(${name} ${label} ${ARG_TIMEOUT} "${filter}")
    endif()
  endforeach()
  list(TRANSFORM ARG_WHOLE APPEND ".*")
  set(others ${ARG_LONG} ${ARG_SLOW} ${ARG_WHOLE})
  list(JOIN others ":" others)
  clast_discover(${name} ${ARG_LABEL} ${ARG_TIMEOUT} "-${others}")
endfunction()

# clast_add_test(program label name timeout filter [variables...]): the tests of a program that pass a
# filter of GoogleTest as one test, with environment variables such as CLAST_FUZZ_FILES=500.
function(clast_add_test program label name timeout filter)
  add_test(NAME ${label}.${name} COMMAND ${program} "--gtest_filter=${filter}")
  set_tests_properties(${label}.${name} PROPERTIES LABELS ${label} TIMEOUT ${timeout} COST ${timeout}
                       ENVIRONMENT "${ARGN}")
endfunction()

# clast_discover(program label timeout filter): registers the tests of a program that pass a filter
# of GoogleTest.
function(clast_discover program label timeout filter)
  gtest_discover_tests(${program} TEST_PREFIX "${label}." TEST_FILTER "${filter}" DISCOVERY_TIMEOUT 60
                       TEST_LIST ${program}_${label} PROPERTIES LABELS ${label} TIMEOUT ${timeout} COST ${timeout})
endfunction()

# clast_benchmark(name SOURCES ... LINK ...): one Google Benchmark program, run by hand.
function(clast_benchmark name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE clast_options ${ARG_LINK} benchmark::benchmark_main)
endfunction()
