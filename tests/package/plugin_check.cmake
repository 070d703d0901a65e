# Builds the plug-ins against the package that check.cmake has installed, walks people by the worked
# example with the independent check, and has pedzone refuse all others.
set(pedzone ${WORK}/prefix/bin/pedzone)
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${PLUGINS} -B ${WORK}/plugins
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/plugins)
run(/usr/bin/python3 ${RUN_SCENARIO} ${pedzone} ${SCENARIO} --model ${WORK}/plugins/libcareful.so --
    --max-lost 0 --max-outside 0 --max-controlled-jumps 0 --max-nan 0)

# refused(WHAT PATTERN ARGUMENTS...): exit code 2, one error that matches, no output.
function(refused what pattern)
  file(REMOVE ${WORK}/refused.csv)
  execute_process(COMMAND ${pedzone} run ${SCENARIO} --end 60 --trajectories ${WORK}/refused.csv
                          ${ARGN}
                  WORKING_DIRECTORY ${WORK}/plugins COMMAND_ECHO STDOUT
                  RESULT_VARIABLE code ERROR_VARIABLE error OUTPUT_QUIET)
  string(REGEX MATCHALL "Error:" errors "${error}")
  list(LENGTH errors count)
  file(GLOB left ${WORK}/refused.csv*)
  if(NOT code EQUAL 2 OR NOT error MATCHES "${pattern}" OR NOT count EQUAL 1 OR left)
    message(FATAL_ERROR "${what}: exit code ${code}, files [${left}], ${error}")
  endif()
endfunction()
refused(throwing "libthrowing.so: walking model: failed: no way out" --model ./libthrowing.so)
refused(wild "libwild.so: speed of the walking model's decision: 'nan' is out of range"
        --model ./libwild.so)
refused(unmade "option --model: './libunmade.so' cannot be made: its file" --model ./libunmade.so)
refused(outdated "'./liboutdated.so' was built for another interface" --model ./liboutdated.so)
refused(empty "'./libempty.so' has no walking model" --model ./libempty.so)
refused(missing "'./libnothing.so' is missing" --model ./libnothing.so)
file(WRITE ${WORK}/plugins/libtext.so "not a library\n")
refused(text "'./libtext.so' cannot be loaded" --model ./libtext.so)
refused(unknown "option --model: 'telepathy' is not known; allowed: heuristic, .*orca"
        --model telepathy)
file(WRITE ${WORK}/plugins/old.zone.xml
     "<zones>\n  <zone id=\"plaza\" model=\"./liboutdated.so\"/>\n</zones>\n")
refused(zone "old.zone.xml:2: .*model: './liboutdated.so' was built for" --zone old.zone.xml)
# A zone file names it by its path from there, wherever pedzone runs.
file(WRITE ${WORK}/plugins/careful.zone.xml
     "<zones>\n  <zone id=\"plaza\" model=\"libcareful.so\"/>\n</zones>\n")
run(${pedzone} run ${SCENARIO} --end 60 --quiet --zone ${WORK}/plugins/careful.zone.xml)
