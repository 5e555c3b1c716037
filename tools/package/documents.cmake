# Writes manual pages and completions into FOLDER (man1, man5, bash, zsh, fish), as RIND prints them;
# the pages are compressed if GZIP is a program.
file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${RIND} manual OUTPUT_VARIABLE list COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]+" pages "${list}")
foreach(page ${pages})
  string(REGEX REPLACE ".*\\." "" section ${page})
  set(file ${FOLDER}/man${section}/${page})
  file(MAKE_DIRECTORY ${FOLDER}/man${section})
  execute_process(COMMAND ${RIND} manual ${page} OUTPUT_FILE ${file} COMMAND_ERROR_IS_FATAL ANY)
  if(GZIP)
    execute_process(COMMAND ${GZIP} -9n ${file} COMMAND_ERROR_IS_FATAL ANY)
  endif()
endforeach()
foreach(shell bash zsh fish)
  execute_process(COMMAND ${RIND} completion ${shell} OUTPUT_FILE ${FOLDER}/${shell}
    COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(TOUCH ${FOLDER}/written)
