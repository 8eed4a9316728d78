#include "render/view/hidden_parts.h"

#include <algorithm>
#include <cmath>

namespace braitenlab {

namespace {

// Adds what is left of `whole` without `hidden`, in at most four rectangles.
void add_rest(std::vector<Rect>& parts, const Rect& whole, const Rect& hidden) {
    if (!whole.overlaps(hidden)) return parts.push_back(whole);
    const float right = whole.x + whole.w, low = whole.y + whole.h;
    const float top = std::max(whole.y, hidden.y), bottom = std::min(low, hidden.y + hidden.h);
    const auto add = [&](float left, float upper, float right_edge, float lower) {
        if (left < right_edge && upper < lower) parts.push_back({left, upper, right_edge - left, lower - upper});
    };
    add(whole.x, whole.y, right, top);
    add(whole.x, top, hidden.x, bottom);
    add(hidden.x + hidden.w, top, right, bottom);
    add(whole.x, bottom, right, low);
}

}  // namespace

std::vector<Rect> hidden_parts(const Picture& picture) {
    const float inside = 5 * picture.pixel_scale;  // round corners are not opaque
    std::vector<Rect> parts;
    for (const Rect& r : picture.opaque) {
        const float left = std::round(r.x + inside), right = std::round(r.x + r.w - inside);
        const float top = std::round(r.y + inside), bottom = std::round(r.y + r.h - inside);
        if (left < right && top < bottom) parts.push_back({left, top, right - left, bottom - top});
    }
    return parts;
}

std::vector<Rect> visible_parts(const Rect& window, const std::vector<Rect>& hidden) {
    std::vector<Rect> parts{window};
    for (const Rect& each : hidden) {
        std::vector<Rect> rest;
        for (const Rect& part : parts) add_rest(rest, part, each);
        parts = std::move(rest);
    }
    return parts;
}

}  // namespace braitenlab
