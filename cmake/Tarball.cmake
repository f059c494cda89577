# The target `tarball`: the program with its libraries and data, for systems without clast's packages.
# It takes patchelf and the data of GDAL and PROJ.
find_path(CLAST_GDAL_FOLDER gdalvrt.xsd PATHS /usr/share PATH_SUFFIXES gdal DOC "Data of GDAL, for the tarball")
find_path(CLAST_PROJ_FOLDER proj.db PATHS /usr/share PATH_SUFFIXES proj DOC "Data of PROJ, for the tarball")
add_custom_target(tarball
  COMMAND ${PROJECT_SOURCE_DIR}/cmake/packages/tarball.sh ${PROJECT_BINARY_DIR} ${PROJECT_VERSION}
          ${CLAST_GDAL_FOLDER} ${CLAST_PROJ_FOLDER} ${CLAST_THREE_FOLDER} ${CLAST_PLOTLY_FOLDER}
  DEPENDS clast clast-simulate clast-reconstruct help_files
  COMMENT "Tarball" VERBATIM USES_TERMINAL)
