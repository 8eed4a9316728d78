#include "app/report_state.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report.h"
#include "core/brain/four_neurons.h"
#include "core/brain/recogniser.h"
#include "core/scene/names.h"

namespace braitenlab {

namespace {

using Json = nlohmann::ordered_json;

// A float as people write it: 0.8, not 0.800000011920929.
double plain(float value) { return std::round(static_cast<double>(value) * 1e6) / 1e6; }

const char* mode_word(Mode mode) {
    switch (mode) {
        case Mode::playing:
            return "playing";
        case Mode::paused:
            return "paused";
        case Mode::wiring:
            return "wiring";
    }
    return "";
}

const char* camera_word(CameraMode mode) {
    switch (mode) {
        case CameraMode::overview:
            return "overview";
        case CameraMode::follow:
            return "follow";
        case CameraMode::birds_eye:
            return "birds_eye";
        case CameraMode::driver:
            return "driver";
    }
    return "";
}

Json exercise_json(const Lab& lab) {
    if (!lab.lesson) return nullptr;
    Json steps = Json::array();
    int number = 0;
    for (const Verdict& verdict : lab.lesson->view.verdicts)
        steps.push_back({{"id", ++number}, {"done", verdict.done}});
    return {{"id", lab.lesson->exercise->id},
            {"steps", std::move(steps)},
            {"passed", lab.lesson->view.grade && lab.lesson->view.grade->good}};
}

void add_brain(Json& state, const Snapshot& now, const VehicleView* vehicle) {
    const BrainGraph none;
    const BrainGraph& brain = vehicle ? *now.brains[static_cast<std::size_t>(vehicle->brain)] : none;
    const FourNeurons four = read_dials(brain);
    Json weights, thresholds;
    for (const Dial dial : weight_dials) {
        weights[std::string(name(dial))] = plain(at(four, dial));
        thresholds[std::string(name(dial))] = plain(at(four, threshold_of(dial)));
    }
    for (const Dial dial : {Dial::LM, Dial::RM}) weights[std::string(name(dial))] = plain(at(four, dial));
    state["character"] = vehicle ? name(recognise(brain)) : "";
    state["weights"] = std::move(weights);
    state["thresholds"] = std::move(thresholds);
    state["lesions"] = std::count_if(brain.nodes.begin(), brain.nodes.end(), [](const Node& n) { return n.silenced; }) +
                       std::count_if(brain.wires.begin(), brain.wires.end(), [](const Wire& w) { return w.cut; });
    state["driver"] = vehicle ? word(vehicle->driver) : "";
    state["motor"] = vehicle ? Json{plain(vehicle->motor[0]), plain(vehicle->motor[1])} : Json(nullptr);
    Json ranges = Json::array();
    if (vehicle)
        for (const Sensor& sensor : now.scene->kinds[static_cast<std::size_t>(vehicle->kind)].sensors)
            ranges.push_back(plain(sensor.range));
    state["sensor_ranges"] = std::move(ranges);
    state["nodes"] = brain.nodes.size();
    state["wires"] = std::count_if(brain.wires.begin(), brain.wires.end(), [](const Wire& w) { return w.weight != 0; });
}

}  // namespace

std::string anchors_json(const Anchors& anchors) {
    Json all = Json::object();
    for (const auto& [id, r] : anchors.all()) all[id] = {r.x, r.y, r.w, r.h};
    return all.dump(1) + "\n";
}

std::string state_json(const Lab& lab, const FrameFacts& frame) {
    const Snapshot& now = lab.session.snapshot();
    Json state{{"mode", mode_word(lab.mode)},  {"tick", now.tick},
               {"seconds", now.seconds},       {"hash", hash_text(lab.session.hash())},
               {"time_scale", lab.time_scale}, {"selected", lab.selected}};
    add_brain(state, now, find_vehicle(now, lab.selected));
    state["toggles"] = lab.toggles;
    state["undo_depth"] = lab.session.undo_depth();
    state["redo_depth"] = lab.session.redo_depth();
    state["population"] = now.vehicles.size();
    state["predators"] = now.predators;
    state["prey"] = now.prey;
    state["generation"] = now.generation;
    state["camera"] = camera_word(lab.camera.mode);
    state["view"] = {{"azimuth", lab.camera.azimuth}, {"elevation", lab.camera.elevation}, {"zoom", lab.camera.zoom}};
    state["opened"] = lab.name;
    state["notice"] = lab.notice;
    state["language"] = lab.preferences.language;
    state["theme"] = lab.preferences.theme == Theme::light ? "light" : "dark";
    state["type_size"] = plain(lab.preferences.type_size);
    state["draw_calls"] = frame.draw_calls;
    state["frame_ms"] = frame.frame_ms;
    state["exercise"] = exercise_json(lab);
    return state.dump(1) + "\n";
}

std::optional<Error> KeptFile::write(std::string text) {
    if (!wanted() || failed_ || text == last_) return std::nullopt;
    const std::filesystem::path beside = path_.string() + ".new";
    std::ofstream file(beside);
    file << text;
    file.close();
    std::error_code problem;
    if (file) std::filesystem::rename(beside, path_, problem);
    if (!file || problem) {
        failed_ = true;
        return Error{"could not be written; check that the folder exists, may be written to and has room",
                     path_.string()};
    }
    last_ = std::move(text);
    return std::nullopt;
}

}  // namespace braitenlab
