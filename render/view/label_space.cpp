#include "render/view/label_space.h"

#include <algorithm>

#include "render/view/pick.h"

namespace braitenlab {

namespace {

float overlap(const Rect& a, const Rect& b) {
    const float w = std::min(a.x + a.w, b.x + b.w) - std::max(a.x, b.x);
    const float h = std::min(a.y + a.h, b.y + b.h) - std::max(a.y, b.y);
    return std::max(w, 0.0f) * std::max(h, 0.0f);
}

Rect around(const CameraView& seen, maths::vec2 place, float height, float half_width, float half_height) {
    const auto at = project(seen, place, height);
    const float pixels = pixels_per_metre(seen, place, height);
    if (!at) return {};
    return {at->x - half_width * pixels, at->y - half_height * pixels, 2 * half_width * pixels,
            2 * half_height * pixels};
}

}  // namespace

Rect picture_of(const Snapshot& now, const CameraView& seen, const VehicleView& vehicle) {
    constexpr float flattened = 0.85f;  // the camera looks down at a slant
    const float half = 0.5f * kind_of(now, vehicle).body.length;
    return around(seen, {vehicle.x, vehicle.y}, vehicle_middle * scale_of(now.scene->arena), half, flattened * half);
}

Rect picture_of(const Snapshot& now, const CameraView& seen, const SourceView& source) {
    constexpr float radius = 0.26f;
    const float scale = scale_of(now.scene->arena);
    return around(seen, {source.x, source.y}, bulb_height * scale, radius * scale, radius * scale);
}

void LabelSpace::keep_free(const Snapshot& now, const CameraView& seen) {
    constexpr std::size_t crowd = 200;
    if (!now.scene) return;
    if (now.vehicles.size() <= crowd)
        for (const VehicleView& vehicle : now.vehicles) keep_free(picture_of(now, seen, vehicle));
    for (const SourceView& source : now.sources) keep_free(picture_of(now, seen, source));
}

bool LabelSpace::is_free(const Rect& place) const { return cost(place) <= 0; }

float LabelSpace::cost(const Rect& place) const {
    constexpr float of_label = 8;
    float sum = 0;
    for (const Rect& label : labels_) sum += of_label * overlap(place, label);
    for (const Rect& thing : things_) sum += overlap(place, thing);
    return sum;
}

}  // namespace braitenlab
