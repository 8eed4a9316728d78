# embed_texts(TARGET FOLDER NAMESPACE): the header FOLDER/texts.h with a constant for each file of FOLDER/texts, a
# std::string_view: main_py for the file main.py.in. FOLDER is relative to the root of the sources. A program needs no
# such file while it runs.
function(embed_texts target folder namespace)
  file(GLOB files CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/${folder}/texts/*.in")
  set(header "// Made from ${folder}/texts by cmake/embed_texts.cmake.\n#pragma once\n\n#include <string_view>\n\n")
  string(APPEND header "namespace ${namespace} {\n")
  foreach(file IN LISTS files)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    get_filename_component(name "${file}" NAME)
    string(REGEX REPLACE "\\.in$" "" name "${name}")
    string(MAKE_C_IDENTIFIER "${name}" name)
    file(READ "${file}" text)
    string(APPEND header "inline constexpr std::string_view ${name} = R\"text(${text})text\";\n")
  endforeach()
  string(APPEND header "}  // namespace ${namespace}\n")
  set(made "${CMAKE_CURRENT_BINARY_DIR}/${folder}/texts.h")
  file(WRITE "${made}.new" "${header}")
  configure_file("${made}.new" "${made}" COPYONLY)  # keeps the time of a header that does not change
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
endfunction()
