# The module `clast`. AUTO is decided anew by every configuration: what a later one finds is used.
include(${PROJECT_SOURCE_DIR}/python/packages.cmake)
set(sanitized FALSE)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(sanitized TRUE)  # the interpreter would have to load the sanitizer first
endif()
set(CLAST_PYTHON AUTO CACHE STRING
    "Build the Python module: ON, OFF, or AUTO, which is ON where pybind11 and NumPy are found")
set_property(CACHE CLAST_PYTHON PROPERTY STRINGS AUTO ON OFF)
if(CLAST_PYTHON STREQUAL AUTO)
  if(pybind11_FOUND AND NOT sanitized)
    set(CLAST_PYTHON ON)
  else()
    set(CLAST_PYTHON OFF)
  endif()
endif()
if(CLAST_PYTHON AND NOT pybind11_FOUND)
  message(FATAL_ERROR "CLAST_PYTHON is on, but Python 3.9 or pybind11 2.10 with their headers were not "
                      "found; in Debian and Ubuntu they are in python3-dev, python3-numpy and "
                      "pybind11-dev. With -D CLAST_PYTHON=OFF clast is built without its module.")
elseif(NOT CLAST_PYTHON)
  message(STATUS "clast is built without its Python module; it needs python3-dev, python3-numpy and "
                 "pybind11-dev")
endif()
