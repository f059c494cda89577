# The module `clast`: CLAST_PYTHON is on where what it needs is found.
include(${PROJECT_SOURCE_DIR}/python/packages.cmake)
set(sanitized FALSE)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
  set(sanitized TRUE)  # the interpreter would have to load the sanitizer first
endif()
if(pybind11_FOUND AND NOT sanitized)
  set(found ON)
else()
  set(found OFF)
endif()
option(CLAST_PYTHON "Build the Python module (needs pybind11 and NumPy)" ${found})
if(CLAST_PYTHON AND NOT pybind11_FOUND)
  message(FATAL_ERROR "CLAST_PYTHON is on, but Python 3.9 or pybind11 2.10 with their headers were not "
                      "found; in Debian and Ubuntu they are in python3-dev, python3-numpy and "
                      "pybind11-dev. With -D CLAST_PYTHON=OFF clast is built without its module.")
elseif(NOT CLAST_PYTHON)
  message(STATUS "clast is built without its Python module; it needs python3-dev, python3-numpy and "
                 "pybind11-dev, and -D CLAST_PYTHON=ON")
endif()
