# scree_add_plugin_tests(<kind> <name> [SCENES <files...>] [VALUES <key=value...>])
# For a plug-in outside scree's own tree: ctest runs the general checks of `scree test-plugin`, with values for the
# parameters of a law, and each scene, whose [expect] must be met. The target `check` builds the plug-in and runs all.

enable_testing()

function(scree_add_plugin_tests kind name)
  cmake_parse_arguments(ARG "" "" "SCENES;VALUES" ${ARGN})
  add_test(NAME "${name}: general checks"
    COMMAND ${SCREE_PROGRAM} test-plugin ${SCREE_PLUGIN_DIRECTORY}/${kind}/${name}.so ${ARG_VALUES})
  foreach(scene ${ARG_SCENES})
    add_test(NAME "${name}: ${scene}"
      COMMAND ${SCREE_PROGRAM} run ${CMAKE_CURRENT_SOURCE_DIR}/${scene} --plugins ${SCREE_PLUGIN_DIRECTORY}
              --out ${CMAKE_BINARY_DIR}/runs/${name}-${scene} --overwrite)
  endforeach()
  if(NOT TARGET check)
    add_custom_target(check COMMAND ${CMAKE_CTEST_COMMAND} --output-on-failure USES_TERMINAL)
  endif()
  get_property(targets GLOBAL PROPERTY SCREE_PLUGIN_TARGETS)
  add_dependencies(check ${targets})
endfunction()
