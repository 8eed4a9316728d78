# cmake -DBUILT=build/release -DSOURCE=tests/install -P run.cmake: installs the libraries, builds and runs a project on them.
set(tree "${BUILT}/install-test")
file(REMOVE_RECURSE "${tree}")
foreach(step IN ITEMS
        "--install;${BUILT};--prefix;${tree}/prefix;--component;libraries"
        "-S;${SOURCE};-B;${tree}/build;-G;Ninja;-DCMAKE_PREFIX_PATH=${tree}/prefix"
        "--build;${tree}/build;--target;run")
  execute_process(COMMAND ${CMAKE_COMMAND} ${step} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(result)
    message(FATAL_ERROR "cmake ${step} failed:\n${said}")
  endif()
endforeach()
