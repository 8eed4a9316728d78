#include "app/lettering.h"

#include <cmath>
#include <utility>

#include "ui/imgui_compat.h"

namespace braitenlab {

render::Lettering lettering_of(ImFont& font) {
    render::Lettering lettering(static_cast<int>(std::lround(compat::size_of(&font))));
    compat::each_glyph(font, [&](const compat::GlyphPicture& g) {
        lettering.add(g.character, g.width, g.height, g.grey, g.pitch, g.left, g.top, g.advance);
    });
    return lettering;
}

LabelFont label_font(const render::FindFont& find, int pixels, ImFont& fallback) {
    auto lettering = render::Lettering::from_fonts(find, pixels);
    if (lettering) return {std::move(*lettering), {}};
    return {lettering_of(fallback), "labels use the window's own font: " + lettering.error().text()};
}

}  // namespace braitenlab
