#include "render/view/draw_list.h"

#include <algorithm>
#include <cmath>

#include "render/view/drawing.h"

namespace braitenlab::render {

void DrawList::clear() {
    for (auto& of_role : hulls) of_role.clear();
    for (auto& of_role : signs) of_role.clear();
    for (auto& of_shape : sources) of_shape.clear();
    wheels.clear(), eyes.clear(), wires.clear(), neurons.clear(), labels.clear(), fields.clear(), blocks.clear(),
        zones.clear();
    marks.clear(), rings.clear(), halos.clear(), trails.clear(), lamps.clear();
}

int source_shape_of(Channel channel) {
    return channel == Channel::heat ? 1 : channel == Channel::smell ? 2 : channel == Channel::oxygen ? 3 : 0;
}

void fill(DrawList& list, const Snapshot& now, const Picture& picture, const Trails& trails) {
    list.clear();
    const float count = static_cast<float>(now.vehicles.size());
    Drawing drawing{list,
                    now,
                    picture,
                    palette(picture.theme),
                    picture.camera_view.projection * picture.camera_view.view,
                    std::min(1.0f, std::sqrt(8 / std::max(count, 1.0f)))};
    add_world(drawing);
    add_vehicles(drawing, trails);
    add_labels(drawing);
    list.decks.forget_unused();
}

}  // namespace braitenlab::render
