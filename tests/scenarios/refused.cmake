# cmake -DSCREE=<program> -DSCENE=<file> -DOUT=<directory> -P refused.cmake
# Fails unless the scene is refused (exit status 2) or stopped as unstable (3) with a one-line message that matches
# the comment `# refused: <regex>` of the scene.

file(STRINGS ${SCENE} line REGEX "^# refused: " LIMIT_COUNT 1)
if(NOT line)
  message(FATAL_ERROR "${SCENE}: no line '# refused: <regex>'")
endif()
string(REGEX REPLACE "^# refused: " "" expected "${line}")

file(REMOVE_RECURSE ${OUT})
execute_process(COMMAND ${SCREE} run ${SCENE} --out ${OUT} --quiet
  RESULT_VARIABLE status ERROR_VARIABLE output)
if(NOT status MATCHES "^[23]$")
  message(FATAL_ERROR "exit status ${status}, not 2 or 3; output: ${output}")
endif()
# A forced step is warned of before.
string(REGEX REPLACE "scree: warning: [^\n]+\n" "" output "${output}")
if(NOT output MATCHES "^scree: [^\n]+\n$")
  message(FATAL_ERROR "not refused with one line: ${output}")
endif()
if(NOT output MATCHES "${expected}")
  message(FATAL_ERROR "'${expected}' is not in: ${output}")
endif()
