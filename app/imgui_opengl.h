// What Dear ImGui's drawing needs of OpenGL besides its backend.
#pragma once

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "render/gl/opengl.h"

namespace braitenlab {

// Uploads all characters again. From 1.92 on Dear ImGui uploads them itself, when they are first used.
inline void upload_atlas() {
#if IMGUI_VERSION_NUM < 19200
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

// Fills the clip rectangle of the command with the opaque colour that UserCallbackData is (ImU32). A software renderer
// clears a rectangle many times faster than it draws two triangles with a texture and blending.
inline void fill_clip_rectangle(const ImDrawList*, const ImDrawCmd* command) {
    const ImDrawData& drawn = *ImGui::GetDrawData();
    const ImVec2 scale = drawn.FramebufferScale;
    const ImVec4 clip = command->ClipRect;
    const float left = (clip.x - drawn.DisplayPos.x) * scale.x, right = (clip.z - drawn.DisplayPos.x) * scale.x;
    const float top = (clip.y - drawn.DisplayPos.y) * scale.y, bottom = (clip.w - drawn.DisplayPos.y) * scale.y;
    if (right <= left || bottom <= top) return;
    glScissor(static_cast<int>(left), static_cast<int>(drawn.DisplaySize.y * scale.y - bottom),
              static_cast<int>(right - left), static_cast<int>(bottom - top));
    const ImVec4 colour =
        ImGui::ColorConvertU32ToFloat4(static_cast<ImU32>(reinterpret_cast<std::uintptr_t>(command->UserCallbackData)));
    glClearColor(colour.x, colour.y, colour.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace braitenlab
