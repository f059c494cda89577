# Installed use: find_package(clast) and clast::dem, clast::massprops, ...
include(CMakePackageConfigHelpers)

get_property(clast_libraries GLOBAL PROPERTY CLAST_LIBRARIES)
install(TARGETS ${clast_libraries} EXPORT clastTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/clast COMPONENT dev)
# The program alone is the components program and reconstruct.
install(TARGETS clast RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(TARGETS clast-simulate RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/clast
        COMPONENT program)
install(TARGETS clast-reconstruct RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/clast
        COMPONENT reconstruct)
install(EXPORT clastTargets NAMESPACE clast:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/clast
        COMPONENT dev)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/clastConfig.cmake.in
  ${PROJECT_BINARY_DIR}/clastConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/clast)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/clastConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/clastConfig.cmake ${PROJECT_BINARY_DIR}/clastConfigVersion.cmake
        ${PROJECT_SOURCE_DIR}/cmake/FindPclCore.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/clast COMPONENT dev)
# The samples, with the command that runs them.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/samples DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/clast/examples
        COMPONENT program USE_SOURCE_PERMISSIONS
        PATTERN "*.cpp" EXCLUDE PATTERN "*.hpp" EXCLUDE PATTERN "CMakeLists.txt" EXCLUDE)
