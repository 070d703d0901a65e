# Writes the licences of npm packages into one text, each once:
#   cmake -D MODULES=node_modules -D OUTPUT=licences.txt -P gather_licences.cmake
# Those are left out that only serve command lines which nothing here calls.
set(texts)
foreach(pattern vega* d3-* topojson-client delaunator robust-predicates internmap
                json-stringify-pretty-compact)
  file(GLOB files ${MODULES}/${pattern}/LICENSE)
  foreach(file IN LISTS files)
    get_filename_component(name ${file} DIRECTORY)
    get_filename_component(name ${name} NAME)
    file(READ ${file} text)
    string(SHA256 key "${text}")
    list(APPEND texts ${key})
    set(text_${key} "${text}")
    list(APPEND names_${key} ${name})
  endforeach()
endforeach()
list(REMOVE_DUPLICATES texts)
set(all "")
foreach(key IN LISTS texts)
  list(JOIN names_${key} ", " names)
  string(APPEND all "${names}\n\n${text_${key}}\n\n")
endforeach()
file(WRITE ${OUTPUT} "${all}")
