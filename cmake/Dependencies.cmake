# Every package clast uses, found once. Versions are the oldest that were tried.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED CONFIG)
find_package(assimp 5.2 REQUIRED CONFIG)
find_package(Boost 1.74 REQUIRED)  # headers; CGAL needs them too
find_package(CGAL 5.5 REQUIRED CONFIG)
find_package(PclCore 1.12 REQUIRED)
find_package(GDAL 3.6 REQUIRED CONFIG)
find_package(PROJ 9.1 REQUIRED CONFIG)  # GDAL loads it
find_package(CLI11 2.1 REQUIRED CONFIG)
find_package(tomlplusplus 3.3 REQUIRED CONFIG)
find_package(nlohmann_json 3.11 REQUIRED CONFIG)
find_package(pugixml 1.11 REQUIRED CONFIG)
# Markers are a module of their own up to 4.6, and in objdetect since 4.7.
find_package(OpenCV 4.5 REQUIRED CONFIG COMPONENTS core imgproc imgcodecs calib3d
             OPTIONAL_COMPONENTS aruco objdetect)
if(OpenCV_VERSION VERSION_LESS 4.7)
  set(CLAST_MARKER_MODULE opencv_aruco)
else()
  set(CLAST_MARKER_MODULE opencv_objdetect)
endif()
if(NOT TARGET ${CLAST_MARKER_MODULE})
  message(FATAL_ERROR "OpenCV lacks ${CLAST_MARKER_MODULE}, which finds markers in photographs; "
                      "in Debian and Ubuntu it is in libopencv-dev.")
endif()
# Without MPI a campaign runs on one machine, or as shards that are merged.
option(CLAST_MPI "Run campaigns under mpirun, where MPI is installed" ON)
set(MPI_CXX_FOUND FALSE)
if(CLAST_MPI)
  find_package(MPI 3.0 COMPONENTS CXX)
endif()
# The serial library, even where an MPI flavour is installed beside it.
set(HDF5_PREFER_PARALLEL FALSE)
find_package(HDF5 1.10 REQUIRED COMPONENTS C)
find_package(OpenSSL 3.0 REQUIRED COMPONENTS Crypto)
find_package(PNG 1.6 REQUIRED)  # GDAL and OpenCV load it
find_package(ZLIB 1.2 REQUIRED)  # comes with HDF5
if(HDF5_IS_PARALLEL)
  message(FATAL_ERROR "CMake found the MPI build of HDF5; clast needs the serial one (libhdf5-dev).")
endif()
