# The manual page and the shells' completions, printed by the command from its own definition, and installed.
if(CMAKE_CROSSCOMPILING)
  return()  # the command does not run here
endif()
set(pages ${PROJECT_BINARY_DIR}/pages)
add_custom_command(TARGET pelage_command POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E make_directory ${pages}
  COMMAND pelage_command help --man > ${pages}/pelage.1
  COMMAND pelage_command completion bash > ${pages}/pelage.bash
  COMMAND pelage_command completion zsh > ${pages}/_pelage
  COMMENT "Printing the manual page and completions"
  VERBATIM)
install(FILES ${pages}/pelage.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${pages}/pelage.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME pelage)
install(FILES ${pages}/_pelage DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
