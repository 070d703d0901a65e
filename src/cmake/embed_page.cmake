# Makes one page out of an HTML file and the style sheets and scripts that it names, and a C++ source
# that holds it:
#   cmake -D PAGE=page.html -D VARIABLE=kPage -D OUTPUT=page.cpp -P embed_page.cmake
get_filename_component(folder ${PAGE} DIRECTORY)
file(READ ${PAGE} page)

string(REGEX MATCHALL "<link rel=\"stylesheet\" href=\"[^\"]+\">" links "${page}")
foreach(link IN LISTS links)
  string(REGEX REPLACE ".*href=\"([^\"]+)\".*" "\\1" name "${link}")
  file(READ ${folder}/${name} text)
  string(REPLACE "${link}" "<style nonce=\"pedzone\">\n${text}</style>" page "${page}")
endforeach()

string(REGEX MATCHALL "<script src=\"[^\"]+\"></script>" scripts "${page}")
foreach(script IN LISTS scripts)
  string(REGEX REPLACE ".*src=\"([^\"]+)\".*" "\\1" name "${script}")
  file(READ ${folder}/${name} text)
  string(REPLACE "${script}" "<script nonce=\"pedzone\">\n${text}</script>" page "${page}")
endforeach()

file(WRITE ${OUTPUT} "#include <string_view>
namespace pedzone {
extern const std::string_view ${VARIABLE};
const std::string_view ${VARIABLE} = R\"page(${page})page\";
}  // namespace pedzone
")
