# cmake --build . --target docs: documentation of the code, in docs/html; fails at a warning. Not built otherwise.
configure_file(Doxyfile.in Doxyfile @ONLY)
find_program(DOXYGEN doxygen)
if(DOXYGEN)
  add_custom_target(docs
    COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/docs
    COMMAND ${DOXYGEN} ${CMAKE_CURRENT_BINARY_DIR}/Doxyfile
    COMMENT "Documentation of the code in ${PROJECT_BINARY_DIR}/docs/html" VERBATIM)
endif()
