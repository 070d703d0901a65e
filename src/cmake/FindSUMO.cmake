# Finds SUMO's two client libraries, which declare one API:
#   SUMO::libsumocpp   the simulation inside this process (header libsumo/libsumo.h)
#   SUMO::libtracicpp  a client of a running SUMO (header libsumo/libtraci.h)
# Components: libsumocpp, libtracicpp; without any, libsumocpp is required.
# Debian's package `sumo` brings no CMake config; the one in `sumo-tools` names no version and
# is not needed here. SUMO_ROOT, or SUMO_HOME in the environment, names another installation.

if(NOT SUMO_FIND_COMPONENTS)
  set(SUMO_FIND_COMPONENTS libsumocpp)
endif()

find_path(SUMO_INCLUDE_DIR libsumo/libsumo.h HINTS ENV SUMO_HOME PATH_SUFFIXES include src)
find_program(SUMO_EXECUTABLE sumo HINTS ENV SUMO_HOME PATH_SUFFIXES bin)
mark_as_advanced(SUMO_INCLUDE_DIR SUMO_EXECUTABLE)

foreach(component libsumocpp libtracicpp)
  string(REGEX REPLACE "^lib" "" name ${component})
  find_library(SUMO_${component}_LIBRARY NAMES ${name} ${component} HINTS ENV SUMO_HOME
               PATH_SUFFIXES lib lib64 bin)
  mark_as_advanced(SUMO_${component}_LIBRARY)
  if(SUMO_INCLUDE_DIR AND SUMO_${component}_LIBRARY)
    set(SUMO_${component}_FOUND TRUE)
    if(NOT TARGET SUMO::${component})
      add_library(SUMO::${component} UNKNOWN IMPORTED)
      set_target_properties(SUMO::${component} PROPERTIES
                            IMPORTED_LOCATION "${SUMO_${component}_LIBRARY}"
                            INTERFACE_INCLUDE_DIRECTORIES "${SUMO_INCLUDE_DIR}")
    endif()
  endif()
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(SUMO REQUIRED_VARS SUMO_INCLUDE_DIR HANDLE_COMPONENTS)
