# The libraries of PCL that need neither VTK nor Qt, as the target pcl::core. PCL's own PCLConfig
# adds all of VTK to whatever is asked for; pcl_io and pcl_surface load it when they start.
find_path(PclCore_INCLUDE_DIR pcl/point_types.h PATH_SUFFIXES pcl-1.15 pcl-1.14 pcl-1.13 pcl-1.12)
if(PclCore_INCLUDE_DIR AND EXISTS ${PclCore_INCLUDE_DIR}/pcl/pcl_config.h)
  file(STRINGS ${PclCore_INCLUDE_DIR}/pcl/pcl_config.h version REGEX "define PCL_VERSION_PRETTY")
  string(REGEX MATCH "[0-9]+\\.[0-9]+(\\.[0-9]+)?" PclCore_VERSION "${version}")
endif()
set(libraries)
foreach(name common kdtree octree search sample_consensus filters features segmentation)
  find_library(PclCore_${name}_LIBRARY pcl_${name})
  list(APPEND libraries PclCore_${name}_LIBRARY)
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PclCore REQUIRED_VARS PclCore_INCLUDE_DIR ${libraries}
                                  VERSION_VAR PclCore_VERSION)
if(PclCore_FOUND AND NOT TARGET pcl::core)
  add_library(pcl::core INTERFACE IMPORTED)
  set_target_properties(pcl::core PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${PclCore_INCLUDE_DIR})
  foreach(library ${libraries})
    set_property(TARGET pcl::core APPEND PROPERTY INTERFACE_LINK_LIBRARIES ${${library}})
  endforeach()
endif()
