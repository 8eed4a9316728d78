// Wrappers for all calls that differ between Dear ImGui 1.86 (Debian 12) and 1.92.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

// The end of a window, a child, a group, a popup or a tooltip reaches to the cursor, wherever it was set, as in 1.86.
// From 1.92 on Dear ImGui ends the program where the last thing in it is such a place and no item.
inline void reach_to_cursor() {
#if IMGUI_VERSION_NUM >= 19200
    ImGuiWindowTempData& places = ImGui::GetCurrentWindow()->DC;
    if (!places.IsSetPos) return;  // the cursor is below an item and the space after it
    places.CursorMaxPos.x = std::max(places.CursorMaxPos.x, places.CursorPos.x);
    places.CursorMaxPos.y = std::max(places.CursorMaxPos.y, places.CursorPos.y);
    places.IsSetPos = false;
#endif
}
inline void end_window() { reach_to_cursor(), ImGui::End(); }
inline void end_child() { reach_to_cursor(), ImGui::EndChild(); }
inline void end_group() { reach_to_cursor(), ImGui::EndGroup(); }
inline void end_popup() { reach_to_cursor(), ImGui::EndPopup(); }
inline void end_tooltip() { reach_to_cursor(), ImGui::EndTooltip(); }

// Gives the keyboard to the next text field. In 1.90.1 a field of a child window gets it only if that has the focus.
inline void focus_next_field() {
#if IMGUI_VERSION_NUM >= 19010 && IMGUI_VERSION_NUM < 19020
    ImGui::SetWindowFocus();
#endif
    ImGui::SetKeyboardFocusHere();
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

// Space added to the advance of each glyph of a font, in window pixels.
inline void set_glyph_space(ImFontConfig& config, float space) {
#if IMGUI_VERSION_NUM >= 19190
    config.GlyphExtraAdvanceX = space;
#else
    config.GlyphExtraSpacing.x = space;
#endif
}

inline bool has_glyph(ImFont* font, ImWchar glyph) {
#if IMGUI_VERSION_NUM >= 19200
    return font->IsGlyphInFont(glyph);
#else
    return font->FindGlyphNoFallback(glyph) != nullptr;
#endif
}

// From 1.92 on characters are added to the atlas when they are drawn first.
inline bool changes_textures([[maybe_unused]] const ImDrawData& drawn) {
#if IMGUI_VERSION_NUM >= 19200
    if (drawn.Textures)
        for (const ImTextureData* texture : *drawn.Textures)
            if (texture->Status != ImTextureStatus_OK) return true;
#endif
    return false;
}

// The texture of a number of the graphics library.
inline ImTextureID texture(std::uint64_t id) {
#if IMGUI_VERSION_NUM >= 19140
    return static_cast<ImTextureID>(id);
#else
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(id));
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

// A key by Dear ImGui's name, and the number that KeyQueue has for it.
struct NamedKey {
    ImGuiKey name;
    int number;
};
#if IMGUI_VERSION_NUM >= 18700
inline constexpr ImGuiKey keypad_enter = ImGuiKey_KeypadEnter;
#else
inline constexpr ImGuiKey keypad_enter = ImGuiKey_KeyPadEnter;
#endif

// Prepares a new context for input from KeyQueue and MouseQueue, which give each frame what it is to take. Dear ImGui
// has arrays for it up to 1.86; from 1.87 on it has a queue of events, all of which the next frame then takes.
inline void expect_input_of_frames(ImGuiIO& io, std::span<const NamedKey> keys) {
#if IMGUI_VERSION_NUM >= 18700
    io.ConfigInputTrickleEventQueue = false;
    (void)keys;
#else
    for (const NamedKey& each : keys) io.KeyMap[each.name] = each.number;
#endif
}

// Sets the only key that is down in the next frame, −1: none, and the modifiers.
inline void set_keys(ImGuiIO& io, std::span<const NamedKey> keys, int down, bool ctrl, bool shift, bool alt) {
#if IMGUI_VERSION_NUM >= 18700
    io.AddKeyEvent(ImGuiMod_Ctrl, ctrl), io.AddKeyEvent(ImGuiMod_Shift, shift), io.AddKeyEvent(ImGuiMod_Alt, alt);
    for (const NamedKey& each : keys) io.AddKeyEvent(each.name, each.number == down && each.name != keypad_enter);
#else
    (void)keys;
    for (bool& key : io.KeysDown) key = false;
    if (down >= 0 && down < IM_ARRAYSIZE(io.KeysDown)) io.KeysDown[down] = true;
    io.KeyCtrl = ctrl, io.KeyShift = shift, io.KeyAlt = alt;
#endif
}

// Sets the mouse of the next frame: window pixels, the left, right and middle button, notches of the wheel.
inline void set_mouse(ImGuiIO& io, ImVec2 at, std::span<const bool, 3> down, ImVec2 wheel) {
#if IMGUI_VERSION_NUM >= 18700
    io.AddMousePosEvent(at.x, at.y);
    for (int button = 0; button < 3; ++button) io.AddMouseButtonEvent(button, down[static_cast<std::size_t>(button)]);
    io.AddMouseWheelEvent(wheel.x, wheel.y);
#else
    io.MousePos = at;
    for (bool& each : io.MouseDown) each = false;
    std::copy(down.begin(), down.end(), io.MouseDown);
    io.MouseWheel += wheel.y, io.MouseWheelH += wheel.x;
#endif
}

// Time since the pointer entered the hovered widget, s.
inline float hovered_seconds() { return GImGui->HoveredIdTimer; }

// Rasterises with FreeType and light hinting instead of stb_truetype, which is less sharp at text sizes.
inline void use_freetype(ImFontAtlas& atlas) {
#if IMGUI_VERSION_NUM >= 19200
    atlas.SetFontLoader(ImGuiFreeType::GetFontLoader());
    atlas.FontLoaderFlags = ImGuiFreeTypeLoaderFlags_LightHinting;
#else
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
#endif
}

// For an atlas that belongs to no context, before the first frame of each context that uses it: from 1.92 on Dear ImGui
// asks for it.
inline void announce_atlas(ImFontAtlas& atlas) {
#if IMGUI_VERSION_NUM >= 19200
    static int frame = 0;  // one that it has not seen
    ImFontAtlasUpdateNewFrame(&atlas, ++frame, false);
#else
    (void)atlas;
#endif
}

// A rasterised character: rows of `pitch` bytes; `left` and `top` from the pen on the baseline, y down.
struct GlyphPicture {
    unsigned character = 0;
    int width = 0, height = 0;
    const unsigned char* grey = nullptr;
    int pitch = 0, left = 0, top = 0;
    float advance = 0;
};

// The atlas of a font; later versions of 1.92 have another name for the member.
template <class Font>
ImFontAtlas& atlas_of(Font& font) {
    if constexpr (requires { font.OwnerAtlas; })
        return *font.OwnerAtlas;
    else
        return *font.ContainerAtlas;
}

// Visits every character of the font's atlas. From 1.92 on characters are rasterised at their first use: visits those
// of Latin-1. The pixels are valid during the visit.
template <class Visit>
void each_glyph(ImFont& font, Visit visit) {
    ImFontAtlas& atlas = atlas_of(font);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0, bytes = 1;
    float ascent = 0;
    const auto whole = [](float v) { return static_cast<int>(v + (v < 0 ? -0.5f : 0.5f)); };
    const auto show = [&](const ImFontGlyph& g) {
        const int x0 = whole(g.U0 * static_cast<float>(width)), y0 = whole(g.V0 * static_cast<float>(height));
        const int x1 = whole(g.U1 * static_cast<float>(width)), y1 = whole(g.V1 * static_cast<float>(height));
        std::vector<unsigned char> grey;  // the last byte of each pixel: alpha
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) grey.push_back(pixels[(y * width + x) * bytes + bytes - 1]);
        visit(GlyphPicture{g.Codepoint, x1 - x0, y1 - y0, grey.data(), x1 - x0, whole(g.X0), whole(g.Y0 - ascent),
                           g.AdvanceX});
    };
#if IMGUI_VERSION_NUM >= 19200
    ImFontBaked& baked = *font.GetFontBaked(font.LegacySize);
    for (ImWchar c = 0x20; c < 0x100; ++c) {
        const ImFontGlyph* g = baked.FindGlyphNoFallback(c);
        if (!g) continue;
        const ImTextureData& texture = *atlas.TexData;  // another one once the former is full
        pixels = texture.Pixels, width = texture.Width, height = texture.Height, bytes = texture.BytesPerPixel;
        ascent = baked.Ascent;
        show(*g);
    }
#else
    atlas.GetTexDataAsAlpha8(&pixels, &width, &height);
    ascent = font.Ascent;
    for (const ImFontGlyph& g : font.Glyphs) show(g);
#endif
}

}  // namespace braitenlab::compat
