# Toolchain: WebAssembly by Debian's emscripten.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
string(APPEND CMAKE_CXX_FLAGS_INIT " -fexceptions")
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT " -fexceptions -sALLOW_MEMORY_GROWTH=1")
