#include "ui/wiring/minimap.h"

#include <algorithm>

namespace braitenlab {

using maths::vec2;

std::optional<Minimap> minimap_of(const Layout& layout, const View& view, Rect area, float ui_scale) {
    constexpr float width = 176, height = 112, away = 12, margin = 6;  // layout pixels
    if (layout.nodes.size() < minimap_from) return {};
    if (area.w < 2.5f * width * ui_scale || area.h < 2.5f * height * ui_scale) return {};
    const vec2 low = view.to_window(layout.low), high = view.to_window(layout.high);
    if (area.contains(low.x, low.y) && area.contains(high.x, high.y)) return {};
    Minimap map;
    map.rect = {area.x + area.w - (width + away) * ui_scale, area.y + area.h - (height + away) * ui_scale,
                width * ui_scale, height * ui_scale};
    const vec2 size = layout.high - layout.low, room = vec2{width - 2 * margin, height - 2 * margin} * ui_scale;
    map.view.scale = std::min(room.x / size.x, room.y / size.y);
    const vec2 middle{map.rect.x + map.rect.w / 2, map.rect.y + map.rect.h / 2};
    map.view.origin = middle - (layout.low + layout.high) / 2 * map.view.scale;
    return map;
}

}  // namespace braitenlab
