#include "ui/scene_input/draw.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/maths/angle.h"
#include "ui/imgui_compat.h"
#include "ui/scene_input/polygon_tool.h"
#include "ui/scene_input/tools.h"
#include "ui/scene_input/under_pointer.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float source_ring = 0.42f;  // m
constexpr int ring_segments = 64;

class SceneInputDrawing {
public:
    SceneInputDrawing(const SceneInputState& state, const SceneInputFrame& frame, const Ui& ui)
        : state_(state), frame_(frame), ui_(ui), list_(*ImGui::GetBackgroundDrawList()) {}

    void draw() {
        if (frame_.view.mode == Mode::wiring) return;
        caption_edge();
        mark_object(frame_.view.settings.selection.object, ui_.palette.selected, 2.5f);
        mark_others();
        if (state_.drag.phase == SceneInputPhase::select) draw_selection();
        const SceneObject& hovered = state_.hovered.object;
        const bool idle = state_.drag.phase == SceneInputPhase::idle;
        if (idle && !state_.hovered.handle && hovered != frame_.view.settings.selection.object)
            mark_object(hovered, ui_.palette.accent, 1.5f);  // a dark line would look like a dark wall
        if (const auto handle = handle_of(state_, frame_)) draw_handle(*handle);
        if (state_.drag.phase == SceneInputPhase::move || state_.drag.phase == SceneInputPhase::turn) note_pose();
        if (state_.tool != SceneInputTool::hand) draw_tool();
        if (!state_.refusal.key.empty() && frame_.view.wall_seconds < state_.refusal.until)
            note(ui_.strings(state_.refusal.key), ui_.palette.warning);
    }

private:
    // Above the dashed edge of a torus: what happens there.
    void caption_edge() const {
        const Arena& arena = frame_.view.now->scene->arena;
        if (arena.edge != Boundary::torus || frame_.view.lecture || !frame_.view.settings.overlays.labels) return;
        const auto edge = project(frame_.camera_view, {0, arena.height / 2});
        const Rect& room = frame_.area;
        if (!edge) return;
        const std::vector<std::string> lines =
            even_lines(ui_, ui_.strings("scene_input.torus"), Face::label, room.w - ui_.px(2 * spacing::small));
        const float line = line_height(ui_, Face::label), height = line * static_cast<float>(lines.size());
        float y = edge->y - height - ui_.px(spacing::small);
        if (y < room.y || edge->y > room.y + room.h) return;  // the edge is outside the picture
        float width = 0;
        for (const std::string& words : lines) width = std::max(width, text_width(ui_, Face::label, words));
        const float most = room.x + room.w - ui_.px(spacing::small) - width / 2;
        const float least = room.x + ui_.px(spacing::small) + width / 2;
        float x = std::clamp(edge->x, least, std::max(least, most));
        // What covers the scene there, such as the tools, has the words beside it, or there is no room for them.
        if (frame_.labels)
            for (const Rect& covered : frame_.labels->labels())
                if (covered.overlaps({x - width / 2, y, width, height}))
                    if ((x = covered.x + covered.w + ui_.px(spacing::small) + width / 2) > most) return;
        for (const std::string& words : lines) {
            put_on(list_, ui_, {std::floor(x - text_width(ui_, Face::label, words) / 2), y}, words,
                   ui_.palette.second_text, Face::label);
            y += line;
        }
    }
    void line(const std::vector<ImVec2>& points, Colour colour, float layout_width, bool closed = true) const {
        draw_line(ui_, points, colour, layout_width, closed);
    }
    void dot(ImVec2 at, float layout_radius, Colour colour) const { draw_dot(ui_, at, layout_radius, colour); }

    // Empty when one of them is behind the camera.
    std::vector<ImVec2> on_screen(const std::vector<vec2>& places, float height = 0) const {
        std::vector<ImVec2> points;
        for (const vec2 place : places) {
            const auto at = project(frame_.camera_view, place, height);
            if (!at) return {};
            points.push_back({at->x, at->y});
        }
        return points;
    }

