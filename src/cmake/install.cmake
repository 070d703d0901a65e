# Installs the command with its manual page and completion, the layers with their headers, the
# schemas of the zone file and of a run's summary, and what
# find_package(pedzone) needs: targets pedzone::core ... pedzone::sumo.
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY PEDZONE_LAYERS)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pedzone)

install(TARGETS pedzone_flags ${layers} EXPORT pedzone
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET pedzone)
  install(TARGETS pedzone RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(TARGETS pedzone_sumo_library LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/pedzone)
  # What the program prints of itself: the manual page, completion for shells.
  set(texts ${PROJECT_BINARY_DIR}/texts)
  file(MAKE_DIRECTORY ${texts})
  function(pedzone_text file destination)  # what follows: the words that have it printed
    add_custom_command(OUTPUT ${texts}/${file} COMMAND pedzone ${ARGN} > ${texts}/${file}
                       DEPENDS pedzone VERBATIM)
    install(FILES ${texts}/${file} DESTINATION ${destination})
  endfunction()
  pedzone_text(pedzone.1 ${CMAKE_INSTALL_MANDIR}/man1 man)
  pedzone_text(pedzone ${CMAKE_INSTALL_DATADIR}/bash-completion/completions completion bash)
  pedzone_text(_pedzone ${CMAKE_INSTALL_DATADIR}/zsh/site-functions completion zsh)
  add_custom_target(pedzone_texts ALL
                    DEPENDS ${texts}/pedzone.1 ${texts}/pedzone ${texts}/_pedzone)
endif()
# Headers keep their folders: #include "crowd/crowd.hpp" works inside and outside alike.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/pedzone
        FILES_MATCHING PATTERN "*.hpp"
        PATTERN app EXCLUDE PATTERN cmake EXCLUDE PATTERN animation EXCLUDE PATTERN report EXCLUDE
        PATTERN python EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/src/zone/zones.xsd
              ${PROJECT_SOURCE_DIR}/src/app/summary.schema.json
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
