// The characters of Dear ImGui as a texture of OpenGL.
#pragma once

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace braitenlab {

// Uploads all characters again. From 1.92 on Dear ImGui uploads them itself, when they are first used.
inline void upload_atlas() {
#if IMGUI_VERSION_NUM < 19200
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

}  // namespace braitenlab
