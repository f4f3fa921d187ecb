# scree_revision: the commit of the sources, in a library of one small file, so that a new commit compiles this file and
# links what reads it. Asked for at each build, but written only when it has changed.
add_custom_target(scree_revision_source BYPRODUCTS ${PROJECT_BINARY_DIR}/revision/program_commit.cpp
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -DFILE=${PROJECT_BINARY_DIR}/revision/program_commit.cpp
          -P ${PROJECT_SOURCE_DIR}/tools/cmake/write_revision.cmake
  COMMENT "Asking for the commit" VERBATIM)
add_library(scree_revision STATIC ${PROJECT_BINARY_DIR}/revision/program_commit.cpp)
add_dependencies(scree_revision scree_revision_source)
target_include_directories(scree_revision PUBLIC ${PROJECT_SOURCE_DIR}/modules/base/files/include)
target_link_libraries(scree_revision PRIVATE scree_compile_options)
