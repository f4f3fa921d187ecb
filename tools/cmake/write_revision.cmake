# cmake -DSOURCE=<sources> -DFILE=<file> -P write_revision.cmake: writes the source that knows the commit, unless it has
# the same already. A tree without .git is a copy, whatever repository it lies in: git archive has written its commit
# into revision.txt, and "unknown" stands for no answer.
cmake_minimum_required(VERSION 3.25)
set(commit "")
if(EXISTS ${SOURCE}/.git)
  find_program(GIT git)
  if(GIT)
    execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --abbrev=12 --exclude=* --dirty
      OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  endif()
else()
  file(STRINGS ${SOURCE}/tools/cmake/revision.txt commit LIMIT_COUNT 1)
  string(SUBSTRING "${commit}" 0 12 commit)
endif()
if(NOT commit MATCHES "^[0-9a-f]+(-dirty)?$")
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${FILE} @ONLY CONTENT [[#include <scree/files/program_commit.hpp>

namespace scree::files {

const char* program_commit() { return "@commit@"; }

}  // namespace scree::files
]])
