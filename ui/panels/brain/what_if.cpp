// The path without the wire under the pointer: a wire on the deck of the selected vehicle, or of the diagram. (Wires of
// the brain picture and presets: brain_picture.cpp, presets_menu.cpp.)
#include <algorithm>
#include <optional>
#include <vector>

#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "core/maths/geometry.h"
#include "render/view/deck.h"
#include "render/view/drawing.h"
#include "ui/panels/panels.h"
#include "ui/scene_input/draw.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float reach_of_deck_wire = 5, least_deck = 48;  // layout pixels; of the vehicle's length on the screen
constexpr int deck_pieces = 12;

struct DeckHit {
    WireEnds ends;
    std::vector<ImVec2> line;  // window pixels
};

// A wire's curve on the screen; empty if a part of it is behind the camera.
std::vector<ImVec2> on_screen(const CameraView& camera_view, const VehicleView& vehicle, const render::DeckWire& wire,
                              float height) {
    const vec2 place{vehicle.x, vehicle.y}, ahead = maths::direction(vehicle.heading);
    std::vector<ImVec2> line;
    for (int i = 0; i <= deck_pieces; ++i) {
        const float t = static_cast<float>(i) / deck_pieces, u = 1 - t;
        const vec2 own = wire.from * (u * u) + wire.bend * (2 * u * t) + wire.to * (t * t);
        const auto at = project(camera_view, place + maths::rotate(own, ahead), height);
        if (!at) return {};
        line.push_back({at->x, at->y});
    }
    return line;
}

float distance_to_line(const std::vector<ImVec2>& line, vec2 point) {
    float least = 1e9f;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const vec2 on = maths::nearest_on_segment(point, {line[i - 1].x, line[i - 1].y}, {line[i].x, line[i].y});
        least = std::min(least, maths::distance(on, point));
    }
    return least;
}

// The wire on the deck of the selected vehicle that is nearest to the pointer.
std::optional<DeckHit> deck_wire(const LabView& view, const PanelState& state, const Ui& ui,
                                 const VehicleView& vehicle) {
    const SceneInputState& input = state.scene_input;
    const bool is_free = input.over && input.drag.phase == SceneInputPhase::idle && input.tool == SceneInputTool::hand;
    if (!view.camera_view || !is_free || input.hovered.object != vehicle_object(vehicle.id)) return std::nullopt;
    const Kind& kind = kind_of(*view.now, vehicle);
    const vec2 place{vehicle.x, vehicle.y};
    if (pixels_per_metre(*view.camera_view, place) * kind.body.length < least_deck * ui.scale) return std::nullopt;
    const BrainGraph& brain = *brain_of(*view.now, vehicle);
    const float height = render::deck_height * render::height_scale_of(kind.body);
    std::optional<DeckHit> nearest;
    float least = reach_of_deck_wire * ui.scale;
    for (const render::DeckWire& each : render::plan_deck(brain, kind).wires) {
        std::vector<ImVec2> line = on_screen(*view.camera_view, vehicle, each, height);
        const float away = distance_to_line(line, input.pointer);
        if (away > least) continue;
        least = away;
        const Wire& wire = brain.wires[each.wire];
        nearest = DeckHit{{wire.from, wire.to}, std::move(line)};
    }
    return nearest;
}

std::string words_of(const LabView& view, const Ui& ui, const VehicleView& vehicle, WireEnds ends, bool is_cut) {
    const std::string name = wiring::short_wire_name(kind_of(*view.now, vehicle).sensors, *brain_of(*view.now, vehicle),
                                                     ends, shown_pair(view, vehicle));
    return fill(ui.strings(is_cut ? "what_if.with_wire" : "what_if.without_wire"), {name});
}

void draw_deck_wire(const LabView& view, const Ui& ui, Rect area, const VehicleView& vehicle, const DeckHit& hit,
                    bool is_cut) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const int count = static_cast<int>(hit.line.size());
    draw.AddPolyline(hit.line.data(), count, paint(ui.palette.panel), 0, ui.px(5));
    draw.AddPolyline(hit.line.data(), count, paint(ui.palette.accent), 0, ui.px(3));
    const std::string words = words_of(view, ui, vehicle, hit.ends, is_cut);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const SceneInputFrame frame{view, *view.camera_view, ui.scale, area, {}};
    draw_note(frame, ui, words, ui.palette.accent, {mouse.x, mouse.y}, NoteSide::above);
}

// The words in the upper left corner of the wiring editor's inset, far from the pointer: they say what the path is.
void name_inset(const Ui& ui, Rect inset, std::string_view words) {
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    const float edge = ui.px(6), beside = ui.px(spacing::small), height = line_height(ui, Face::small) + ui.px(8);
    const std::string shown = shortened(ui, words, Face::small, inset.w - 2 * (edge + beside));
    const Rect box{inset.x + edge, inset.y + edge, text_width(ui, Face::small, shown) + 2 * beside, height};
    draw.AddRectFilled({box.x, box.y}, {box.x + box.w, box.y + box.h}, paint(ui.palette.panel.with_alpha(0.95f)),
                       ui.px(radius::box));
    put_on(draw, ui, {box.x + beside, box.y + ui.px(4)}, shown, ui.palette.text, Face::small);
    ui.anchors.record("what_if", box);
}

}  // namespace

void try_without_wire(const LabView& view, PanelState& state, const Ui& ui, Rect area) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!state.brain.what_if.empty() || !vehicle || vehicle->driver != Driver::brain) return;
    if (hides_brain(view, vehicle->kind)) return;
    const wiring::CanvasState& canvas = state.canvas;
    const bool edits = view.mode == Mode::wiring;
    const bool is_on_canvas = (view.settings.watching || edits) && canvas.hovered.is_wire() && !canvas.menu.open() &&
                              canvas.drag.phase == wiring::DragPhase::idle;
    std::optional<DeckHit> on_deck;
    if (!is_on_canvas && !edits) on_deck = deck_wire(view, state, ui, *vehicle);
    if (!is_on_canvas && !on_deck) return;
    const WireEnds ends = is_on_canvas ? canvas.hovered.wire : on_deck->ends;
    BrainGraph brain = *brain_of(*view.now, *vehicle);
    Wire* wire = find_wire(brain, ends.from, ends.to);
    if (!wire) return;
    if (on_deck) draw_deck_wire(view, ui, area, *vehicle, *on_deck, wire->cut);
    if (edits && view.settings.overlays.prediction > 0 && may_show_future(view))
        name_inset(ui, area, words_of(view, ui, *vehicle, ends, wire->cut));
    wire->cut = !wire->cut;
    state.brain.what_if = {SetBrain{target_of(view, *vehicle), std::move(brain)}};
}

}  // namespace braitenlab::ui
