// Every call that differs between Dear ImGui 1.86 (Debian 12) and 1.92, wrapped once.
#pragma once

#include <imgui.h>
#include <imgui_freetype.h>
#include <imgui_internal.h>

namespace braitenlab::compat {

inline bool begin_child(const char* id, ImVec2 size, ImGuiWindowFlags flags = 0) {
#if IMGUI_VERSION_NUM >= 19000
    return ImGui::BeginChild(id, size, ImGuiChildFlags_None, flags);
#else
    return ImGui::BeginChild(id, size, false, flags);
#endif
}

inline void push_font(ImFont* font) {
#if IMGUI_VERSION_NUM >= 19200
    ImGui::PushFont(font, font ? font->LegacySize : 0.0f);
#else
    ImGui::PushFont(font);
#endif
}

// The size a font was loaded at, in window pixels.
inline float size_of(const ImFont* font) {
#if IMGUI_VERSION_NUM >= 19200
    return font->LegacySize;
#else
    return font->FontSize;
#endif
}

inline bool has_glyph(ImFont* font, ImWchar glyph) {
#if IMGUI_VERSION_NUM >= 19200
    return font->IsGlyphInFont(glyph);
#else
    return font->FindGlyphNoFallback(glyph) != nullptr;
#endif
}

inline void outline(ImDrawList& draw, ImVec2 a, ImVec2 b, ImU32 colour, float rounding, float thickness) {
#if IMGUI_VERSION_NUM >= 19280
    draw.AddRect(a, b, colour, rounding, thickness);
#else
    draw.AddRect(a, b, colour, rounding, 0, thickness);
#endif
}

inline void polyline(ImDrawList& draw, const ImVec2* points, int count, ImU32 colour, bool closed, float thickness) {
#if IMGUI_VERSION_NUM >= 19280
    draw.AddPolyline(points, count, colour, thickness, closed ? ImDrawFlags_Closed : ImDrawFlags_None);
#else
    draw.AddPolyline(points, count, colour, closed ? ImDrawFlags_Closed : ImDrawFlags_None, thickness);
#endif
}

// How long the pointer has been over the widget that it is over.
inline float hovered_seconds() { return GImGui->HoveredIdTimer; }

// Glyphs by FreeType, hinted lightly, instead of stb_truetype: crisper at text sizes.
inline void use_freetype(ImFontAtlas& atlas) {
#if IMGUI_VERSION_NUM >= 19200
    atlas.SetFontLoader(ImGuiFreeType::GetFontLoader());
#else
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
#endif
}

}  // namespace braitenlab::compat
