# Writes the program's version as C++ into OUT, if it has changed: NUMBER, then the commit if SOURCES
# is a git checkout, then "-changed" if it was edited since.
set(text "${NUMBER}")
find_package(Git QUIET)
if(GIT_FOUND AND EXISTS ${SOURCES}/.git)
  execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --dirty=-changed --exclude=*
    WORKING_DIRECTORY ${SOURCES} OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
    ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    string(APPEND text "+${commit}")
  endif()
endif()
file(CONFIGURE OUTPUT ${OUT} @ONLY CONTENT [[
#include "host/system/version.h"

namespace host {

const char* const kVersion = "@text@";

}  // namespace host
]])
