#include "render/gl/frame.h"

#include <algorithm>
#include <cmath>

namespace braitenlab::render {

namespace {

maths::vec4 four(Colour c) { return {c.r, c.g, c.b, c.a}; }

bool senses_light(const Scene& scene) {
    return std::any_of(scene.kinds.begin(), scene.kinds.end(), [](const Kind& kind) {
        return std::any_of(kind.sensors.begin(), kind.sensors.end(),
                           [](const Sensor& sensor) { return is_seen_as(Channel::light, sensor.channel); });
    });
}

}  // namespace

FrameBlock frame_block(const Snapshot& now, const Picture& picture, const DrawList& list) {
    const Palette colours = palette(picture.theme);
    const bool light = picture.theme == Theme::light;
    const CameraView& camera_view = picture.camera_view;
    const auto row = [&](int i) {
        return maths::vec4{camera_view.view[0][i], camera_view.view[1][i], camera_view.view[2][i], 0};
    };
    // At dusk scenes without eyes for light are brighter: else their vehicles are darker than their trails.
    const float brighter = now.scene && senses_light(*now.scene) ? 1.0f : 1.25f;
    const auto at_dusk = [brighter](float r, float g, float b) {
        return maths::vec4{r * brighter, g * brighter, b * brighter, 0};
    };
    FrameBlock block;
    block.view_projection = camera_view.projection * camera_view.view;
    block.eye = {camera_view.eye.x, camera_view.eye.y, camera_view.eye.z,
                 camera_view.projection[1].y * camera_view.window.h / 2};
    block.right = row(0), block.up = row(1);
    const maths::vec3 sun = maths::normalise(to_gl({sun_direction.x, sun_direction.y}, sun_direction.z));
    block.sun = {sun.x, sun.y, sun.z, 0};
    block.sun_light = light ? maths::vec4{0.62f, 0.61f, 0.57f, 0} : at_dusk(0.53f, 0.52f, 0.50f);
    block.sky_light = light ? maths::vec4{0.50f, 0.51f, 0.53f, 0} : at_dusk(0.18f, 0.22f, 0.28f);
    block.ground_light = light ? maths::vec4{0.56f, 0.54f, 0.50f, 0} : at_dusk(0.08f, 0.085f, 0.10f);
    block.sky = four(colours.sky), block.floor_colour = four(colours.floor), block.grid_colour = four(colours.grid);
    block.ink = four(colours.wheel), block.paper = light ? four(colours.raised) : four(colours.text);
    block.shadow = four(colours.shadow);
    block.window = {camera_view.window.w, camera_view.window.h, camera_view.window.x, camera_view.window.y};
    const Arena arena = now.scene ? now.scene->arena : Arena{};
    // Wrapped to a common multiple of all periods in the shaders, to keep precision in long runs.
    block.arena = {arena.width / 2, arena.height / 2, static_cast<float>(std::fmod(now.seconds, 60.0)),
                   picture.pixel_scale};
    block.counts = {static_cast<float>(list.lamps.size()), light ? 1.0f : 0.0f,
                    arena.edge == Boundary::open ? 1e6f : 0.0f,
                    static_cast<float>(has_walls(arena.edge) ? Boundary::wall : arena.edge)};
    block.form = {arena.round ? 1.0f : 0.0f, scale_of(arena), grid_share(arena),
                  (light ? 0.016f : 0.010f) * grid_share(arena)};
    const auto inverse_square = [](float d) { return 1 / (d * d); };
    block.law = {inverse_square(list.law.half_distance), inverse_square(list.law.range),
                 static_cast<float>(list.floor_lamps), static_cast<float>(picture.quality)};
    for (std::size_t i = 0; i < list.lamps.size(); ++i) block.lamps[i] = list.lamps[i];
    return block;
}

FrameBlock at_resolution(FrameBlock block, float share) {
    block.eye.w *= share;
    const auto side = [&](float pixels) { return std::max(1.0f, std::round(pixels * share)); };  // as in Resampling
    block.window = {side(block.window.x), side(block.window.y), 0, 0};
    block.arena.w *= share;
    return block;
}

}  // namespace braitenlab::render
