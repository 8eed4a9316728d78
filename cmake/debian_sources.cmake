# Libraries for a platform that Debian has no packages for: compiled from Debian's source packages, which ./dev fetches
# into BRAITENLAB_SOURCES. Libraries of headers alone come from the installed packages.
#
# CMake reads this file before the project (CMAKE_PROJECT_TOP_LEVEL_INCLUDES). From then on find_package calls
# braitenlab_find, so that the project's own files are the same on every platform.
set(BRAITENLAB_SOURCES "" CACHE PATH "Folder of the unpacked Debian source packages")
set(headers "${CMAKE_BINARY_DIR}/headers")

# Headers of installed packages, without the C library's headers beside them.
function(link_headers)
  file(MAKE_DIRECTORY "${headers}")
  foreach(folder IN LISTS ARGN)
    file(CREATE_LINK "/usr/include/${folder}" "${headers}/${folder}" SYMBOLIC)
  endforeach()
endfunction()

# source_folder(VARIABLE PACKAGE)
function(source_folder variable package)
  file(GLOB found LIST_DIRECTORIES true "${BRAITENLAB_SOURCES}/${package}-*")
  if(NOT found)
    message(FATAL_ERROR "The source package ${package} is not in '${BRAITENLAB_SOURCES}'; ./dev fetches it.")
  endif()
  list(GET found 0 folder)
  set(${variable} "${folder}" PARENT_SCOPE)
endfunction()

# header_library(TARGET FOLDER…)
function(header_library target)
  link_headers(${ARGN})
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} INTERFACE "${headers}")
endfunction()

# source_library(TARGET INCLUDE SOURCES…): a static library with the namespace of its package. Without warnings, and
# without fused multiply-add like the project itself: the simulation has the same bits on every platform.
function(source_library target include)
  string(REPLACE "::" "_" name "${target}")
  add_library(${name} STATIC ${ARGN})
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  target_include_directories(${name} SYSTEM PUBLIC ${include})
  target_compile_options(${name} PRIVATE -w -ffp-contract=off)
  add_library(${target} ALIAS ${name})
endfunction()

