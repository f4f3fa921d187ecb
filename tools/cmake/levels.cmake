# SCREE_LEVELS: the instruction levels x86-64-v<n> for which contact laws, body forces and the hot loops of the kernel are
# built: all, or native, the best of this computer's processor alone, which takes half the time to build and gives the
# same bits. Sets SCREE_LEVELS_BUILT to the numbers n, best first; 1 is the baseline.
set(SCREE_LEVELS all CACHE STRING "Instruction levels to build for: all, or native (this processor's best)")
set_property(CACHE SCREE_LEVELS PROPERTY STRINGS all native)

# Instrumented loops are not vectorised and take minutes to compile; clang 14 knows no levels.
set(SCREE_LEVELS_BUILT 1)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND CMAKE_CXX_COMPILER_ID STREQUAL GNU AND NOT SCREE_SANITIZE)
  set(SCREE_LEVELS_BUILT 4 3 1)
  if(SCREE_LEVELS STREQUAL native)
    set(probe ${PROJECT_BINARY_DIR}/CMakeFiles/native_level.cpp)
    file(WRITE ${probe} "int main() {
      return __builtin_cpu_supports(\"x86-64-v4\") ? 4 : __builtin_cpu_supports(\"x86-64-v3\") ? 3 : 1;
    }\n")
    try_run(SCREE_NATIVE_LEVEL compiled ${PROJECT_BINARY_DIR}/CMakeFiles ${probe})
    set(SCREE_LEVELS_BUILT ${SCREE_NATIVE_LEVEL})
  elseif(NOT SCREE_LEVELS STREQUAL all)
    message(FATAL_ERROR "SCREE_LEVELS=${SCREE_LEVELS}: is neither 'all' nor 'native'")
  endif()
endif()
