# Makes one page out of an HTML file and the style sheets and scripts that it names, and a C++ source
# that holds it:
#   cmake -D PAGE=page.html -D VARIABLE=kPage -D OUTPUT=page.cpp -P embed_page.cmake
# What the page names is looked for in its own folder, then in FOLDER where that is given.
get_filename_component(folders ${PAGE} DIRECTORY)
list(APPEND folders ${FOLDER})
file(READ ${PAGE} page)

# The text of a file that the page names, as it may stand inside an element.
function(read_part name result)
  find_file(found ${name} PATHS ${folders} NO_DEFAULT_PATH NO_CACHE REQUIRED)
  file(READ ${found} text)
  string(REGEX REPLACE "\n//# sourceMappingURL=[^\n]*" "" text "${text}")
  if(text MATCHES "</(script|style)")
    message(FATAL_ERROR "${found} holds an end tag")
  endif()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

string(REGEX MATCHALL "<link rel=\"stylesheet\" href=\"[^\"]+\">" links "${page}")
foreach(link IN LISTS links)
  string(REGEX REPLACE ".*href=\"([^\"]+)\".*" "\\1" name "${link}")
  read_part(${name} text)
  string(REPLACE "${link}" "<style nonce=\"pedzone\">\n${text}</style>" page "${page}")
endforeach()

string(REGEX MATCHALL "<script src=\"[^\"]+\"></script>" scripts "${page}")
foreach(script IN LISTS scripts)
  string(REGEX REPLACE ".*src=\"([^\"]+)\".*" "\\1" name "${script}")
  read_part(${name} text)
  string(REPLACE "${script}" "<script nonce=\"pedzone\">\n${text}</script>" page "${page}")
endforeach()

file(WRITE ${OUTPUT} "#include <string_view>
namespace pedzone {
extern const std::string_view ${VARIABLE};
const std::string_view ${VARIABLE} = R\"embedded_page(${page})embedded_page\";
}  // namespace pedzone
")