    std::vector<ImVec2> circle(vec2 middle, float radius) const {
        std::vector<vec2> places;
        for (int i = 0; i < ring_segments; ++i)
            places.push_back(middle + maths::from_polar(radius, 2 * maths::pi * static_cast<float>(i) / ring_segments));
        return on_screen(places);
    }

    // The renderer draws the rings of vehicles.
    void mark_object(const SceneObject& object, Colour colour, float width) const {
        const auto place = place_of(*frame_.view.now, object);
        if (!place) return;
        if (object.kind == SceneObjectKind::source)
            line(circle({place->x, place->y}, source_ring * scale_of(frame_.view.now->scene->arena)), colour, width);
        const bool obstacle = object.kind == SceneObjectKind::obstacle;
        if (!obstacle && object.kind != SceneObjectKind::zone) return;
        const auto corners = outline_of(*frame_.view.now, object);
        line(on_screen(corners), obstacle ? colour.with_alpha(0.6f * colour.a) : colour, width);
        if (obstacle) line(on_screen(corners, obstacle_height(frame_.view.now->scene->arena)), colour, width);
    }

    // The renderer draws the ring of the chosen vehicle only.
    void mark_others() const {
        constexpr std::size_t most = 512;  // more rings than this take longer than a frame
        const std::vector<SceneObject>& more = frame_.view.settings.selection.more;
        for (std::size_t i = 0; i < std::min(most, more.size()); ++i) {
            mark_object(more[i], ui_.palette.selected, 2.0f);
            const auto place = place_of(*frame_.view.now, more[i]);
            if (place && more[i].kind == SceneObjectKind::vehicle)
                line(circle({place->x, place->y}, reach_of(*frame_.view.now, more[i])), ui_.palette.selected, 2.0f);
        }
    }

