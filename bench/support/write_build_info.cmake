# cmake -DSOURCE_DIR= -DINPUT= -DOUTPUT= -DBUILD_COMPILER= -DBUILD_FLAGS= -P: writes build_info.cpp, only where it changes.
find_program(GIT_PROGRAM git)
set(BUILD_COMMIT "unknown")
if(GIT_PROGRAM)
  execute_process(COMMAND ${GIT_PROGRAM} describe --always --dirty --tags WORKING_DIRECTORY ${SOURCE_DIR}
                  OUTPUT_VARIABLE described RESULT_VARIABLE status ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(status EQUAL 0)
    set(BUILD_COMMIT "${described}")
  endif()
endif()
configure_file(${INPUT} ${OUTPUT} @ONLY)
