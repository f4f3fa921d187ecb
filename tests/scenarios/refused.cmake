# cmake -DSCREE=<program> -DSCENE=<file> -DOUT=<directory> -P refused.cmake
# Fails unless the scene is refused as bad input (2) or stops as blown up (3), with one line that matches
# the scene's comment `# refused: <regex>`.

file(STRINGS ${SCENE} line REGEX "^# refused: " LIMIT_COUNT 1)
if(NOT line)
  message(FATAL_ERROR "${SCENE}: no line '# refused: <regex>' tells how it is refused")
endif()
string(REGEX REPLACE "^# refused: " "" wanted "${line}")

execute_process(COMMAND ${SCREE} run ${SCENE} --out ${OUT} --overwrite --quiet
  RESULT_VARIABLE status ERROR_VARIABLE said)
if(NOT status MATCHES "^[23]$")
  message(FATAL_ERROR "exit status ${status}, not 2 or 3; said: ${said}")
endif()
if(NOT said MATCHES "^scree: [^\n]+\n$")
  message(FATAL_ERROR "not refused with one line: ${said}")
endif()
if(NOT said MATCHES "${wanted}")
  message(FATAL_ERROR "'${wanted}' is not in: ${said}")
endif()