    void draw_selection() const {
        const vec2 a = state_.drag.press, b = frame_.pointer.at;
        const ImVec2 low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)};
        list_.AddRectFilled(low, high, paint(ui_.palette.selected.with_alpha(0.14f)));
        compat::outline(list_, low, high, paint(ui_.palette.selected), 0, ui_.px(1.5f));
    }

    void draw_handle(const Handle& handle) const {
        const bool warm = state_.hovered.handle || state_.drag.phase == SceneInputPhase::turn;
        const Colour colour = warm ? ui_.palette.accent : ui_.palette.second_text;
        line(circle(handle.middle, handle.radius), colour.with_alpha(warm ? 1.0f : 0.55f), warm ? 2.0f : 1.25f);
        const auto knob = project(frame_.camera_view, handle.knob);
        if (!knob) return;
        dot({knob->x, knob->y}, (warm ? 8.0f : 6.0f) * finger_size(frame_.view), colour);
        ui_.anchors.record("stage.knob", square_around(*knob, ui_.px(2 * handle_grip) * finger_reach(frame_.view)));
    }

    void note_pose() const {
        const auto place = place_of(*frame_.view.now, state_.drag.on.object);
        if (!place) return;
        const Strings& words = ui_.strings;
        note(state_.drag.phase == SceneInputPhase::turn
                 ? fill(words("scene_input.heading"), {with_sign(ui_, maths::degrees(place->heading), 0)})
                 : fill(words("scene_input.place"), {with_sign(ui_, place->x, 1), with_sign(ui_, place->y, 1)}),
             ui_.palette.line);
    }

    void area(const std::vector<vec2>& corners, Colour colour) const {
        const auto points = on_screen(corners);
        if (points.size() >= 3)
            list_.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), paint(colour.with_alpha(0.22f)));
    }

    // The position of the next corner; nullopt while the mouse is over a card and the keyboard has no crosshair.
    std::optional<vec2> next_corner() const {
        const bool points = state_.crosshair || frame_.pointer.over;
        return points ? aim(state_, frame_.view, frame_.pointer.at) : std::nullopt;
    }

    void draw_tool() const {
        const auto next = next_corner();
        if (state_.tool == SceneInputTool::polygon) draw_outline();
        if (state_.tool == SceneInputTool::tape) draw_tape(next);
        if (spans(state_.tool) && !state_.corners.empty()) draw_span(next);
        if (next && state_.tool == SceneInputTool::lamp) draw_ghost_lamp(*next);
        if (!next) return;
        const auto pixel = state_.crosshair ? project(frame_.camera_view, *state_.crosshair) : frame_.pointer.at;
        if (!pixel) return;
        draw_cross(*pixel);
        ui_.anchors.record("stage.crosshair", square_around(*pixel, ui_.px(16)));
    }

    void draw_span(const std::optional<vec2>& next) const {
        const vec2 from = state_.corners[0];
        const std::optional<vec2> to = state_.corners.size() > 1 ? std::optional(state_.corners[1]) : next;
        if (!to) return;
        if (state_.tool == SceneInputTool::ruler) return draw_measurement(from, *to);
        const Obstacle box = box_between(from, *to);
        std::vector<vec2> corners = corners_of(box);
        for (vec2& corner : corners) corner += vec2{box.x, box.y};
        area(corners, ui_.palette.accent);
        line(on_screen(corners), ui_.palette.accent, 2);
        note(fill(ui_.strings("scene_input.size"), {fixed(ui_, box.length, 1), fixed(ui_, box.width, 1)}),
             ui_.palette.line);
    }

    // A line with a dot at each end, and its length and direction beside its second end.
    void draw_measurement(vec2 from, vec2 to) const {
        line(on_screen({from, to}), ui_.palette.accent, 2, false);
        for (const vec2 end : {from, to})
            if (const auto at = project(frame_.camera_view, end)) dot({at->x, at->y}, 4, ui_.palette.accent);
        const maths::Polar of = maths::to_polar(to - from);
        const auto at = project(frame_.camera_view, to);
        if (!at) return;
        note(fill(ui_.strings("scene_input.measured"),
                  {fixed(ui_, of.distance, 2), fixed(ui_, maths::degrees(of.angle), 1)}),
             ui_.palette.accent, *at);
    }

    // The segments of tape so far, and the next one.
    void draw_tape(const std::optional<vec2>& next) const {
        std::vector<vec2> points = state_.corners;
        if (next) points.push_back(*next);
        for (const Zone& segment : tape_along(points, tape_width(*frame_.view.now->scene))) {
            std::vector<vec2> corners = corners_of(segment);
            const vec2 ahead = maths::direction(segment.heading);
            for (vec2& corner : corners) corner = vec2{segment.x, segment.y} + maths::rotate(corner, ahead);
            area(corners, ui_.palette.accent);
            line(on_screen(corners), ui_.palette.accent, 1.5f);
        }
        for (const vec2 point : state_.corners)
            if (const auto at = project(frame_.camera_view, point)) dot({at->x, at->y}, 3.5f, ui_.palette.accent);
        if (state_.corners.empty() || !next) return;
        note(fill(ui_.strings("scene_input.segment"), {fixed(ui_, maths::distance(state_.corners.back(), *next), 2)}),
             ui_.palette.line);
    }

    // The corners so far, the next one at the pointer, and the reason when it is not allowed.
    void draw_outline() const {
        const Palette& p = ui_.palette;
        std::vector<vec2> corners = state_.corners;
        const auto floor = next_corner();
        const bool closes = floor && on_first_corner();
        const OutlineFault fault = floor && !closes ? fault_of_next(corners, *floor) : OutlineFault::none;
        const bool sound = fault == OutlineFault::none || fault == OutlineFault::too_near;
        if (floor && !closes && sound) corners.push_back(*floor);
        area(corners, p.accent);
        line(on_screen(corners), p.accent, 2, corners.size() >= 3);
        if (floor && !sound && !state_.corners.empty())
            line(on_screen({state_.corners.back(), *floor, state_.corners.front()}), p.warning, 2, false);
        for (const vec2 corner : state_.corners)
            if (const auto at = project(frame_.camera_view, corner)) dot({at->x, at->y}, 4, p.accent);
        if (state_.corners.size() >= 3)
            if (const auto first = project(frame_.camera_view, state_.corners[0]))
                list_.AddCircle({first->x, first->y}, ui_.px(closes ? 11.0f : 8.0f), paint(p.accent), 24, ui_.px(2));
        if (floor && !sound && state_.refusal.key.empty()) note(ui_.strings(refusal_of(fault)), p.warning);
        if (floor && closes) note(ui_.strings("scene_input.close"), p.accent);
    }

    bool on_first_corner() const {
        if (state_.corners.size() < 3) return false;
        const auto first = project(frame_.camera_view, state_.corners[0]);
        return first && maths::distance(*first, note_place()) <= ui_.px(11);
    }

    void draw_ghost_lamp(vec2 floor) const {
        line(circle(floor, source_ring * scale_of(frame_.view.now->scene->arena)), ui_.palette.lamp, 2);
        if (const auto bulb = project(frame_.camera_view, floor, bulb_height * scale_of(frame_.view.now->scene->arena)))
            dot({bulb->x, bulb->y}, 6, ui_.palette.lamp);
    }

    void draw_cross(vec2 at) const {
        const float from = ui_.px(4), to = ui_.px(12);
        for (const vec2 way : {vec2{1, 0}, vec2{-1, 0}, vec2{0, 1}, vec2{0, -1}}) {
            const vec2 a = at + way * from, b = at + way * to;
            line({{a.x, a.y}, {b.x, b.y}}, ui_.palette.text, 1.5f, false);
        }
    }

    // The pointer or the crosshair, window pixels.
    vec2 note_place() const {
        const auto crosshair = state_.crosshair ? project(frame_.camera_view, *state_.crosshair) : std::nullopt;
        return crosshair.value_or(frame_.pointer.at);
    }

    void note(std::string_view words, Colour edge) const { note(words, edge, note_place()); }
    void note(std::string_view words, Colour edge, vec2 beside) const { draw_note(frame_, ui_, words, edge, beside); }

    const SceneInputState& state_;
    const SceneInputFrame& frame_;
    const Ui& ui_;
    ImDrawList& list_;
};

