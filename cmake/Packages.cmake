# Debian packages: `cpack -G DEB` in a build folder writes clast (the program), clast-reconstruct (what
# `clast reconstruct` needs beyond it: PCL, OpenCV), libclast-dev and, where the module is built,
# python3-clast.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR clast)
# Whoever builds packages for others puts an address at which they can be reached.
set(CPACK_PACKAGE_CONTACT "clast developers <clast@localhost>" CACHE STRING "Maintainer of packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program reconstruct dev)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME clast)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Turns scans of rock blocks into sphero-polyhedra with exact mass
 properties and shape classes, releases them on surveyed terrain in a
 discrete element simulation, and compares shape classes.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libjs-three, python3-plotly")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS clast-reconstruct)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS chromium)  # compare --pdf

set(CPACK_DEBIAN_RECONSTRUCT_PACKAGE_NAME clast-reconstruct)
set(CPACK_COMPONENT_RECONSTRUCT_DESCRIPTION "This part turns meshes, point clouds and photographs into closed,
 scaled and simplified blocks (clast reconstruct).")
set(CPACK_DEBIAN_RECONSTRUCT_PACKAGE_DEPENDS "clast (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_RECONSTRUCT_PACKAGE_RECOMMENDS colmap)  # photographs

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libclast-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_DEV_DESCRIPTION "This part is for C++ programs: headers, static libraries and CMake
 configuration, for find_package(clast).")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "libeigen3-dev, libboost-dev, libcgal-dev, libassimp-dev, libhdf5-dev, libgdal-dev, libpcl-dev, \
libopencv-dev, libpugixml-dev, libssl-dev, libpng-dev, libtomlplusplus-dev, nlohmann-json3-dev")
if(MPI_CXX_FOUND)
  string(APPEND CPACK_DEBIAN_DEV_PACKAGE_DEPENDS ", libopenmpi-dev")
endif()

set(package_parts program reconstruct dev)
if(CLAST_PYTHON)
  list(APPEND package_parts python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-clast)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "This part is the Python module: import clast.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, python3-numpy, libjs-three, python3-plotly")
endif()

# What every Debian package has in its documentation folder.
configure_file(${CMAKE_CURRENT_LIST_DIR}/packages/copyright ${PROJECT_BINARY_DIR}/packages/copyright COPYONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/packages/changelog.in ${PROJECT_BINARY_DIR}/packages/changelog @ONLY)
find_program(GZIP_PROGRAM gzip)
if(GZIP_PROGRAM)
  execute_process(COMMAND ${GZIP_PROGRAM} -9nf ${PROJECT_BINARY_DIR}/packages/changelog)
endif()
foreach(part IN LISTS package_parts)
  string(TOUPPER ${part} name)
  install(FILES ${PROJECT_BINARY_DIR}/packages/copyright ${PROJECT_BINARY_DIR}/packages/changelog.gz
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${name}_PACKAGE_NAME}
          COMPONENT ${part} OPTIONAL)
endforeach()
include(CPack)
