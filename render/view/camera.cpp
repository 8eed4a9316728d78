#include "render/view/camera.h"

#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"

namespace braitenlab {

using maths::vec2;
using maths::vec3;
using maths::vec4;

namespace {

constexpr float overview_field =
    0.56f;  // rad, vertical, of the whole window; a small angle keeps distances in the picture comparable
constexpr float follow_field = 0.87f;
constexpr float driver_field = 1.1f;

float clamped_elevation(float elevation) { return std::clamp(elevation, 0.15f, 1.5f); }
float clamped_zoom(const Camera& camera) { return std::clamp(camera.zoom, 0.25f, 8.0f); }

// A perspective camera: position, direction and lens.
struct Stand {
    vec3 eye, target;
    float focal;     // px
    vec2 principal;  // px, the viewing direction in the window
    float near, far;
};

CameraView through(const Stand& stand, Rect window) {
    CameraView camera_view;
    camera_view.window = window;
    camera_view.eye = stand.eye;
    camera_view.view = maths::look_at(stand.eye, stand.target, {0, 1, 0});
    auto& p = camera_view.projection;
    const float n = stand.near, f = stand.far;
    p[0] = {2 * stand.focal / window.w, 0, 0, 0};
    p[1] = {0, 2 * stand.focal / window.h, 0, 0};
    // The camera looks along −z, so the shift of the principal point changes its sign.
    p[2] = {1 - 2 * (stand.principal.x - window.x) / window.w, 2 * (stand.principal.y - window.y) / window.h - 1,
            (f + n) / (n - f), -1};
    p[3] = {0, 0, 2 * f * n / (n - f), 0};
    return camera_view;
}

Rect usable(Rect window, Rect free_area) {
    const float x0 = std::max(window.x, free_area.x), y0 = std::max(window.y, free_area.y);
    const float x1 = std::min(window.x + window.w, free_area.x + free_area.w);
    const float y1 = std::min(window.y + window.h, free_area.y + free_area.h);
    return x1 - x0 < 64 || y1 - y0 < 64 ? window : Rect{x0, y0, x1 - x0, y1 - y0};
}

// Extent of the framed box's corners in the picture, in focal lengths, from a distance along the viewing direction.
struct Extent {
    float left = 1e9f, right = -1e9f, bottom = 1e9f, top = -1e9f;
    bool in_front = true;
};

Extent extent_from(float distance, const std::array<vec3, 8>& corners) {
    Extent e;
    for (const vec3& corner : corners) {
        const float depth = distance - corner.z;
        if (depth < 0.1f) e.in_front = false;
        const float x = corner.x / depth, y = corner.y / depth;
        e.left = std::min(e.left, x), e.right = std::max(e.right, x);
        e.bottom = std::min(e.bottom, y), e.top = std::max(e.top, y);
    }
    return e;
}

FloorBox box_of(const Arena& arena, const FloorBox* framed) {
    const vec2 half{arena.width / 2, arena.height / 2};
    return framed ? *framed : FloorBox{half * -1.0f, half};
}

Stand overview(const Camera& camera, const Arena& arena, const FloorBox& box, Rect window, Rect area) {
    const float elevation = clamped_elevation(camera.elevation), zoom = clamped_zoom(camera);
    const vec2 flat = maths::direction(camera.azimuth) * maths::cosine(elevation);
    const vec3 back{flat.x, maths::sine(elevation), -flat.y};
    const vec3 right = maths::normalise(maths::cross(vec3{0, 1, 0}, back)), up = maths::cross(back, right);

    const vec2 centre = (box.low + box.high) / 2.0f, half = (box.high - box.low) / 2.0f;
    std::array<vec3, 8> corners;
    for (unsigned i = 0; i < 8; ++i) {
        const vec2 place{i & 1U ? half.x : -half.x, i & 2U ? half.y : -half.y};
        const vec3 p = to_gl(place, i & 4U ? wall_of(arena).height : 0);
        corners[i] = {maths::dot(right, p), maths::dot(up, p), maths::dot(back, p)};
    }

    const float focal = window.h / (2 * std::tan(overview_field / 2));
    // Margin for the walls' thickness and, with the room beside the free area, for the labels of metres outside them,
    // where the box reaches the edge of the arena.
    const bool at_edge = box.high.x >= arena.width / 2 || box.high.y >= arena.height / 2 ||
                         box.low.x <= -arena.width / 2 || box.low.y <= -arena.height / 2;
    const float side = std::min(area.w, area.h);
    const float beside = std::min({area.x - window.x, area.y - window.y, window.x + window.w - area.x - area.w,
                                   window.y + window.h - area.y - area.h});
    const float margin = at_edge ? 8 + std::max(0.016f * side, 0.032f * side - std::max(beside, 0.0f)) : 6;
    const float room_x = (area.w - 2 * margin) / focal, room_y = (area.h - 2 * margin) / focal;
    const auto fits = [&](float distance) {
        const Extent e = extent_from(distance, corners);
        return e.in_front && e.right - e.left <= room_x && e.top - e.bottom <= room_y;
    };
    // The extent shrinks with distance: bisect between too near and far enough.
    float near = 0.1f, far = 10;
    while (!fits(far) && far < 1e6f) far *= 2;
    for (int i = 0; i < 40; ++i) (fits((near + far) / 2) ? far : near) = (near + far) / 2;
    const float distance = far;

    // Lens shift: the centre of the box's picture is in the centre of the free area.
    const Extent e = extent_from(distance, corners);
    const vec2 middle = area.middle();
    const vec2 shift{(e.left + e.right) / 2, (e.bottom + e.top) / 2};
    const vec3 target = to_gl(centre + camera.pan);
    const float size = std::hypot(arena.width, arena.height);
    return {target + back * distance,
            target,
            focal * zoom,
            {middle.x - shift.x * focal * zoom, middle.y + shift.y * focal * zoom},
            0.08f * distance,
            distance + 12 * size + 60};
}

// Straight down, orthographic: distances on the screen are proportional to distances on the floor. `border`: m, around
// the box.
CameraView birds_eye(const Camera& camera, const FloorBox& box, float border, Rect window, Rect area) {
    constexpr float high = 100, near = 1, far = 110;  // m
    const vec2 side = box.high - box.low, target = (box.low + box.high) / 2.0f + camera.pan;
    const vec2 back = maths::direction(camera.azimuth), right{-back.y, back.x};
    const auto extent = [&](vec2 along) {
        return std::fabs(along.x) * side.x + std::fabs(along.y) * side.y + 2 * border;
    };
    const float scale = std::min(area.w / extent(right), area.h / extent(back)) * clamped_zoom(camera);  // px a metre
    const vec2 middle = area.middle();
    CameraView camera_view;
    camera_view.window = window;
    camera_view.eye = to_gl(target, high);
    camera_view.view = maths::look_at(camera_view.eye, to_gl(target), to_gl(-back));
    const float left = (window.x - middle.x) / scale, top = (middle.y - window.y) / scale;
    camera_view.projection = maths::orthographic(left, left + window.w / scale, top - window.h / scale, top, near, far);
    return camera_view;
}

Stand riding(const Camera& camera, const VehicleView& vehicle, float scale, Rect window, Rect area) {
    const vec2 ahead = maths::direction(vehicle.heading), place{vehicle.x, vehicle.y};
    const float zoom = clamped_zoom(camera) / scale;
    const vec3 eye = to_gl(place - ahead * (4.0f / zoom), 2.6f / zoom);
    return {eye,
            to_gl(place + ahead * (1.4f * scale), 0.2f * scale),
            window.h / (2 * std::tan(follow_field / 2)),
            area.middle(),
            0.08f * scale,
            300};
}

// Just behind the sensors, the front of the vehicle at the lower edge of the picture.
Stand driving(const Camera& camera, const VehicleView& vehicle, float scale, Rect window, Rect area) {
    const vec2 ahead = maths::direction(vehicle.heading), place{vehicle.x, vehicle.y};
    return {to_gl(place - ahead * (0.12f * scale), 0.62f * scale),
            to_gl(place + ahead * (2.4f * scale), 0.12f * scale),
            window.h / (2 * std::tan(driver_field / 2)) * clamped_zoom(camera),
            area.middle(),
            0.05f * scale,
            300};
}

vec3 row(const maths::mat4& m, int i) { return {m[0][i], m[1][i], m[2][i]}; }

vec4 clip_place(const CameraView& camera_view, vec2 place, float height) {
    const vec3 p = to_gl(place, height);
    return camera_view.projection * (camera_view.view * vec4{p.x, p.y, p.z, 1});
}

}  // namespace

float ride_scale(const Snapshot& now, const VehicleView* followed) {
    return followed && now.scene && scale_of(now.scene->arena) < 1 ? kind_of(now, *followed).body.length : 1;
}

CameraView look(const Camera& camera, const Arena& arena, const VehicleView* follow, Rect window, Rect free_area,
                const FloorBox* framed, float ride_scale) {
    window.w = std::max(window.w, 1.0f), window.h = std::max(window.h, 1.0f);
    const Rect area = usable(window, free_area);
    if (camera.mode == CameraMode::follow && follow)
        return through(riding(camera, *follow, ride_scale, window, area), window);
    if (camera.mode == CameraMode::driver && follow)
        return through(driving(camera, *follow, ride_scale, window, area), window);
    if (camera.mode == CameraMode::birds_eye)
        return birds_eye(camera, box_of(arena, framed), framed ? 0.1f : 0.5f, window, area);
    return through(overview(camera, arena, box_of(arena, framed), window, area), window);
}

void orbit(Camera& camera, float azimuth, float elevation) {
    camera.turned |= azimuth != 0 || elevation != 0;
    camera.azimuth = maths::wrap_angle(camera.azimuth + azimuth);
    camera.elevation = clamped_elevation(camera.elevation + elevation);
}

void pan(Camera& camera, const CameraView& camera_view, vec2 from, vec2 to) {
    const auto held = unproject(camera_view, from), there = unproject(camera_view, to);
    if (!held || !there) return;
    constexpr float farthest = 500;  // m, limit of the shift
    camera.pan += *held - *there;
    camera.pan = {std::clamp(camera.pan.x, -farthest, farthest), std::clamp(camera.pan.y, -farthest, farthest)};
}

void zoom_about(Camera& camera, const Arena& arena, Rect window, Rect free_area, vec2 pixel, float factor,
                const FloorBox* framed) {
    const auto before = unproject(look(camera, arena, nullptr, window, free_area, framed), pixel);
    camera.zoom *= factor;
    camera.zoom = clamped_zoom(camera);
    const auto after = unproject(look(camera, arena, nullptr, window, free_area, framed), pixel);
    if (before && after && !rides(camera.mode)) camera.pan += *before - *after;
}

CameraView glide(const CameraView& from, const CameraView& to, float seconds) {
    constexpr float time_constant = 0.06f;  // s; 96 % of the way after 0.2 s
    const float t = 1 - std::exp(-std::max(seconds, 0.0f) / time_constant);
    const vec3 back = row(from.view, 2) * (1 - t) + row(to.view, 2) * t;
    const vec3 up = row(from.view, 1) * (1 - t) + row(to.view, 1) * t;
    const float turned = maths::dot(row(from.view, 2), row(to.view, 2));
    const bool arrived = maths::distance(from.eye, to.eye) < 1e-3f && turned > 1 - 1e-6f &&
                         maths::length(from.projection[2] - to.projection[2]) < 1e-4f &&
                         maths::length(from.projection[0] - to.projection[0]) < 1e-4f &&
                         maths::length(from.projection[3] - to.projection[3]) < 1e-4f;
    // No transition between opposite directions or when the window has changed its size.
    if (arrived || turned < -0.9f || !(from.window == to.window)) return to;

    CameraView camera_view = to;
    camera_view.eye = from.eye * (1 - t) + to.eye * t;
    camera_view.view = maths::look_at(camera_view.eye, camera_view.eye - back, up);
    for (int i = 0; i < 4; ++i) camera_view.projection[i] = from.projection[i] * (1 - t) + to.projection[i] * t;
    return camera_view;
}

std::optional<vec2> project(const CameraView& camera_view, vec2 place, float height) {
    const vec4 clip = clip_place(camera_view, place, height);
    if (clip.w < 1e-4f) return std::nullopt;
    return vec2{camera_view.window.x + (clip.x / clip.w + 1) / 2 * camera_view.window.w,
                camera_view.window.y + (1 - clip.y / clip.w) / 2 * camera_view.window.h};
}

float pixels_per_metre(const CameraView& camera_view, vec2 place, float height) {
    const float depth = clip_place(camera_view, place, height).w;
    return depth < 1e-4f ? 0 : camera_view.projection[1].y * camera_view.window.h / (2 * depth);
}

std::optional<vec2> unproject(const CameraView& camera_view, vec2 pixel, float height) {
    const float x = 2 * (pixel.x - camera_view.window.x) / camera_view.window.w - 1;
    const float y = 1 - 2 * (pixel.y - camera_view.window.y) / camera_view.window.h;
    // At depth d in front of the camera clip w is spread·d + level (d with perspective, 1 without, a mix in a
    // transition); the points under the pixel form a line in d.
    const auto& p = camera_view.projection;
    const float spread = -p[2].w, level = p[3].w;
    const vec3 right = row(camera_view.view, 0), up = row(camera_view.view, 1), back = row(camera_view.view, 2);
    const vec3 start = camera_view.eye + right * ((x * level - p[3].x) / p[0].x) + up * ((y * level - p[3].y) / p[1].y);
    const vec3 ray = right * ((x * spread + p[2].x) / p[0].x) + up * ((y * spread + p[2].y) / p[1].y) - back;
    if (ray.y > -1e-5f) return std::nullopt;
    const float reach = (height - start.y) / ray.y;
    return vec2{start.x + reach * ray.x, -(start.z + reach * ray.z)};
}

}  // namespace braitenlab
