# The target `site`: the documentation as pages to read in a browser, build/.../site/html/index.html.
# It takes mkdocs, its theme material, pymdownx and MathJax 2 (Debian: mkdocs mkdocs-material
# python3-pymdownx libjs-mathjax), and Doxygen for the API of C++, without which that part is left out.
set(CLAST_SITE_PYTHON /usr/bin/python3 CACHE FILEPATH "Python that has mkdocs")
set(site_script ${PROJECT_SOURCE_DIR}/docs/site/make_site.py)
find_program(DOXYGEN_PROGRAM doxygen)
set(with_cpp)
if(DOXYGEN_PROGRAM)
  set(with_cpp --doxygen ${DOXYGEN_PROGRAM})
endif()
add_custom_target(site
  COMMAND ${CLAST_SITE_PYTHON} ${site_script} ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/site ${with_cpp}
  COMMENT "Documentation site" VERBATIM USES_TERMINAL)

if(CLAST_TESTS)
  add_test(NAME long.site_test
    COMMAND ${CLAST_SITE_PYTHON} -m pytest -q -rs -p no:cacheprovider site_test.py
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/docs/site)
  set_tests_properties(long.site_test PROPERTIES LABELS long TIMEOUT 120
    SKIP_REGULAR_EXPRESSION "SKIPPED.*(mkdocs|MathJax)"
    ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1;CLAST_PROGRAM=$<TARGET_FILE:clast>")
  add_test(NAME unit.speed_tables_test
    COMMAND ${CLAST_SITE_PYTHON} -m pytest -q -p no:cacheprovider speed_tables_test.py
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/docs/site)
  set_tests_properties(unit.speed_tables_test PROPERTIES LABELS unit TIMEOUT 60
    ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1")
  add_test(NAME validation.site.commands_of_the_pages_run
    COMMAND ${CLAST_SITE_PYTHON} -m pytest -q -rs -p no:cacheprovider commands_test.py
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/docs/site)
  set_tests_properties(validation.site.commands_of_the_pages_run PROPERTIES LABELS validation TIMEOUT 900
    ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1;CLAST_PROGRAM=$<TARGET_FILE:clast>")
endif()
