# Runs a scene and compares the hash of its last state with the one in the file GOLDEN; with SCREE_RENEW_GOLDEN in the environment, adds it there.
# -DSCREE=program -DSCENE=file -DNAME=name in GOLDEN -DOUT=directory -DGOLDEN=file [-DSETS=key=value;...]

set(overrides "")
foreach(set ${SETS})
  list(APPEND overrides --set ${set})
endforeach()
file(REMOVE_RECURSE ${OUT})
execute_process(COMMAND ${SCREE} run ${SCENE} --out ${OUT} --quiet ${overrides} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "scree run ${SCENE} ended with ${status}")
endif()
file(READ ${OUT}/run.json record)
string(JSON hash GET "${record}" state_hash)
if(DEFINED ENV{SCREE_RENEW_GOLDEN})
  file(APPEND ${GOLDEN} "${hash}  ${NAME}\n")
  return()
endif()
file(STRINGS ${GOLDEN} line REGEX "^[0-9a-f]+  ${NAME}$")
if(NOT line STREQUAL "${hash}  ${NAME}")
  message(FATAL_ERROR "${NAME}: the state hash is ${hash}, but '${line}' stands in ${GOLDEN}.\n"
    "If results were to change, renew the file with tests/scenarios/golden/renew and say so in the commit.")
endif()
