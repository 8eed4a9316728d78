# Toolchain: WebAssembly by Debian's emscripten. Exceptions and setjmp (in FreeType) are those of WebAssembly, which cost
# nothing until one is thrown; browsers have them since 2022.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
set(exceptions " -fwasm-exceptions -sSUPPORT_LONGJMP=wasm")
string(APPEND CMAKE_C_FLAGS_INIT "${exceptions}")
string(APPEND CMAKE_CXX_FLAGS_INIT "${exceptions}")
string(APPEND CMAKE_EXE_LINKER_FLAGS_INIT "${exceptions} -sALLOW_MEMORY_GROWTH=1")
