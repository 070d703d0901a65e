# `cpack` in the build folder makes a Debian package of what `cmake --install` installs, with examples.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "pedzone")
set(CPACK_PACKAGE_CONTACT "pedzone maintainers <maintainers@pedzone.example>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The program `sumo`, and the schemas by which it reads files; what pictures become PNG with.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "sumo, sumo-tools")
if(TARGET pedzone_python)
  # An extension is for one Python only.
  get_property(python_minor GLOBAL PROPERTY PEDZONE_PYTHON_MINOR)
  math(EXPR next_minor "${python_minor} + 1")
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS
         ", python3 (>= 3.${python_minor}~), python3 (<< 3.${next_minor}), python3-numpy")
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "librsvg2-bin")
# For films; for the plots of an example; for programs that are built with the layers:
# find_package(pedzone).
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
    "chromium, ffmpeg, python3-matplotlib, cmake, libeigen3-dev, libboost-dev, libtbb-dev, libsumo-dev")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Inside shared-space zones pedzone takes over the persons of the traffic\n\
simulation Eclipse SUMO and walks them among each other and vehicles. It\n\
compares walking models in studies, with confidence intervals and pictures.")

# What Debian asks of every package.
set(documents ${PROJECT_BINARY_DIR}/package)
file(WRITE ${documents}/copyright
     "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n\
Upstream-Name: pedzone\n\nFiles: *\nCopyright: 2026 the authors of pedzone\nLicense: EPL-2.0\n\
 The text of the Eclipse Public License 2.0 is in /usr/share/doc/pedzone/LICENSE.\n")
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${documents}/changelog
     "pedzone (${PROJECT_VERSION}) stable; urgency=medium\n\n  * Release.\n\n\
 -- ${CPACK_PACKAGE_CONTACT}  ${now}\n")
execute_process(COMMAND gzip --best --no-name --force --keep ${documents}/changelog)
install(FILES ${documents}/copyright ${documents}/changelog.gz
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/pedzone)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/networks ${PROJECT_SOURCE_DIR}/scenarios
        DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/pedzone/examples)
# Manual pages of Debian are compressed.
file(WRITE ${documents}/compress.cmake
     "file(GLOB pages \${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share/man/man1/*.1)\n\
execute_process(COMMAND gzip --best --no-name --force \${pages} COMMAND_ERROR_IS_FATAL ANY)\n")
set(CPACK_PRE_BUILD_SCRIPTS ${documents}/compress.cmake)
include(CPack)
