# clast_library, clast_executable, clast_test, clast_benchmark: the only ways a target is made here.
include(GNUInstallDirs)

add_library(clast_options INTERFACE)
target_compile_features(clast_options INTERFACE cxx_std_20)
target_compile_options(clast_options INTERFACE
  # GCC 12 reports -Wrestrict falsely inside std::string.
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<BOOL:${CLAST_WERROR}>:-Werror>
  # Same bits everywhere: no fused multiply-add unless the source asks for it.
  -ffp-contract=off)

# clast_library(name HEADERS ... SOURCES ... [DETAIL ...] [PUBLIC ...] [PRIVATE ...])
# One static library for the folder it is called in, with alias clast::name. HEADERS are installed
# and each is checked to compile alone; DETAIL headers stay inside the project.
function(clast_library name)
  cmake_parse_arguments(ARG "" "" "HEADERS;SOURCES;DETAIL;PUBLIC;PRIVATE" ${ARGN})
  add_library(clast_${name} STATIC ${ARG_SOURCES} ${ARG_DETAIL})
  add_library(clast::${name} ALIAS clast_${name})
  target_sources(clast_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
                 FILES ${ARG_HEADERS})
  set_target_properties(clast_${name} PROPERTIES EXPORT_NAME ${name}
                        VERIFY_INTERFACE_HEADER_SETS ON POSITION_INDEPENDENT_CODE ON)
  target_compile_features(clast_${name} PUBLIC cxx_std_20)
  target_link_libraries(clast_${name} PUBLIC ${ARG_PUBLIC}
                        PRIVATE $<BUILD_INTERFACE:clast_options> ${ARG_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY CLAST_LIBRARIES clast_${name})
endfunction()

# clast_assets(result FILES...): a source that holds text files as string_views of the namespace
# clast::FOLDER_detail::assets, page.css as page_css, declared by hand in FOLDER/html/assets.hpp. It is
# made again when one of them changes; `result` is set to its path.
function(clast_assets result)
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE files)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/assets.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedAssets.cmake)
  add_custom_command(OUTPUT ${source} DEPENDS ${files} ${script} VERBATIM
    COMMAND ${CMAKE_COMMAND} -D folder=${folder} -D source=${source} "-D files=${files}" -P ${script})
  set(${result} ${source} PARENT_SCOPE)
endfunction()

# clast_executable(name SOURCES ... LINK ...): a program that is not a test.
function(clast_executable name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE clast_options ${ARG_LINK})
endfunction()

# clast_test(name LABEL label SOURCES ... LINK ... [LONG tests...] [TIMEOUT seconds] [WHOLE]): one
# GoogleTest program, each of its tests registered with ctest under the label, those of LONG under the
# label `long`; with WHOLE the program is one test, for suites whose tests share a costly set-up. Tests
# that may take longest start first, so that none is left over at the end.
function(clast_test name)
  cmake_parse_arguments(ARG "WHOLE" "LABEL;TIMEOUT" "SOURCES;LINK;LONG" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE clast_options ${ARG_LINK} GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE
    CLAST_SOURCE_DIR="${PROJECT_SOURCE_DIR}" CLAST_PROGRAM="$<TARGET_FILE:clast>")
  if(ARG_WHOLE)
    add_test(NAME ${ARG_LABEL}.${name} COMMAND ${name})
    set_tests_properties(${ARG_LABEL}.${name} PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT}
                          COST ${ARG_TIMEOUT})
    return()
  endif()
  list(JOIN ARG_LONG ":" long)
  set(others *)
  if(long)
    clast_discover(${name} long ${ARG_TIMEOUT} "${long}")
    set(others "-${long}")
  endif()
  clast_discover(${name} ${ARG_LABEL} ${ARG_TIMEOUT} "${others}")
endfunction()

# clast_discover(name label timeout filter): registers the tests of a program that pass a filter of
# GoogleTest.
function(clast_discover name label timeout filter)
  gtest_discover_tests(${name} TEST_PREFIX "${label}." TEST_FILTER "${filter}" DISCOVERY_TIMEOUT 60
                       PROPERTIES LABELS ${label} TIMEOUT ${timeout} COST ${timeout})
endfunction()

# clast_benchmark(name SOURCES ... LINK ...): one Google Benchmark program, run by hand.
function(clast_benchmark name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE clast_options ${ARG_LINK} benchmark::benchmark_main)
endfunction()
