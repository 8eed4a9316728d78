// How a scene is shown and what is selected in it. One value, used by the lab, the panels, the renderer and lecture
// mode: a new view flag is a member here, and a line of visit_kept_flags() if the next start restores it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/scene/scene.h"
#include "render/view/camera.h"
#include "render/view/pick.h"
#include "render/view/trail_colour.h"

namespace braitenlab {

inline constexpr int longest_prediction = 20;  // s

// How much work a picture may be. low: plain shapes and pools of light; medium: rounded vehicles that are large on the
// screen, light and shadows from lamps on the floor; high: rounded vehicles also where they are small.
enum class Quality { low, medium, high };
inline constexpr std::array<std::string_view, 3> quality_words{"low", "medium", "high"};
static_assert(has_enumerators<Quality, quality_words.size()>());
constexpr std::string_view word(Quality quality) { return quality_words[static_cast<std::size_t>(quality)]; }

// Layers drawn over the scene, each of which can be switched off.
struct Overlays {
    bool trails = true;  // paths of the vehicles
    TrailColour trail_colour{};
    bool surfaces = true;  // zones: ice, carpet, wind, …
    bool memory = true;    // positions that vehicles remember
    bool labels = true;    // names of things
    bool last_run = true;  // the run before the reset, beside the present one
    int prediction = 8;    // s of the coming path shown while something is tried, up to longest_prediction; 0: none
    std::optional<Channel> field;  // intensity of this channel over the floor, as contours; nullopt: none
    friend bool operator==(const Overlays&, const Overlays&) = default;
};

// A vehicle, and optionally a source, an obstacle or a zone besides it: the brain cards still show the vehicle.
struct Selection {
    VehicleId vehicle = no_vehicle;
    SceneObject object;             // a source, an obstacle or a zone; SceneObject{}: none
    std::vector<SceneObject> more;  // of any kind, selected besides `object` or, if there is none, besides the vehicle
    bool whole_kind = true;         // edits apply to every vehicle of the selected one's kind
    std::string pair;               // KindPair::name of the pair whose wires the sliders set; "": the default one
    friend bool operator==(const Selection&, const Selection&) = default;
};

// The object that the handle turns and the object card shows: the selected source, obstacle or zone, else the vehicle.
inline SceneObject chosen_object(const Selection& selection) {
    return selection.object ? selection.object : vehicle_object(selection.vehicle);
}

// The objects that Delete, copy, arrow keys and a drag act on: the chosen one first. Empty when nothing is selected.
inline std::vector<SceneObject> selected_objects(const Selection& selection) {
    std::vector<SceneObject> all;
    if (const SceneObject chosen = chosen_object(selection)) all.push_back(chosen);
    all.insert(all.end(), selection.more.begin(), selection.more.end());
    return all;
}

inline constexpr float least_canvas_share = 0.25f, largest_canvas_share = 0.75f;

// What a lecture shows its audience. The lecturer hides and reveals it.
struct Revealed {
    bool title = true;        // of the scene, the exercise or the lecture
    bool character = true;    // the name of the recognised character
    bool brain = true;        // the wires on the deck and in the cards
    bool asks_first = false;  // all of it is hidden when another scene is opened
    friend bool operator==(const Revealed&, const Revealed&) = default;
};
inline constexpr Revealed hidden_until_asked{.title = false, .character = false, .brain = false, .asks_first = true};
inline constexpr Revealed revealed_after_asking{.asks_first = true};

struct ViewSettings {
    Camera camera;
    bool orbits = false;  // the camera turns slowly about the framed part of the floor, unless motion is reduced
    Revealed revealed;    // all of it outside a lecture
    Overlays overlays;
    bool watching = false;       // the wiring diagram is shown beside the scene, also while playing
    float canvas_share = 0.45f;  // of the width of both; least_canvas_share .. largest_canvas_share
    bool values = false;         // the card of the arena and the kinds is shown
    bool map = false;            // the map of behaviour is shown
    bool reality = false;        // the trial with real robots is shown
    bool sensors = true;         // fill the sensor fields
    bool outlines = false;       // draw the edges of the sensor fields
    Selection selection;
    friend bool operator==(const ViewSettings&, const ViewSettings&) = default;
};

// The flags that the next start restores: visit(key in its file, flag).
template <class View, class Visit>
void visit_kept_flags(View& view, const Visit& visit) {
    visit("trails", view.overlays.trails);
    visit("zones", view.overlays.surfaces);
    visit("places", view.overlays.memory);
    visit("labels", view.overlays.labels);
    visit("last_run", view.overlays.last_run);
    visit("sensors", view.sensors);
    visit("outlines", view.outlines);
    visit("whole_kind", view.selection.whole_kind);
}

// The settings for another scene. Layers and sensor fields stay as they are; camera, intensity field and selection
// return to their defaults, because they depend on the scene, and so do trails coloured by a sensor; whether edits
// apply to one vehicle or to its kind stays.
inline ViewSettings for_another_scene(ViewSettings settings) {
    settings.camera = {};
    settings.orbits = false;
    settings.overlays.field.reset();
    if (settings.overlays.trail_colour.value == TrailValue::reading) settings.overlays.trail_colour = {};
    if (settings.revealed.asks_first) settings.revealed = hidden_until_asked;
    settings.selection = {.object = {}, .whole_kind = settings.selection.whole_kind, .pair = {}};
    return settings;
}

}  // namespace braitenlab