// Right of its position and on its side; elsewhere, and farther away, where it would leave the area free of cards or
// cover a label, a vehicle or a bulb.
Rect place_of_note(const SceneInputFrame& frame, const Ui& ui, const LabelSpace& labels, ImVec2 size, vec2 beside,
                   NoteSide side) {
    constexpr float outside = 1e7f;
    const float on_other_side = ui.px(17) * ui.px(17);  // px² of a covered vehicle that are as bad
    const Rect& room = frame.area;
    Rect best;
    float least = -1;
    for (const float layout_gap : {18.0f, 30.0f, 46.0f, 70.0f, 100.0f})
        for (const float across : {1.0f, -1.0f, 0.0f})
            for (const bool above : {false, true}) {
                const float gap = ui.px(layout_gap);
                const float x = across > 0   ? beside.x + gap
                                : across < 0 ? beside.x - gap - size.x
                                             : beside.x - size.x / 2;
                Rect note{std::floor(x), std::floor(above ? beside.y - gap - size.y : beside.y + gap), size.x, size.y};
                const bool leaves = note.x < room.x || note.x + note.w > room.x + room.w || note.y < room.y ||
                                    note.y + note.h > room.y + room.h;
                note.x = std::max(room.x, std::min(note.x, room.x + room.w - note.w));
                note.y = std::max(room.y, std::min(note.y, room.y + room.h - note.h));
                const bool is_other = above ? side == NoteSide::below : side == NoteSide::above;
                const float cost = labels.cost(note) + (leaves ? outside : 0) + (is_other ? on_other_side : 0);
                if (least < 0 || cost < least) best = note, least = cost;
                if (least <= 0) return best;
            }
    return best;
}

