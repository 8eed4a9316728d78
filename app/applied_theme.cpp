#include "app/applied_theme.h"

#include <cmath>
#include <filesystem>
#include <utility>
#include <vector>

#include "app/files/data.h"
#include "ui/imgui_compat.h"

namespace braitenlab {

namespace {

// The font of this name among the shipped files; an empty path if fonts are not shipped, as where the system has them.
std::filesystem::path shipped_font(const std::filesystem::path& name) {
    const auto data = data_folder();
    return data ? first_existing({*data / "fonts" / name}) : std::filesystem::path{};
}

ui::FontPaths installed_fonts() {
    const auto face = [](const std::vector<std::filesystem::path>& candidates) {
        const auto shipped = shipped_font(candidates.front().filename());
        return shipped.empty() ? first_existing(candidates).string() : shipped.string();
    };
    ui::FontPaths paths;
    paths.text =
        face({"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf", "/usr/share/fonts/noto/NotoSans-Regular.ttf",
              "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf"});
    paths.title =
        face({"/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf", "/usr/share/fonts/noto/NotoSans-Bold.ttf",
              "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", "/usr/share/fonts/dejavu/DejaVuSans-Bold.ttf"});
    paths.icons = face({"/usr/share/fonts/truetype/fork-awesome/forkawesome-webfont.ttf",
                        "/usr/share/fonts-fork-awesome/fonts/forkawesome-webfont.ttf"});
    paths.symbols = {face({"/usr/share/fonts/truetype/noto/NotoSansMono-Regular.ttf",
                           "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"}),
                     face({"/usr/share/fonts/truetype/noto/NotoSansMath-Regular.ttf"}),
                     face({"/usr/share/fonts/truetype/noto/NotoSansSymbols2-Regular.ttf"})};
    return paths;
}

render::Lettering lettering_of(ImFont& font) {
    render::Lettering lettering(static_cast<int>(std::lround(compat::size_of(&font))));
    compat::each_glyph(font, [&](const compat::GlyphPicture& g) {
        lettering.add(g.character, g.width, g.height, g.grey, g.pitch, g.left, g.top, g.advance);
    });
    return lettering;
}

}  // namespace

bool AppliedTheme::apply(Theme theme, float scale) {
    if (theme == theme_ && scale == scale_) return false;
    theme_ = theme;
    ui::apply_theme(theme, scale);
    if (scale == scale_) return false;
    scale_ = scale;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    loaded_ = ui::load_fonts(atlas, scale, installed_fonts());
    return true;
}

std::string find_label_font(char32_t c) {
    const bool mathematical = c >= 0x2190 && c < 0x2300;  // arrows and operators, such as the minus sign
    const auto shipped = shipped_font(c == 0         ? "NotoSans-Regular.ttf"
                                      : mathematical ? "NotoSansMath-Regular.ttf"
                                                     : "NotoSansSymbols2-Regular.ttf");
    return shipped.empty() ? render::find_font(c) : shipped.string();
}

LabelFont label_font(const render::FindFont& find, int pixels, ImFont& fallback) {
    auto lettering = render::Lettering::from_fonts(find, pixels);
    if (lettering) return {std::move(*lettering), {}};
    return {lettering_of(fallback), "labels use the window's own font: " + lettering.error().text()};
}

}  // namespace braitenlab
