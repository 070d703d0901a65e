# Pages as texts in a library. What draws in them is fetched by npm, of exactly the versions in
# src/pages/package-lock.json, into the build (src/pages/CMakeLists.txt).
set(PEDZONE_NPM_FOLDER ${PROJECT_BINARY_DIR}/src/pages/npm)

# pedzone_page_sources(RESULT FOLDER file variable [file variable ...]): the C++ sources that hold
# these files of FOLDER as `variable`. A style sheet or script that a file names is put into it,
# from FOLDER, else from src/pages, else from the npm packages.
# Scripts stay apart from a page's template: a library's text may hold what mustache takes for a tag.
function(pedzone_page_sources result folder)
  set(shared ${PROJECT_SOURCE_DIR}/src/pages)
  set(modules ${PEDZONE_NPM_FOLDER}/node_modules)
  set(embed ${PROJECT_SOURCE_DIR}/src/cmake/embed_page.cmake)
  set(folders "${shared}\\;${modules}/vega/build\\;${modules}/vega-lite/build")
  string(APPEND folders "\\;${modules}/vega-interpreter/build")
  file(GLOB inputs CONFIGURE_DEPENDS ${shared}/*)
  if(NOT folder STREQUAL PEDZONE_NPM_FOLDER)
    file(GLOB own CONFIGURE_DEPENDS ${folder}/*)
    list(APPEND inputs ${own})
  endif()
  set(sources)
  while(ARGN)
    list(POP_FRONT ARGN name variable)
    get_filename_component(file ${name} ABSOLUTE BASE_DIR ${folder})
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${variable}.cpp)
    add_custom_command(
      OUTPUT ${source}
      COMMAND ${CMAKE_COMMAND} -D PAGE=${file} -D VARIABLE=${variable} -D OUTPUT=${source}
              -D FOLDER=${folders} -P ${embed}
      DEPENDS ${inputs} pedzone_npm ${PEDZONE_NPM_FOLDER}/licences.txt ${embed}
      VERBATIM)
    list(APPEND sources ${source})
  endwhile()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()
