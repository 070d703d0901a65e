# The report's page as texts in the library: report_page_sources are the C++ files that hold them.
# npm fetches the libraries that draw, of exactly the versions in package-lock.json, into the build.
find_program(PEDZONE_NPM npm REQUIRED)

set(report ${CMAKE_CURRENT_SOURCE_DIR}/report)
set(npm ${CMAKE_CURRENT_BINARY_DIR}/npm)
set(modules ${npm}/node_modules)
file(MAKE_DIRECTORY ${npm})
add_custom_command(
  OUTPUT ${npm}/fetched
  COMMAND ${CMAKE_COMMAND} -E copy ${report}/package.json ${report}/package-lock.json ${npm}
  COMMAND ${PEDZONE_NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error
  COMMAND ${CMAKE_COMMAND} -E touch ${npm}/fetched
  DEPENDS ${report}/package.json ${report}/package-lock.json
  WORKING_DIRECTORY ${npm}
  COMMENT "Fetching the libraries of the study's report"
  VERBATIM)

set(embed ${PROJECT_SOURCE_DIR}/src/cmake/embed_page.cmake)
set(gather ${PROJECT_SOURCE_DIR}/src/cmake/gather_licences.cmake)
add_custom_command(
  OUTPUT ${npm}/licences.txt
  COMMAND ${CMAKE_COMMAND} -D MODULES=${modules} -D OUTPUT=${npm}/licences.txt -P ${gather}
  DEPENDS ${npm}/fetched ${gather}
  VERBATIM)

# Scripts apart from the template: a library's text may hold what mustache would take for a tag.
set(folders "${modules}/vega/build\\;${modules}/vega-lite/build\\;${modules}/vega-interpreter/build")
string(APPEND folders "\\;${modules}/uplot/dist")
file(GLOB report_sources CONFIGURE_DEPENDS ${report}/*)
set(report_page_sources)
foreach(part "page.mustache.html kReportPage" "styles.html kReportStyles"
             "scripts.html kReportScripts" "licences.txt kReportLicences")
  separate_arguments(part)
  list(POP_FRONT part name variable)
  set(file ${report}/${name})
  if(name STREQUAL licences.txt)
    set(file ${npm}/licences.txt)
  endif()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${variable}.cpp)
  add_custom_command(
    OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -D PAGE=${file} -D VARIABLE=${variable} -D OUTPUT=${source}
            -D FOLDER=${folders} -P ${embed}
    DEPENDS ${report_sources} ${npm}/licences.txt ${embed}
    VERBATIM)
  list(APPEND report_page_sources ${source})
endforeach()