// The words may have several lines.
ImVec2 note_size(const Ui& ui, std::string_view words) {
    float width = 0, lines = 0;
    for (std::size_t from = 0; from <= words.size(); ++lines) {
        const std::size_t end = std::min(words.find('\n', from), words.size());
        width = std::max(width, text_width(ui, Face::small, words.substr(from, end - from)));
        from = end + 1;
    }
    return {width + ui.px(spacing::large), lines * line_height(ui, Face::small) + ui.px(spacing::small)};
}

// The words in lines with which a note is no wider than the area.
std::string lines_in(const Ui& ui, std::string_view words, const Rect& area) {
    std::string all;
    for (const std::string& line : even_lines(ui, words, Face::small, area.w - ui.px(spacing::large)))
        all += (all.empty() ? "" : "\n") + line;
    return all;
}

void paint_note(const Ui& ui, const Rect& place, std::string_view words, Colour edge) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImVec2 low{place.x, place.y}, high{place.x + place.w, place.y + place.h};
    list.AddRectFilled(low, high, paint(ui.palette.panel.with_alpha(0.95f)), ui.px(radius::box));
    compat::outline(list, low, high, paint(edge), ui.px(radius::box), ui.px(1.25f));
    put_on(list, ui, {low.x + ui.px(8), low.y + ui.px(4)}, words, ui.palette.text, Face::small);
}

constexpr std::array label_gaps{7.0f, 14.0f, 21.0f, 28.0f, label_reach};

float between_middles(const Rect& a, const Rect& b) { return maths::distance(a.middle(), b.middle()); }

// The free place nearest to the thing that `suits`; on the other side only if there is none on its own.
template <class Suits>
std::optional<Rect> place_of_label(const SceneInputFrame& frame, const Ui& ui, ImVec2 size, const Rect& thing,
                                   NoteSide side, const Suits& suits) {
    const Rect& room = frame.area;
    const float slanted = 0.7071f;
    const vec2 ways[]{{slanted, slanted},
                      {slanted, -slanted},
                      {-slanted, slanted},
                      {-slanted, -slanted},
                      {0, 1},
                      {0, -1},
                      {1, 0},
                      {-1, 0}};
    // From the middle of the thing's side, or from its corner.
    const auto along = [](float way, float low, float length, float own, float gap) {
        if (way == 0) return low + (length - own) / 2;
        return way > 0 ? low + length + way * gap : low + way * gap - own;
    };
    for (const bool other : {false, true})
        for (const float gap : label_gaps)
            for (const vec2 way : ways) {
                if (other != (side == NoteSide::below ? way.y <= 0 : side == NoteSide::above ? way.y >= 0 : false))
                    continue;
                const Rect place{std::floor(along(way.x, thing.x, thing.w, size.x, ui.px(gap))),
                                 std::floor(along(way.y, thing.y, thing.h, size.y, ui.px(gap))), size.x, size.y};
                const bool is_inside = place.x >= room.x && place.x + place.w <= room.x + room.w && place.y >= room.y &&
                                       place.y + place.h <= room.y + room.h;
                if (is_inside && frame.labels->is_free(place) && suits(place)) return place;
            }
    return std::nullopt;
}

// The same, clearly nearer to the thing than to the other one if there is such a place.
std::optional<Rect> place_of_label(const SceneInputFrame& frame, const Ui& ui, ImVec2 size, const Rect& thing,
                                   NoteSide side, const std::optional<Rect>& other) {
    constexpr float clearly = 20, share = 0.5f;  // layout pixels, but at most this share of the things' distance
    const float nearer = other ? std::min(ui.px(clearly), share * between_middles(thing, *other)) : 0;
    const auto is_nearer = [&](const Rect& place) {
        return !other || between_middles(place, thing) + nearer <= between_middles(place, *other);
    };
    if (const auto place = place_of_label(frame, ui, size, thing, side, is_nearer)) return place;
    return place_of_label(frame, ui, size, thing, side, [](const Rect&) { return true; });
}

