#include "render/view/draw_list.h"

#include <algorithm>
#include <cmath>

#include "render/view/drawing.h"

namespace braitenlab::render {

void DrawList::clear() {
    for (auto& of_role : hulls) of_role.clear();
    for (auto& of_role : signs) of_role.clear();
    for (auto& of_shape : sources) of_shape.clear();
    for (auto& of_role : bodies) of_role.clear();
    tyres.clear(), eyeballs.clear(), deck_shades.clear(), casts.clear();
    floor_lamps = 0, coarse = true;
    wheels.clear(), eyes.clear(), wires.clear(), neurons.clear(), labels.clear(), label_space = {}, fields.clear(),
                                                                                  blocks.clear(), zones.clear();
    marks.clear(), rings.clear(), halos.clear(), trails.clear(), lamps.clear();
}

int source_shape_of(Channel channel) {
    return channel == Channel::heat ? 1 : channel == Channel::smell ? 2 : channel == Channel::oxygen ? 3 : 0;
}

LightLaw light_law(const Scene& scene) {
    LightLaw law{0, 0};
    for (const Kind& kind : scene.kinds)
        for (const Sensor& sensor : kind.sensors)
            if (sensor.response == SensorResponse::graded && sensor.channel == Channel::light)
                law = {std::max(law.half_distance, sensor.half_distance), std::max(law.range, sensor.range)};
    if (law.range > 0) return law;
    // Of photocells: as far as the brightest lamp gives half of their range.
    for (const Source& source : scene.sources)
        for (const Kind& kind : scene.kinds)
            for (const Sensor& sensor : kind.sensors)
                if (sensor.response == SensorResponse::photocell && sensor.channel == Channel::light &&
                    source.candela > 0)
                    law = {std::max(law.half_distance, std::sqrt(source.candela / sensor.half_lux)),
                           std::max(law.range, sensor.range)};
    return law.range > 0 ? law : LightLaw{};
}

void fill(DrawList& list, const Snapshot& now, const Picture& picture, const Trails& trails) {
    list.clear();
    list.law = now.scene ? light_law(*now.scene) : LightLaw{};
    const float count = static_cast<float>(now.vehicles.size());
    Drawing drawing{list,
                    now,
                    picture,
                    palette(picture.theme),
                    picture.camera_view.projection * picture.camera_view.view,
                    std::min(1.0f, std::sqrt(8 / std::max(count, 1.0f)))};
    if (now.scene) drawing.scale = scale_of(now.scene->arena);
    add_world(drawing);
    add_vehicles(drawing, trails);
    add_darkness(drawing);
    add_labels(drawing);
    list.decks.forget_unused();
}

}  // namespace braitenlab::render
