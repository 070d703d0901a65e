# Builds the outside project against the package that install.cmake has installed, and runs it.
file(REMOVE_RECURSE ${WORK}/build ${WORK}/plugins)
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${OUTSIDE} -B ${WORK}/build
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/outside ${SCENARIO})
run(${WORK}/prefix/bin/pedzone --version)
foreach(file pedzone/zones.xsd pedzone/summary.schema.json man/man1/pedzone.1
             bash-completion/completions/pedzone zsh/site-functions/_pedzone)
  if(NOT EXISTS ${WORK}/prefix/share/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/plugin_check.cmake)
