# Half of the time to compile goes into headers of the standard library, Eigen and GoogleTest. The
# compiler reads them once for all files that have the same options (precompiled headers). A file
# still includes what it uses: with -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON each is read alone.

set(PEDZONE_COMMON_HEADERS
    <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <optional> <random>
    <set> <span> <string> <string_view> <unordered_map> <unordered_set> <vector> <Eigen/Core>)

# pedzone_read_once(NAME OPTIONS option... LINKS target... HEADERS header...)
# What `target_precompile_headers(TARGET REUSE_FROM NAME)` then takes from there.
function(pedzone_read_once name)
  cmake_parse_arguments(ONCE "" "" "OPTIONS;LINKS;HEADERS" ${ARGN})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// Has the headers compiled.\n")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE pedzone_flags Eigen3::Eigen ${ONCE_LINKS})
  target_compile_options(${name} PRIVATE ${PEDZONE_WARNINGS} ${ONCE_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${PEDZONE_COMMON_HEADERS} ${ONCE_HEADERS})
endfunction()
