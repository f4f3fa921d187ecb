# scree-config.cmake for find_package(scree), in the build tree and in the installed one: both have bin/scree and
# lib/cmake/scree, which is how `scree new-plugin` finds it.

include(CMakePackageConfigHelpers)

function(scree_configure_package directory prefix include_path)
  set(SCREE_PROGRAM_PATH ${CMAKE_INSTALL_BINDIR}/scree)
  set(SCREE_INCLUDE_PATH ${include_path})
  configure_package_config_file(${PROJECT_SOURCE_DIR}/tools/cmake/scree-config.cmake.in ${directory}/scree-config.cmake
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scree INSTALL_PREFIX ${prefix}
    PATH_VARS SCREE_PROGRAM_PATH SCREE_INCLUDE_PATH)
  write_basic_package_version_file(${directory}/scree-config-version.cmake COMPATIBILITY ExactVersion)
endfunction()

set(files tools/cmake/plugin.cmake tools/cmake/plugin_tests.cmake)
set(built ${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/cmake/scree)
scree_configure_package(${built} ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR}/framework/include)
file(COPY ${files} DESTINATION ${built})

set(installed ${PROJECT_BINARY_DIR}/CMakeFiles/scree)
scree_configure_package(${installed} ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${files} ${installed}/scree-config.cmake ${installed}/scree-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scree)
