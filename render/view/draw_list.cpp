#include "render/view/draw_list.h"

#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "render/view/sheet.h"

namespace braitenlab {

using maths::vec2;
using maths::vec4;

namespace {

void add_sources(Sheet& sheet) {
    const bool dark = sheet.picture.theme == Theme::dark;
    for (const SourceView& source : sheet.now.sources) {
        const Colour colour = colour_of(sheet.colours, source.channel);
        const float size = 0.8f + 0.35f * source.strength, bulb = 0.52f * size;
        const auto shape = static_cast<std::size_t>(source_shape_of(source.channel));
        sheet.list.sources[shape].push_back({{source.x, source.y, size, source.strength}, rgb_with(colour, 1)});
        const vec4 place{source.x, source.y, 1, 0};
        const float pool = 1.6f + 2.4f * source.strength;
        sheet.list.marks.push_back({place,
                                    {pool, pool, 0, static_cast<float>(MarkKind::pool)},
                                    rgb_with(colour, (dark ? 0.42f : 0.26f) * (0.35f + 0.65f * source.strength))});
        sheet.list.marks.push_back({place,
                                    {0.22f * size, 0.22f * size, 0.12f, static_cast<float>(MarkKind::shadow)},
                                    rgb_with(sheet.colours.shadow, sheet.colours.shadow.a * 0.7f)});
        sheet.list.halos.push_back({{source.x, source.y, bulb, (dark ? 1.25f : 0.85f) * size},
                                    rgb_with(colour, (dark ? 0.75f : 0.5f) * (0.3f + 0.7f * source.strength))});
        if (sheet.list.lamps.size() < most_lamps)
            sheet.list.lamps.push_back({{source.x, bulb, -source.y, source.strength}, rgb_with(colour, 2.0f)});
    }
}

void add_blocks(Sheet& sheet) {
    if (!sheet.now.scene) return;
    const Scene& scene = *sheet.now.scene;
    const float half_w = scene.arena.width / 2, half_h = scene.arena.height / 2;
    if (scene.arena.edge == Edge::wall) {
        constexpr float thick = 0.11f, high = 0.35f, chamfer = 0.035f;  // half the thickness; m
        const vec4 colour = rgb_with(sheet.colours.wall, 1);
        for (const float side : {-1.0f, 1.0f}) {
            sheet.list.blocks.push_back(
                {{0, side * (half_h + thick), 1, 0}, {half_w + 2 * thick, thick, high, chamfer}, colour});
            sheet.list.blocks.push_back({{side * (half_w + thick), 0, 0, 1}, {half_h, thick, high, chamfer}, colour});
        }
    }
    for (const Obstacle& box : scene.obstacles) {
        const vec2 ahead = maths::direction(box.heading);
        const vec4 place{box.x, box.y, ahead.x, ahead.y};
        sheet.list.blocks.push_back(
            {place, {box.length / 2, box.width / 2, 0.42f, 0.045f}, rgb_with(sheet.colours.obstacle, 0)});
        sheet.list.marks.push_back({place,
                                    {box.length / 2, box.width / 2, 0.22f, static_cast<float>(MarkKind::shadow)},
                                    rgb_with(sheet.colours.shadow, sheet.colours.shadow.a * 0.8f)});
    }
}

}  // namespace

void DrawList::clear() {
    for (auto& of_role : hulls) of_role.clear();
    for (auto& of_role : signs) of_role.clear();
    for (auto& of_shape : sources) of_shape.clear();
    wheels.clear(), eyes.clear(), wires.clear(), fields.clear(), blocks.clear();
    marks.clear(), rings.clear(), halos.clear(), trails.clear(), lamps.clear();
}

int source_shape_of(Channel channel) {
    return channel == Channel::heat ? 1 : channel == Channel::smell ? 2 : channel == Channel::oxygen ? 3 : 0;
}

void fill(DrawList& list, const Snapshot& now, const Picture& picture, const Trails& trails) {
    list.clear();
    const float count = static_cast<float>(now.vehicles.size());
    Sheet sheet{list,
                now,
                picture,
                palette(picture.theme),
                picture.sight.projection * picture.sight.view,
                std::min(1.0f, std::sqrt(8 / std::max(count, 1.0f)))};
    add_sources(sheet);
    add_blocks(sheet);
    add_vehicles(sheet, trails);
}

}  // namespace braitenlab