// From the label to the thing, where there is floor between them.
void draw_leader(const Ui& ui, const Rect& label, const Rect& thing, Colour colour) {
    const vec2 middle = thing.middle();
    const auto nearest = [](const Rect& r, vec2 p) {
        return vec2{std::clamp(p.x, r.x, r.x + r.w), std::clamp(p.y, r.y, r.y + r.h)};
    };
    const vec2 from = nearest(label, middle), to = nearest(thing, from);
    if (maths::distance(from, to) <= ui.px(label_gaps[0] + 1)) return;
    draw_line(ui, {{from.x, from.y}, {to.x, to.y}}, colour, 1.25f, false);
}

}  // namespace

void draw_line(const Ui& ui, const std::vector<ImVec2>& points, Colour colour, float layout_width, bool closed) {
    if (points.size() < 2) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const int count = static_cast<int>(points.size());
    const Colour under = ui.palette.ground.with_alpha(0.55f * colour.a);
    compat::polyline(list, points.data(), count, paint(under), closed, ui.px(layout_width + 2));
    compat::polyline(list, points.data(), count, paint(colour), closed, ui.px(layout_width));
}

void draw_dot(const Ui& ui, ImVec2 at, float layout_radius, Colour colour, float border) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddCircleFilled(at, ui.px(layout_radius + border), paint(ui.palette.ground.with_alpha(0.8f)), 24);
    list.AddCircleFilled(at, ui.px(layout_radius), paint(colour), 24);
}

void draw_handle(const SceneInputFrame& frame, const Ui& ui, maths::vec2 place, bool warm, const std::string& anchor,
                 std::string_view words) {
    const auto at = project(frame.camera_view, place);
    if (!at) return;
    const float radius = (words.empty() ? 6.0f : 8.0f) * finger_size(frame.view);
    draw_dot(ui, {at->x, at->y}, warm ? radius + 2 : radius, warm ? ui.palette.accent : ui.palette.text);
    if (!words.empty()) {
        const float w = text_width(ui, Face::small, words), h = line_height(ui, Face::small);
        put_on(*ImGui::GetBackgroundDrawList(), ui, {at->x - w / 2, at->y - h / 2}, words, ui.palette.ground,
               Face::small);
    }
    ui.anchors.record(anchor, square_around(*at, ui.px(2 * handle_grip) * finger_reach(frame.view)));
}

void draw_label(const SceneInputFrame& frame, const Ui& ui, std::string_view words, Colour edge, Rect thing,
                NoteSide side, std::optional<Rect> other) {
    const auto place = place_of_label(frame, ui, note_size(ui, words), thing, side, other);
    if (!place) return;
    frame.labels->take(*place);
    draw_leader(ui, *place, thing, edge);
    paint_note(ui, *place, words, edge);
}

void draw_note(const SceneInputFrame& frame, const Ui& ui, std::string_view words, Colour edge, maths::vec2 beside,
               NoteSide side) {
    LabelSpace own;
    if (!frame.labels) own.keep_free(*frame.view.now, frame.camera_view);
    LabelSpace& labels = frame.labels ? *frame.labels : own;
    const std::string lines = lines_in(ui, words, frame.area);
    const Rect place = place_of_note(frame, ui, labels, note_size(ui, lines), beside, side);
    labels.take(place);
    paint_note(ui, place, lines, edge);
}

void draw_scene_input(const SceneInputState& state, const SceneInputFrame& frame, const Ui& ui) {
    SceneInputDrawing(state, frame, ui).draw();
}

}  // namespace braitenlab::ui
