# scree_add_plugin(<kind> <name> [LEVELS x86-64-v3 x86-64-v4])
# Builds <kind>/<name>.cpp into <plug-in directory>/<kind>/<name>.so and, for each instruction level, once more into
# a folder of that name beside it. The host loads the best that the processor runs; the results have the same bits.

function(scree_add_plugin kind name)
  cmake_parse_arguments(ARG "" "" "LEVELS" ${ARGN})
  if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(ARG_LEVELS "")
  endif()
  foreach(level baseline ${ARG_LEVELS})
    set(target ${kind}_${name})
    set(directory ${kind})
    if(NOT level STREQUAL baseline)
      string(APPEND target _${level})
      string(APPEND directory /${level})
    endif()
    add_library(${target} MODULE ${kind}/${name}.cpp)
    set_property(GLOBAL APPEND PROPERTY SCREE_PLUGIN_TARGETS ${target})
    target_link_libraries(${target} PRIVATE scree_sdk scree_compile_options)
    set_target_properties(${target} PROPERTIES
      PREFIX "" OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY ${SCREE_PLUGIN_DIRECTORY}/${directory})
    if(NOT SCREE_SANITIZE)
      # -O3 whatever the preset: below it GCC 12 vectorises no loop. Scheduling before registers are allocated lets
      # independent chains of a law overlap.
      target_compile_options(${target} PRIVATE -O3 -fschedule-insns -fsched-pressure)
    endif()
    if(NOT level STREQUAL baseline)
      target_compile_options(${target} PRIVATE -march=${level} -mprefer-vector-width=512)
      if(level STREQUAL x86-64-v4)
        target_compile_options(${target} PRIVATE -mtune=icelake-server) # the generic one avoids masked moves
      endif()
    endif()
    install(TARGETS ${target} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/scree/plugins/${directory})
  endforeach()
endfunction()