function(provide_box2d)
  source_folder(folder box2d)
  file(GLOB_RECURSE sources "${folder}/src/*.cpp")
  list(FILTER sources EXCLUDE REGEX "b2_timer.cpp")  # core/world/physics.cpp has another one
  source_library(box2d::box2d "${folder}/include" ${sources})
  target_include_directories(box2d_box2d PRIVATE "${folder}/src")
  # In a third of the time, with the same bits.
  set_target_properties(box2d_box2d PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
endfunction()

function(provide_ZLIB)
  source_folder(folder zlib)
  file(GLOB sources "${folder}/*.c")
  source_library(ZLIB::ZLIB "${folder}" ${sources})
  target_compile_definitions(ZLIB_ZLIB PRIVATE HAVE_UNISTD_H)
endfunction()

# Without decryption, and with the C library's own functions of files.
function(provide_minizip)
  source_folder(folder minizip)
  source_library(braitenlab::minizip "${folder}" "${folder}/unzip.c" "${folder}/ioapi.c")
  target_compile_definitions(braitenlab_minizip PRIVATE NOUNCRYPT USE_FILE32API)
  target_link_libraries(braitenlab_minizip PUBLIC ZLIB::ZLIB)
endfunction()

function(provide_fmt)
  header_library(fmt::fmt fmt)
  target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
endfunction()

function(provide_nlohmann_json)
  header_library(nlohmann_json::nlohmann_json nlohmann)
endfunction()

function(provide_tomlplusplus)
  header_library(tomlplusplus::tomlplusplus toml++)
endfunction()

function(provide_CLI11)
  header_library(CLI11::CLI11 CLI)
endfunction()

function(provide_glfw3)
  source_folder(folder glfw3)
  foreach(option GLFW_BUILD_EXAMPLES GLFW_BUILD_TESTS GLFW_BUILD_DOCS GLFW_INSTALL)
    set(${option} OFF CACHE BOOL "")
  endforeach()
  set(CMAKE_UNITY_BUILD OFF)
  add_subdirectory("${folder}" "${CMAKE_BINARY_DIR}/glfw" EXCLUDE_FROM_ALL)
  target_compile_options(glfw PRIVATE -w)
endfunction()

function(provide_GLEW)
  source_folder(folder glew)
  source_library(GLEW::GLEW "${folder}/include" "${folder}/src/glew.c")
  target_compile_definitions(GLEW_GLEW PUBLIC GLEW_STATIC GLEW_NO_GLU)
  target_link_libraries(GLEW_GLEW PUBLIC OpenGL::GL)
endfunction()

function(provide_freetype2)
  source_folder(folder freetype)
  foreach(library BZIP2 PNG HARFBUZZ BROTLI)
    set(FT_DISABLE_${library} ON CACHE BOOL "")
  endforeach()
  # The zlib of the project: FreeType's own copy would have the same names.
  set(FT_DISABLE_ZLIB OFF CACHE BOOL "" FORCE)
  find_package(ZLIB REQUIRED)
  set(ZLIB_LIBRARIES ZLIB::ZLIB)
  set(CMAKE_UNITY_BUILD OFF)
  set(SKIP_INSTALL_ALL ON)
  add_subdirectory("${folder}" "${CMAKE_BINARY_DIR}/freetype" EXCLUDE_FROM_ALL)
  target_compile_options(freetype PRIVATE -w)
endfunction()

function(provide_imgui)
  source_folder(folder imgui)
  file(GLOB sources "${folder}/imgui*.cpp")
  set(include "${folder};${folder}/misc/freetype;${folder}/misc/cpp")
  set(backends "${folder}/backends/imgui_impl_opengl3.cpp")
  set(dialect IMGUI_IMPL_OPENGL_ES3)
  if(NOT EMSCRIPTEN)
    list(APPEND backends "${folder}/backends/imgui_impl_glfw.cpp")
    set(dialect IMGUI_IMPL_OPENGL_LOADER_GLEW)
  endif()
  source_library(braitenlab::imgui "${include}" ${sources} "${folder}/misc/freetype/imgui_freetype.cpp"
    "${folder}/misc/cpp/imgui_stdlib.cpp" ${backends})
  link_headers(stb)
  target_include_directories(braitenlab_imgui PRIVATE "${headers}/stb")
  target_compile_definitions(braitenlab_imgui PRIVATE IMGUI_ENABLE_FREETYPE ${dialect})
  if(EMSCRIPTEN)
    # Indices of 32 bits: WebGL 2 has no first vertex for a draw call, so 16 bits would end a list at 65,536 vertices.
    target_compile_definitions(braitenlab_imgui PUBLIC ImDrawIdx=unsigned)
  endif()
  find_package(glfw3 REQUIRED)
  find_package(GLEW REQUIRED)
  target_link_libraries(braitenlab_imgui PRIVATE freetype glfw GLEW::GLEW)
endfunction()

# pkg-config knows the libraries of this system only: pkg_check_modules gets those of the other platform. It is defined
# after FreeType is added, whose file includes CMake's own.
function(provide_PkgConfig)
  provide_once(freetype2)
  function(pkg_check_modules prefix)
    list(GET ARGN -1 module)
    set(library_of_freetype2 freetype)
    set(library_of_imgui braitenlab::imgui)
    set(library_of_minizip braitenlab::minizip)
    set(library_of_stb braitenlab::stb)
    if(NOT DEFINED library_of_${module})
      set(${prefix}_FOUND FALSE PARENT_SCOPE)
      return()
    endif()
    provide_once(${module})
    if(NOT TARGET PkgConfig::${prefix})
      add_library(PkgConfig::${prefix} INTERFACE IMPORTED GLOBAL)
      target_link_libraries(PkgConfig::${prefix} INTERFACE ${library_of_${module}})
    endif()
    set(${prefix}_FOUND TRUE PARENT_SCOPE)
  endfunction()
endfunction()

function(provide_stb)
  source_folder(folder libstb)
  file(CONFIGURE OUTPUT "${CMAKE_BINARY_DIR}/stb_image.c" @ONLY
       CONTENT "#define STB_IMAGE_IMPLEMENTATION\n#include <stb_image.h>\n")
  source_library(braitenlab::stb "${folder}" "${CMAKE_BINARY_DIR}/stb_image.c")
endfunction()

if(EMSCRIPTEN)
  function(provide_Threads)  # there are none; the program asks std::thread for their number only
    add_library(Threads::Threads INTERFACE IMPORTED GLOBAL)
  endfunction()

  # The browser has OpenGL ES 3, and app/platform/web_window.cpp is the window.
  function(provide_OpenGL)
    add_library(OpenGL::GL INTERFACE IMPORTED GLOBAL)
  endfunction()

  function(provide_GLEW)
    add_library(GLEW::GLEW INTERFACE IMPORTED GLOBAL)
  endfunction()

  function(provide_glfw3)
    add_library(glfw INTERFACE IMPORTED GLOBAL)
  endfunction()
endif()

# googletest's package has its sources.
function(provide_GTest)
  set(folder /usr/src/googletest/googletest)
  link_headers(gtest glm)
  source_library(GTest::gtest_main "${headers}" "${folder}/src/gtest-all.cc" "${folder}/src/gtest_main.cc")
  target_include_directories(GTest_gtest_main PRIVATE "${folder}")
endfunction()

function(provide_once package)
  get_property(provided GLOBAL PROPERTY braitenlab_provided_${package})
  if(NOT provided)
    set_property(GLOBAL PROPERTY braitenlab_provided_${package} TRUE)
    cmake_language(CALL provide_${package})
  endif()
endfunction()

macro(braitenlab_find method package)
  if(COMMAND provide_${package})
    provide_once(${package})
    set(${package}_FOUND TRUE)
  endif()
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER braitenlab_find SUPPORTED_METHODS FIND_PACKAGE)
