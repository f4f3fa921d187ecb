# scree_add_plugin(<kind> <name> [LEVELS x86-64-v3 x86-64-v4])
# Builds <kind>/<name>.cpp, or <name>.cpp, into <SCREE_PLUGIN_DIRECTORY>/<kind>/<name>.so and, for each instruction
# level, once more into a folder of that name beside it. The host loads the best that the processor runs; the results
# have the same bits. Contact laws and body forces, whose loops are long, have all levels unless LEVELS says otherwise.
# Used in scree's own tree, where SCREE_LEVELS may leave out levels, and, by find_package(scree), outside it.

include(GNUInstallDirs)
if(NOT SCREE_PLUGIN_DIRECTORY)
  set(SCREE_PLUGIN_DIRECTORY ${CMAKE_BINARY_DIR}/plugins)
endif()

# Same bits on every instruction level and compiler: no contraction, no reassociation. -fno-math-errno and
# -fno-trapping-math change no result; they let the compiler vectorise square roots and selections, and -fno-tree-sink
# keeps it from making branches of selections.
set(SCREE_NUMERIC_FLAGS -ffp-contract=off -fno-math-errno -fno-trapping-math -fopenmp-simd)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND SCREE_NUMERIC_FLAGS -fno-tree-sink)
endif()

function(scree_add_plugin kind name)
  cmake_parse_arguments(ARG "" "" "LEVELS" ${ARGN})
  if(NOT "LEVELS" IN_LIST ARGN AND kind MATCHES "^(contact|body_force)$")
    set(ARG_LEVELS x86-64-v3 x86-64-v4)
  endif()
  set(source ${kind}/${name}.cpp)
  if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${source})
    set(source ${name}.cpp)
  endif()
  if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(ARG_LEVELS "")
  endif()
  set(levels baseline ${ARG_LEVELS})
  if(DEFINED SCREE_LEVELS_BUILT AND NOT SCREE_SANITIZE AND ARG_LEVELS)
    list(TRANSFORM SCREE_LEVELS_BUILT PREPEND x86-64-v OUTPUT_VARIABLE built)
    list(TRANSFORM built REPLACE "x86-64-v1" baseline)
    list(JOIN built "|" built)
    list(FILTER levels INCLUDE REGEX "^(${built})$")
  endif()
  foreach(level ${levels})
    set(target ${kind}_${name})
    set(directory ${kind})
    if(NOT level STREQUAL baseline)
      string(APPEND target _${level})
      string(APPEND directory /${level})
    endif()
    if(SCREE_SANITIZE AND NOT level STREQUAL baseline) # loops with checks are not vectorised: each takes minutes to compile
      add_custom_command(TARGET ${kind}_${name} POST_BUILD
        COMMAND ${CMAKE_COMMAND} -E make_directory ${SCREE_PLUGIN_DIRECTORY}/${directory}
        COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_FILE:${kind}_${name}> ${SCREE_PLUGIN_DIRECTORY}/${directory})
      continue()
    endif()
    add_library(${target} MODULE ${source})
    set_property(GLOBAL APPEND PROPERTY SCREE_PLUGIN_TARGETS ${target})
    target_link_libraries(${target} PRIVATE scree_sdk $<TARGET_NAME_IF_EXISTS:scree_compile_options>)
    target_compile_options(${target} PRIVATE ${SCREE_NUMERIC_FLAGS})
    set_target_properties(${target} PROPERTIES
      PREFIX "" OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY ${SCREE_PLUGIN_DIRECTORY}/${directory})
    if(SCREE_SANITIZE)
      # GCC 12 takes two minutes to optimise the checks of one law.
      target_compile_options(${target} PRIVATE -O0)
    else()
      # -O3 whatever the preset: below it GCC 12 vectorises no loop. Scheduling before registers are allocated lets
      # independent chains of a law overlap.
      target_compile_options(${target} PRIVATE -O3)
      if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        target_compile_options(${target} PRIVATE -fschedule-insns -fsched-pressure)
      endif()
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
