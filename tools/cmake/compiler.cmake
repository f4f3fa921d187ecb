# One place for what every target is compiled with: warnings, sanitizers, and the floating-point contract.

add_library(scree_compile_options INTERFACE)
target_compile_options(scree_compile_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Woverloaded-virtual)
# Clang knows no `#pragma GCC ivdep`.
target_compile_options(scree_compile_options INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-unknown-pragmas>)
if(SCREE_WARNINGS_AS_ERRORS)
  target_compile_options(scree_compile_options INTERFACE -Werror)
endif()

# What keeps results the same on every processor: see plugin.cmake.
target_compile_options(scree_compile_options INTERFACE ${SCREE_NUMERIC_FLAGS})

set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O3 -g -DNDEBUG")
if(SCREE_ASSERTIONS)
  set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g -D_GLIBCXX_ASSERTIONS")
endif()

# For what spends its time in libraries and plug-ins, as the program and the tests do: at -O3 they take a third longer to
# compile and run no faster. Results have the same bits at every level.
add_library(scree_quick_to_compile INTERFACE)
set(SCREE_QUICK_LEVEL -O1 CACHE STRING "Optimisation of what spends its time in libraries and plug-ins")
if(NOT SCREE_SANITIZE)
  target_compile_options(scree_quick_to_compile INTERFACE $<$<CONFIG:Release,RelWithDebInfo>:${SCREE_QUICK_LEVEL}>)
endif()

if(SCREE_SANITIZE)
  # Optimising instrumented code takes minutes a file; errors are found without.
  set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O0 -g1 -D_GLIBCXX_ASSERTIONS")
  if(SCREE_FUZZ) # for more inputs in a second
    set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O1 -g1 -D_GLIBCXX_ASSERTIONS")
  endif()
  add_compile_options(-fsanitize=${SCREE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${SCREE_SANITIZE})
  if(SCREE_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
  endif()
  # With sanitizers GCC 12 reports uninitialised members deep inside the standard library where there are none.
  target_compile_options(scree_compile_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

find_program(SCREE_CCACHE ccache)
if(SCREE_CCACHE)
  # Paths below the sources count from there, so that another copy of them is compiled from what the first one has left.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${SCREE_CCACHE})
  # Without leave to be sloppy it caches nothing that includes them.
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

# For targets whose sources share headers and instances of templates, most of their time in the compiler: eight files in
# a batch take about two fifths of their time one by one.
function(scree_compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${SCREE_BATCHES})
endfunction()

# For libraries that the program loads and, in a build tree, builds if they are missing
# (modules/base/files/src/companion_library.cpp), so that the first run need not wait for them. Each is linked elsewhere,
# and given its place when it is whole: a linker that is killed leaves nothing that scree would load.
function(scree_build_on_demand target)
  set_target_properties(${target} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/linked)
  set(placed ${PROJECT_BINARY_DIR}/lib/lib${target}.so)
  add_custom_command(TARGET ${target} POST_BUILD VERBATIM BYPRODUCTS ${placed}
    COMMAND ${CMAKE_COMMAND} -E copy $<TARGET_FILE:${target}> ${placed}.part
    COMMAND ${CMAKE_COMMAND} -E rename ${placed}.part ${placed})
endfunction()

# scree_compile_apart(<target> <names>...): sources src/<name>.cpp of a library in a batch of their own, the objects
# <target>_apart, whose include folders, libraries and options the caller sets.
function(scree_compile_apart target)
  list(TRANSFORM ARGN REPLACE "(.+)" "${CMAKE_CURRENT_SOURCE_DIR}/src/\\1.cpp" OUTPUT_VARIABLE loops)
  get_target_property(others ${target} SOURCES)
  list(REMOVE_ITEM others ${loops})
  set_target_properties(${target} PROPERTIES SOURCES "${others}")
  add_library(${target}_apart OBJECT ${loops})
  scree_compile_together(${target}_apart)
  target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_apart>)
endfunction()
