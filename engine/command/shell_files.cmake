# What man, shells and editors read: printed by the program when everything is built, installed where they look.
include(GNUInstallDirs)
find_program(GZIP gzip)

set(shell_files "")
# NAME: of the file; FOLDER: below the prefix; the rest: what the program is asked for.
function(sluice_shell_file name folder)
  set(file ${CMAKE_BINARY_DIR}/share/${name})
  add_custom_command(OUTPUT ${file}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/share
    COMMAND sluice_command ${ARGN} > ${file}
    DEPENDS sluice_command VERBATIM)
  if(name MATCHES "[.]1$" AND GZIP)  # manual pages are compressed, as Debian has them
    add_custom_command(OUTPUT ${file}.gz COMMAND ${GZIP} -9nc ${file} > ${file}.gz DEPENDS ${file} VERBATIM)
    set(file ${file}.gz)
  endif()
  install(FILES ${file} DESTINATION ${folder} COMPONENT program)
  set(shell_files ${shell_files} ${file} PARENT_SCOPE)
endfunction()

sluice_shell_file(sluice.1 ${CMAKE_INSTALL_MANDIR}/man1 help manual)
sluice_shell_file(sluice ${CMAKE_INSTALL_DATADIR}/bash-completion/completions completion bash)
sluice_shell_file(_sluice ${CMAKE_INSTALL_DATADIR}/zsh/site-functions completion zsh)
sluice_shell_file(sluice.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d completion fish)
sluice_shell_file(sluice.schema.json ${CMAKE_INSTALL_DATADIR}/sluice help schema)
add_custom_target(sluice_shell_files ALL DEPENDS ${shell_files})
