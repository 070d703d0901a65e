# One library target a layer, so that the linker enforces who may use whom.

add_library(pedzone_flags INTERFACE)
set_target_properties(pedzone_flags PROPERTIES EXPORT_NAME flags)
target_compile_features(pedzone_flags INTERFACE cxx_std_20)
# Same bits on every build of one instruction set: no contraction of a*b+c behind our back.
target_compile_options(pedzone_flags INTERFACE -ffp-contract=off)
set(PEDZONE_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    -Wno-restrict)  # GCC 12 warns falsely about std::string + const char* (GCC bug 105651)
if(PEDZONE_WERROR)
  list(APPEND PEDZONE_WARNINGS -Werror)
endif()
# For what no run waits for, the command line and the tests: a fifth less time to compile.
set(PEDZONE_QUICK_BUILD $<$<CONFIG:Release>:-O1>)
if(PEDZONE_SANITIZE)
  # Instrumented code makes GCC 12 take std::optional for uninitialized.
  list(APPEND PEDZONE_WARNINGS -Wno-maybe-uninitialized)
  # Every finding ends the program with an error, so that a test sees it.
  add_compile_options(-fsanitize=${PEDZONE_SANITIZE} -fno-sanitize-recover=all
                      -fno-omit-frame-pointer -g1)  # lines only: a quarter less time to compile
  add_link_options(-fsanitize=${PEDZONE_SANITIZE})
endif()

# pedzone_layer(NAME SOURCES a.cpp ... DEPENDS targets... PRIVATE_DEPENDS targets...)
# DEPENDS appear in the layer's public headers, PRIVATE_DEPENDS only in its sources.
function(pedzone_layer name)
  cmake_parse_arguments(LAYER "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  set(target pedzone_${name})
  add_library(${target} STATIC ${LAYER_SOURCES})
  add_library(pedzone::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/pedzone>)
  target_compile_options(${target} PRIVATE ${PEDZONE_WARNINGS})
  target_link_libraries(${target} PUBLIC pedzone_flags ${LAYER_DEPENDS}
                        PRIVATE ${LAYER_PRIVATE_DEPENDS})
  set_property(GLOBAL APPEND PROPERTY PEDZONE_LAYERS ${target})
endfunction()
