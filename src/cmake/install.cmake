# Installs the command, the layers with their headers, the zone file's schema, and what
# find_package(pedzone) needs: targets pedzone::core ... pedzone::sumo.
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY PEDZONE_LAYERS)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pedzone)

install(TARGETS pedzone_flags ${layers} EXPORT pedzone
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET pedzone)
  install(TARGETS pedzone RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
# Headers keep their folders: #include "crowd/crowd.hpp" works inside and outside alike.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pedzone
        FILES_MATCHING PATTERN "*.hpp"
        PATTERN app EXCLUDE PATTERN cmake EXCLUDE PATTERN animation EXCLUDE PATTERN report EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/src/zone/zones.xsd
        DESTINATION ${CMAKE_INSTALL_DATADIR}/pedzone)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT pedzone NAMESPACE pedzone:: FILE pedzone-targets.cmake
        DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/src/cmake/pedzone-config.cmake.in
                              ${PROJECT_BINARY_DIR}/pedzone-config.cmake
                              INSTALL_DESTINATION ${package_dir})
# Before 1.0 a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pedzone-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pedzone-config.cmake
              ${PROJECT_BINARY_DIR}/pedzone-config-version.cmake
              ${PROJECT_SOURCE_DIR}/src/cmake/FindSUMO.cmake
        DESTINATION ${package_dir})
