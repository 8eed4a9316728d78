# The lab as a program of a web page, with its data and fonts in one file; packaging/web makes the page.
include("${CMAKE_SOURCE_DIR}/packaging/fonts.cmake")
set(preloaded exercises@/data/exercises shaders@/data/shaders ui/strings@/data/ui/strings)
list(TRANSFORM preloaded PREPEND "${CMAKE_SOURCE_DIR}/")
# A fifth of each font: the ranges of ui/widgets/theme.cpp and, for labels of the scene, more Latin and Cyrillic letters;
# without the tables of ligatures and kerning, which neither Dear ImGui nor FreeType reads.
set(characters "0020-024F,0370-04FF,1E00-1EFF,2010-2027,2039-203A,2070-209F,20AC,2190-22FF,25A0-25FF,2713-2718,F000-F2FF")
find_program(HB_SUBSET hb-subset REQUIRED)
foreach(font IN LISTS BRAITENLAB_FONTS)
  cmake_path(GET font FILENAME name)
  set(subset "${CMAKE_CURRENT_BINARY_DIR}/fonts/${name}")
  add_custom_command(
    OUTPUT "${subset}"
    COMMAND ${CMAKE_COMMAND} -E make_directory "${CMAKE_CURRENT_BINARY_DIR}/fonts"
    COMMAND ${HB_SUBSET} --unicodes=${characters} --layout-features= "--output-file=${subset}" "${font}"
    DEPENDS "${font}"
    VERBATIM)
  list(APPEND subsets "${subset}")
  list(APPEND preloaded "${subset}@/data/fonts/${name}")
endforeach()
add_custom_target(braitenlab_page_fonts DEPENDS ${subsets})
add_dependencies(braitenlab braitenlab_page_fonts)
list(TRANSFORM preloaded PREPEND "SHELL:--preload-file ")
target_link_options(braitenlab PRIVATE ${preloaded}
  -sENVIRONMENT=web -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2 -sFORCE_FILESYSTEM=1 -sINITIAL_MEMORY=67108864
  -sEXPORTED_RUNTIME_METHODS=FS,ccall "-sEXPORTED_FUNCTIONS=_main,_malloc,_free")
file(GLOB_RECURSE data CONFIGURE_DEPENDS
  "${CMAKE_SOURCE_DIR}/exercises/*" "${CMAKE_SOURCE_DIR}/shaders/*" "${CMAKE_SOURCE_DIR}/ui/strings/*")
set_target_properties(braitenlab PROPERTIES LINK_DEPENDS "${data};${subsets}")

set(licences "braitenlab=${CMAKE_SOURCE_DIR}/LICENSE")
foreach(package IN ITEMS fonts-noto-core fonts-noto-mono fonts-fork-awesome emscripten
                         libfmt-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev)
  list(APPEND licences "${package}=/usr/share/doc/${package}/copyright")
endforeach()
foreach(package IN ITEMS box2d imgui freetype libstb zlib)
  file(GLOB licence "${BRAITENLAB_SOURCES}/${package}-*/debian/copyright")
  list(APPEND licences "${package}=${licence}")
endforeach()

file(GLOB page CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/packaging/web/*")
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(dist "${CMAKE_SOURCE_DIR}/build/dist")
add_custom_command(
  OUTPUT "${dist}/web/index.html" "${dist}/braitenlab-web.html"
  COMMAND ${Python3_EXECUTABLE} "${CMAKE_SOURCE_DIR}/packaging/web/make_page.py" $<TARGET_FILE_DIR:braitenlab> "${dist}"
          ${licences}
  DEPENDS braitenlab ${page}
  VERBATIM)
add_custom_target(braitenlab_page DEPENDS "${dist}/web/index.html")
