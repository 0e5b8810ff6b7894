# cmake -DPROGRAM=bin/cps -DFOLDER=folder [-DPAGES=page.1] -P cmake/write_manuals.cmake: writes the program's man pages and
# completion, and the further pages, below FOLDER/share.
set(man ${FOLDER}/share/man/man1)
set(bash ${FOLDER}/share/bash-completion/completions)
set(zsh ${FOLDER}/share/zsh/vendor-completions)
file(REMOVE_RECURSE ${FOLDER}/share)
file(MAKE_DIRECTORY ${man} ${bash} ${zsh})

execute_process(COMMAND ${PROGRAM} --man OUTPUT_VARIABLE names OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" names "${names}")
foreach(name IN LISTS names)
  execute_process(COMMAND ${PROGRAM} --man ${name} COMMAND gzip -9n OUTPUT_FILE ${man}/${name}.1.gz COMMAND_ERROR_IS_FATAL ANY)
endforeach()
foreach(page IN LISTS PAGES)
  cmake_path(GET page FILENAME name)
  execute_process(COMMAND gzip -9n INPUT_FILE ${page} OUTPUT_FILE ${man}/${name}.gz COMMAND_ERROR_IS_FATAL ANY)
endforeach()

cmake_path(GET PROGRAM FILENAME program)
execute_process(COMMAND ${PROGRAM} --completion bash OUTPUT_FILE ${bash}/${program} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PROGRAM} --completion zsh OUTPUT_FILE ${zsh}/_${program} COMMAND_ERROR_IS_FATAL ANY)
file(TOUCH ${FOLDER}/written)
