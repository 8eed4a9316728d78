#include "ui/widgets/theme.h"

#include <cmath>
#include <filesystem>

#include "ui/imgui_compat.h"

namespace braitenlab::ui {

namespace {

// The type scale by role, em in layout pixels. Every text of the window has one of these sizes; only the texts of
// diagrams grow with the zoom.
constexpr float label_em = 12, small_em = 14, text_em = 16, title_em = 20, caption_em = 28, display_em = 48;

constexpr ImWchar latin[]{0x0020, 0x017F,  // Latin, Latin-1, Latin Extended-A
                          0x0370, 0x03FF,  // Greek: θ, Σ, π
                          0x2010, 0x2027,  // dashes, quotation marks, …
                          0x2039, 0x203A,  // ‹ ›
                          0x2080, 0x2089,  // subscripts, which fonts of symbols may lack
                          0};
constexpr ImWchar signs[]{0x2070, 0x209F,  // superscripts, subscripts
                          0x2190, 0x21FF,  // arrows
                          0x2200, 0x22FF,  // − ≥ ≤ ≈ √
                          0x25A0, 0x25FF,  // ▶ ● ■
                          0x2713, 0x2718,  // ✓ ✗
                          0};
constexpr ImWchar icon_range[]{0xF000, 0xF2FF, 0};

float channel_luminance(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }

float luminance(Colour c) {
    return 0.2126f * channel_luminance(c.r) + 0.7152f * channel_luminance(c.g) + 0.0722f * channel_luminance(c.b);
}

ImVec4 vec(Colour c) { return {c.r, c.g, c.b, c.a}; }

bool readable(const std::string& file) {
    std::error_code error;
    return !file.empty() && std::filesystem::is_regular_file(file, error);
}

class FontLoader {
public:
    FontLoader(ImFontAtlas& atlas, float scale, const FontPaths& paths) : atlas_(atlas), scale_(scale), paths_(paths) {}

    ImFont* load(const std::string& file, float em, bool with_icons) {
        const float pixels = whole_pixels(em);
        ImFont* font = nullptr;
        if (readable(file)) font = atlas_.AddFontFromFileTTF(file.c_str(), pixels, nullptr, latin);
        if (!font) {
            miss(file, "Dear ImGui's own font is used");
            ImFontConfig config;
            config.SizePixels = std::round(0.8f * pixels);
            font = atlas_.AddFontDefault(&config);
        }
        for (const std::string& symbols : paths_.symbols) merge(symbols, pixels, signs, {}, "some signs show as '?'");
        // Glyphs of Fork Awesome are larger than the em. They are scaled down and moved down to be level with words.
        // Some are as wide as their advance, so that a letter would touch them.
        if (with_icons)
            merge(paths_.icons, std::round(em * 1.16f * scale_), icon_range, {0, em * 0.08f * scale_},
                  "buttons show words only", std::round(em * 0.4f * scale_));
        return font;
    }

    // A large face for figures: Latin-1, and the minus sign, which text faces lack.
    ImFont* load_figures(const std::string& file, float em) {
        static constexpr ImWchar letters[]{0x0020, 0x00FF, 0}, minus[]{0x2212, 0x2212, 0};
        if (!readable(file)) return nullptr;
        ImFont* font = atlas_.AddFontFromFileTTF(file.c_str(), whole_pixels(em), nullptr, letters);
        for (const std::string& symbols : paths_.symbols)
            merge(symbols, whole_pixels(em), minus, {}, "some signs show as '?'");
        return font;
    }

    std::string warning;

private:
    // Not smaller than the role's size by more than a tenth of a pixel.
    float whole_pixels(float em) const { return std::ceil(em * line_height_em * scale_ - 0.1f); }

    // `space`: added to the width of each glyph, window pixels, half of it on each side.
    void merge(const std::string& file, float pixels, const ImWchar* range, ImVec2 shift, const char* instead,
               float space = 0) {
        if (!readable(file)) return miss(file, instead);
        ImFontConfig config;
        config.MergeMode = true;
        config.GlyphOffset = {shift.x + space / 2, shift.y};
        compat::set_glyph_space(config, space);
        atlas_.AddFontFromFileTTF(file.c_str(), pixels, &config, range);
    }

