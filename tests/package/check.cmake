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
# SUMO's library is loaded for a run alone, from where it was installed to.
run(${WORK}/prefix/bin/pedzone run ${SCENARIO} --quiet)
execute_process(COMMAND ldd ${WORK}/prefix/bin/pedzone OUTPUT_VARIABLE libraries
                COMMAND_ERROR_IS_FATAL ANY)
if(libraries MATCHES sumocpp)
  message(FATAL_ERROR "the program loads SUMO's library whatever it does")
endif()
file(GLOB_RECURSE library ${WORK}/prefix/lib/*/sumo_in_process.so)
file(RENAME ${library} ${library}.away)
execute_process(COMMAND ${WORK}/prefix/bin/pedzone run ${SCENARIO} --quiet
                RESULT_VARIABLE code ERROR_VARIABLE said)
file(RENAME ${library}.away ${library})
if(NOT code EQUAL 3 OR NOT said MATCHES "SUMO cannot be started: .*sumo_in_process.so")
  message(FATAL_ERROR "without its library: exit code ${code}: ${said}")
endif()
foreach(file pedzone/zones.xsd pedzone/summary.schema.json man/man1/pedzone.1
             bash-completion/completions/pedzone zsh/site-functions/_pedzone)
  if(NOT EXISTS ${WORK}/prefix/share/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/plugin_check.cmake)
