#include "app/viewport.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include <imgui.h>

#include "app/lab_selection.h"
#include "render/view/label_space.h"
#include "ui/lab_view.h"

namespace braitenlab {

using maths::vec2;

namespace {

constexpr float glide_seconds = 0.6f;
constexpr float slow_orbit_rate = 0.07f;                          // rad/s: a turn takes 90 s
constexpr float turn_rate = 1.2f, raise_rate = 0.8f;              // rad/s, arrow keys
constexpr float zoom_rate = 1.5f;                                 // log2 of the zoom per second
constexpr float pan_rate = 0.5f;                                  // of the width of the free area per second
constexpr float turn_by_pixel = 0.006f, raise_by_pixel = 0.005f;  // rad per pixel
constexpr float around_paths = 0.9f;                              // m, in an arena of full scale
constexpr float beside_ring = 0.5f;                               // m, likewise: half a vehicle outside it
constexpr float notch = 0.2f;                                     // log2 of the zoom per notch of the wheel

// Of the free area's width: least length of the selected vehicle in scenes of few vehicles.
constexpr float least_share = 0.05f, least_share_in_lecture = 0.08f;

// True if the camera has returned in this frame to the one that Home restores.
bool is_home(const ViewportState& state, const Lab& lab) {
    const Camera home = home_camera(lab);
    return lab.view.camera == home && !(state.last == home);
}

std::optional<FloorBox> both(const std::optional<FloorBox>& a, const std::optional<FloorBox>& b) {
    if (!a || !b) return a ? a : b;
    return FloorBox{{std::min(a->low.x, b->low.x), std::min(a->low.y, b->low.y)},
                    {std::max(a->high.x, b->high.x), std::max(a->high.y, b->high.y)}};
}

// The place of the vehicle of slot B; nullopt while it is not drawn.
std::optional<FloorBox> around_b(const SlotsView& slots) {
    if (!slots.b) return std::nullopt;
    const vec2 at{slots.b->pose.x, slots.b->pose.y}, border{slots.b->length, slots.b->length};
    return FloorBox{at - border, at + border};
}

// Around the rings that the exercise's steps and its prediction are about: a vehicle drives there without moving the
// picture.
std::optional<FloorBox> rings_of_exercise(const Lab& lab) {
    std::optional<FloorBox> box;
    if (!lab.document.lesson) return box;
    const Snapshot& now = shown_snapshot(lab);
    const auto add = [&](const Check& check) {
        const auto* circles = std::get_if<goals::Circles>(&check.goal);
        if (!circles) return;
        const float around = circles->to + scale_of(now.scene->arena) * beside_ring;
        for (const SourceView& source : now.sources) {
            const auto index = static_cast<std::size_t>(source.source);
            if (!circles->source.empty() && now.scene->sources[index].name != circles->source) continue;
            const vec2 at{source.x, source.y}, border{around, around};
            box = both(box, FloorBox{at - border, at + border});
        }
    };
    const Exercise& exercise = *lab.document.lesson->exercise;
    for (const Step& step : exercise.steps) add(step.check);
    for (const ShownCheck& shown : exercise.prediction.shows) add(shown.check);
    return box;
}

bool jumped(const ViewportState& state, const Lab& lab) {
    return lab.view.camera.mode != state.last.mode || lab.view.selection.vehicle != state.last_followed ||
           is_home(state, lab);
}

// In a lecture a step of a page opens or closes a card beside the scene. Another page is another scene.
bool area_moved(const ViewportState& state, const Lab& lab, const Rect& free_area) {
    return lab.before_lecture && state.last_run == lab.document.run_id && !(state.last_area == free_area);
}

// In the wiring editor, whose scene is small: the paths with and without the edit or the change under the pointer.
std::optional<FloorBox> paths_of_change(const Lab& lab) {
    if (lab.playback.mode != Mode::wiring) return std::nullopt;
    const auto prediction = prediction_of(lab.predictions, lab);
    if (!prediction) return std::nullopt;
    const float around = scale_of(shown_snapshot(lab).scene->arena) * around_paths;
    FloorBox box{{1e9f, 1e9f}, {-1e9f, -1e9f}};
    for (const insight::Path* path : {prediction->path, prediction->before})
        for (std::size_t i = 0; path && i < path->size(); ++i) {
            const Pose& pose = (*path)[i];
            box.low = {std::min(box.low.x, pose.x - around), std::min(box.low.y, pose.y - around)};
            box.high = {std::max(box.high.x, pose.x + around), std::max(box.high.y, pose.y + around)};
        }
    return box;
}

// In a lecture, beside a question, a card or the diagram: the whole arena with its walls, where the vehicle is not too
// small in it. It does not depend on the place of the vehicle, so that the camera rests.
std::optional<FloorBox> arena_beside(const Lab& lab, Rect window, Rect free_area) {
    constexpr float narrow = 0.6f;  // of the window's width
    const std::vector<VehicleView>& vehicles = shown_snapshot(lab).vehicles;
    const VehicleView* vehicle = selected_vehicle(lab);
    if (!vehicle && !vehicles.empty()) vehicle = &vehicles.front();  // a selected one that is gone moves nothing
    const bool is_beside = lab.before_lecture && lab.playback.mode != Mode::wiring && free_area.w < narrow * window.w;
    if (!is_beside || !vehicle || lab.view.camera.mode != CameraMode::overview) return std::nullopt;
    const Snapshot& now = shown_snapshot(lab);
    const Arena& arena = now.scene->arena;
    const float wall = has_walls(arena.edge) ? wall_of(arena).thickness : 0;
    const vec2 half{arena.width / 2 + wall, arena.height / 2 + wall};
    const FloorBox box{half * -1.0f, half};
    const CameraView seen = look(lab.view.camera, arena, nullptr, window, free_area, &box);
    const float length = kind_of(now, *vehicle).body.length * pixels_per_metre(seen, {});
    return length >= least_share * free_area.w ? std::optional(box) : std::nullopt;
}

// The height from the top of the area to below its cards that hide a vehicle, B or a bulb, at most half of it; 0: none.
// A card that has just got a column of its own is beside the area, and hides what the last frame has shown there.
float height_of_cards(const Lab& lab, const CameraView& seen, const Rect& area, std::span<const Rect> cards,
                      const SlotsView& slots) {
    const Snapshot& now = shown_snapshot(lab);
    float height = 0;
    const auto look_at = [&](const Rect& thing) {
        for (const Rect& card : cards)
            if (card.overlaps(area) && card.overlaps(thing)) height = std::max(height, card.y + card.h - area.y);
    };
    for (const VehicleView& vehicle : now.vehicles) look_at(picture_of(now, seen, vehicle));
    for (const SourceView& source : now.sources) look_at(picture_of(now, seen, source));
    const VehicleView* selected = selected_vehicle(lab);
    if (slots.b && selected) {
        VehicleView with_b = *selected;
        with_b.x = slots.b->pose.x, with_b.y = slots.b->pose.y, with_b.heading = slots.b->pose.heading;
        look_at(picture_of(now, seen, with_b));
    }
    return std::min(height, area.h / 2);
}

// The area without the strip of the cards that hide something. The camera of the user stays where it is.
Rect clear_of_cards(ViewportState& state, const Lab& lab, Rect area, std::span<const Rect> cards,
                    const SlotsView& slots) {
    const Snapshot& now = shown_snapshot(lab);
    const Camera& camera = lab.view.camera;
    const bool starts = now.tick < state.tick && now.tick == 0;
    const bool is_ours = camera.mode == CameraMode::overview && camera.zoom == 1 && camera.pan == vec2{};
    state.tick = now.tick;
    if (starts || cards.empty()) state.below_cards = 0;
    if (is_ours && !cards.empty() && state.has_sight && now.scene && now.vehicles.size() <= few_vehicles) {
        const float height = height_of_cards(lab, state.camera_view, area, cards, slots);
        if (height > state.below_cards) state.below_cards = height, state.age = 0;
    }
    area.y += state.below_cards, area.h -= state.below_cards;
    return area;
}

}  // namespace

void aim(ViewportState& state, const Lab& lab, Rect window, Rect free_area, float seconds, const SlotsView& slots,
         std::span<const Rect> cards) {
    const Snapshot& now = shown_snapshot(lab);
    free_area = clear_of_cards(state, lab, free_area, cards, slots);
    const VehicleView* followed = rides(lab.view.camera.mode) ? find_vehicle(now, lab.view.selection.vehicle) : nullptr;
    if (is_home(state, lab)) state.framing.start_over();
    auto close_up = paths_of_change(lab);
    if (!close_up) close_up = arena_beside(lab, window, free_area);
    const ImGuiIO& io = ImGui::GetIO();
    const bool held = std::any_of(std::begin(io.MouseDown), std::end(io.MouseDown), [](bool down) { return down; });
    state.framed =
        state.framing.follow(now, {.camera = lab.view.camera,
                                   .selected = lab.view.selection.vehicle,
                                   .window = window,
                                   .free_area = free_area,
                                   .least_share = lab.before_lecture ? least_share_in_lecture : least_share,
                                   .beside = both(around_b(slots), rings_of_exercise(lab)),
                                   .seconds = state.has_sight && !lab.preferences.reduce_motion ? seconds : 0.0f,
                                   .held = held,
                                   .paused = lab.playback.mode == Mode::paused && !lab.playback.seeks,
                                   .close_up = close_up});
    const CameraView wanted = look(state.framing.raised(lab.view.camera), now.scene->arena, followed, window, free_area,
                                   &state.framed, ride_scale(now, followed));
    state.age = jumped(state, lab) || area_moved(state, lab, free_area) ? 0 : state.age + seconds;
    state.last = lab.view.camera;
    state.last_area = free_area;
    state.last_run = lab.document.run_id;
    state.last_followed = lab.view.selection.vehicle;
    const bool glides = state.has_sight && state.age < glide_seconds && state.camera_view.window == wanted.window &&
                        !lab.preferences.reduce_motion;
    state.camera_view = glides ? glide(state.camera_view, wanted, seconds) : wanted;
    state.has_sight = true;
}

void orbit_slowly(Camera& camera, float seconds) { orbit(camera, slow_orbit_rate * seconds, 0); }

void drive_camera(Lab& lab, const ViewportState& state, const ui::SceneInputState& scene_input, CameraKeys keys,
                  Rect window, Rect free_area, float seconds) {
    const ImGuiIO& io = ImGui::GetIO();
    const vec2 at{io.MousePos.x, io.MousePos.y}, moved = scene_input.drag.moved;
    const vec2 middle = free_area.middle();
    const bool by_mouse = scene_input.drag.phase == ui::SceneInputPhase::orbit ||
                          scene_input.drag.phase == ui::SceneInputPhase::pan ||
                          (!io.WantCaptureMouse && io.MouseWheel != 0);
    if (keys || by_mouse || rides(lab.view.camera.mode)) lab.view.orbits = false;
    const bool orbits = lab.view.orbits && !lab.preferences.reduce_motion;
    // What the user sees is where a movement begins.
    if ((keys || by_mouse || orbits) && lab.view.camera.mode == CameraMode::overview)
        lab.view.camera = state.framing.raised(lab.view.camera);
    if (orbits) orbit_slowly(lab.view.camera, seconds);
    orbit(lab.view.camera, keys.turn * turn_rate * seconds, keys.raise * raise_rate * seconds);
    if (keys.zoom != 0)
        zoom_about(lab.view.camera, shown_snapshot(lab).scene->arena, window, free_area, middle,
                   std::exp2(keys.zoom * zoom_rate * seconds), &state.framed);
    if ((keys.pan.x != 0 || keys.pan.y != 0) && !rides(lab.view.camera.mode)) {
        const float step = pan_rate * free_area.w * seconds;
        pan(lab.view.camera, state.camera_view, middle + vec2{keys.pan.x, -keys.pan.y} * step, middle);
    }
    if (scene_input.drag.phase == ui::SceneInputPhase::orbit && !rides(lab.view.camera.mode))
        orbit(lab.view.camera, -moved.x * turn_by_pixel, moved.y * raise_by_pixel);
    if (scene_input.drag.phase == ui::SceneInputPhase::pan && !rides(lab.view.camera.mode))
        pan(lab.view.camera, state.camera_view, at - moved, at);
    if (!io.WantCaptureMouse && io.MouseWheel != 0)
        zoom_about(lab.view.camera, shown_snapshot(lab).scene->arena, window, free_area, at,
                   std::exp2(io.MouseWheel * notch), &state.framed);
}

}  // namespace braitenlab