    void miss(const std::string& file, const char* instead) {
        if (warning.empty())
            warning = "font " + (file.empty() ? "file not given" : file + " not found") + ": " + instead;
    }

    ImFontAtlas& atlas_;
    float scale_;
    const FontPaths& paths_;
};

}  // namespace

ImU32 paint(Colour c) { return ImGui::ColorConvertFloat4ToU32(vec(c)); }

float contrast(Colour a, Colour b) {
    const float la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05f) / (std::min(la, lb) + 0.05f);
}

Colour legible(Colour wanted, Colour ground, Colour text) {
    constexpr int steps = 20;
    for (int i = 0; i <= steps; ++i) {
        const Colour tried = mix(wanted, text, static_cast<float>(i) / steps);
        if (contrast(tried, ground) >= 4.5f) return tried;
    }
    return text;
}

void apply_theme(Theme theme, float scale) {
    const Palette p = palette(theme);
    ImGuiStyle style;
    style.WindowPadding = {16, 16};
    style.FramePadding = {8, 6};
    style.ItemSpacing = {8, 8};
    style.ItemInnerSpacing = {8, 4};
    style.ScrollbarSize = 8;
    style.GrabMinSize = 24;
    style.WindowRounding = style.ChildRounding = style.FrameRounding = style.PopupRounding = radius::box;
    style.ScrollbarRounding = style.GrabRounding = radius::box;
    style.WindowBorderSize = 0;
    style.PopupBorderSize = scale;
    style.ScaleAllSizes(scale);

    auto& c = style.Colors;
    const Colour clear{0, 0, 0, 0};
    for (ImVec4& colour : c) colour = vec(p.raised);
    c[ImGuiCol_Text] = vec(p.text);
    c[ImGuiCol_TextDisabled] = vec(p.second_text);
    c[ImGuiCol_WindowBg] = c[ImGuiCol_ChildBg] = c[ImGuiCol_ScrollbarBg] = vec(clear);
    c[ImGuiCol_PopupBg] = vec(p.raised);
    c[ImGuiCol_Border] = c[ImGuiCol_Separator] = vec(p.line);
    c[ImGuiCol_BorderShadow] = vec(clear);
    c[ImGuiCol_FrameBg] = c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_FrameBgActive] = vec(p.raised);
    c[ImGuiCol_ScrollbarGrab] = vec(mix(p.panel, p.second_text, 0.75f));
    c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = vec(p.second_text);
    c[ImGuiCol_Button] = vec(p.raised);
    c[ImGuiCol_ButtonHovered] = c[ImGuiCol_ButtonActive] = vec(p.line);
    c[ImGuiCol_Header] = c[ImGuiCol_HeaderHovered] = c[ImGuiCol_HeaderActive] = vec(p.line);
    c[ImGuiCol_TextSelectedBg] = vec(p.accent.with_alpha(0.45f));
    c[ImGuiCol_NavHighlight] = vec(clear);  // the widgets draw their own ring
    ImGui::GetStyle() = style;
}

LoadedFonts load_fonts(ImFontAtlas& atlas, float scale, const FontPaths& paths) {
    compat::use_freetype(atlas);
    FontLoader loader(atlas, scale, paths);
    LoadedFonts loaded;
    loaded.fonts.text = loader.load(paths.text, text_em, true);
    loaded.fonts.strong = loader.load(paths.title, text_em, true);
    loaded.fonts.title = loader.load(paths.title, title_em, true);
    loaded.fonts.display = loader.load_figures(paths.title, display_em);
    loaded.fonts.small = loader.load(paths.text, small_em, true);
    loaded.fonts.label = loader.load(paths.text, label_em, true);
    loaded.fonts.caption = loader.load(paths.title, caption_em, false);
    loaded.warning = loader.warning;
    return loaded;
}

}  // namespace braitenlab::ui
