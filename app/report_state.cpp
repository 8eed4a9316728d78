#include "app/report_state.h"

#include <algorithm>
#include <cmath>

#include "app/course/lesson_view.h"
#include "app/ctl/report.h"
#include "app/files/safe_file.h"
#include "core/brain/four_neurons.h"
#include "core/io/checked_json.h"
#include "core/io/vehicle_table.h"
#include "core/lesson/path_distance.h"
#include "core/maths/angle.h"
#include "core/scene/enums.h"
#include "core/world/character.h"
#include "ui/scene_input/clipboard.h"

namespace braitenlab {

namespace {

using Json = nlohmann::ordered_json;

// Rounds to six decimals: 0.8, not 0.800000011920929.
double plain(float value) { return std::round(static_cast<double>(value) * 1e6) / 1e6; }

Json pixel(const CameraView& camera_view, float x, float y, float height = 0) {
    const auto at = project(camera_view, {x, y}, height);
    return at ? Json{std::round(at->x), std::round(at->y)} : Json();
}

constexpr std::size_t most_objects = 64;

// The first things of a list, each as `row(thing, its index)`.
Json listed(const auto& things, const auto& row) {
    Json all = Json::array();
    for (std::size_t i = 0; i < std::min(most_objects, things.size()); ++i)
        all.push_back(row(things[i], static_cast<int>(i)));
    return all;
}

void add_objects(Json& state, const Snapshot& now, const CameraView& camera_view) {
    state["vehicles"] = listed(now.vehicles, [&](const VehicleView& v, int) {
        return Json{{"id", v.id},
                    {"kind", v.kind},
                    {"driver", word(v.driver)},
                    {"x", plain(v.x)},
                    {"y", plain(v.y)},
                    {"heading", plain(v.heading)},
                    {"at", pixel(camera_view, v.x, v.y, 0.15f)}};
    });
    state["sources"] = listed(now.scene->sources, [&](const Source& s, int) {
        return Json{{"name", s.name},
                    {"channel", word(s.channel)},
                    {"x", plain(s.x)},
                    {"y", plain(s.y)},
                    {"strength", plain(s.strength)},
                    {"solid", s.solid},
                    {"at", pixel(camera_view, s.x, s.y)}};
    });
    state["obstacles"] = listed(now.scene->obstacles, [&](const Obstacle& o, int index) {
        const Pose place = *place_of(now, {SceneObjectKind::obstacle, index});
        return Json{{"name", o.name},
                    {"x", plain(place.x)},
                    {"y", plain(place.y)},
                    {"heading", plain(place.heading)},
                    {"length", plain(o.length)},
                    {"width", plain(o.width)},
                    {"mass", plain(o.mass)},
                    {"corners", o.corners.size()},
                    {"at", pixel(camera_view, place.x, place.y, obstacle_height(now.scene->arena))}};
    });
    state["zones"] = listed(now.scene->zones, [&](const Zone& z, int) {
        return Json{{"name", z.name},
                    {"x", plain(z.x)},
                    {"y", plain(z.y)},
                    {"heading", plain(z.heading)},
                    {"length", plain(z.length)},
                    {"width", plain(z.width)},
                    {"round", z.round},
                    {"surface", word(z.surface)},
                    {"at", pixel(camera_view, z.x, z.y)}};
    });
}

void add_scene_input(Json& state, const Lab& lab, const ui::SceneInputState& scene_input, const FrameFacts& frame) {
    const Snapshot& now = shown_snapshot(lab);
    state["thing"] = {{"kind", word(lab.view.selection.object.kind)}, {"index", lab.view.selection.object.index}};
    state["chosen"] = selected_objects(lab.view.selection).size();
    state["clipboard"] = ui::object_count(lab.clipboard);
    state["hovered"] = {{"kind", word(scene_input.hovered.object.kind)},
                        {"index", scene_input.hovered.object.index},
                        {"handle", scene_input.hovered.handle}};
    state["cursor"] = frame.hand ? "hand" : "arrow";
    state["tool"] = word(scene_input.tool);
    state["corners"] = scene_input.corners.size();
    add_objects(state, now, frame.camera_view);
}

Json exercise_json(const Lab& lab) {
    if (!lab.document.lesson) return nullptr;
    Json steps = Json::array();
    int number = 0;
    const LessonView lesson = lesson_view_of(lab);
    const Attempt::Answers& answers = lesson.attempt.answers;
    const Attempt::Work& work = lesson.attempt.work;
    for (const Verdict& verdict : lesson.verdicts) steps.push_back({{"id", ++number}, {"done", verdict.done}});
    Json starts = Json::array();
    if (lesson.grade)
        for (const StartResult& start : lesson.grade->starts)
            starts.push_back(
                {{"seed", start.seed}, {"passed", start.passed}, {"step", start.passed ? 0 : failed_step(start) + 1}});
    return {{"id", lab.document.lesson->exercise->id},
            {"chapter", lab.document.lesson->exercise->chapter},
            {"predicted", answers.prediction},
            {"hint", answers.hints_shown},
            {"free_play", work.free_play},
            {"compare", work.compares},
            {"drawn", answers.drawn_path.size()},
            {"path_difference", work.real_path.empty() ? Json(nullptr) : Json(plain(work.path_difference))},
            {"steps", std::move(steps)},
            {"starts", std::move(starts)},
            {"passed", has_passed(*lab.document.lesson)},
            {"together", lesson.together},
            {"notes", lesson.attempt.notes}};
}

// false outside a lecture, true in one without a file.
Json lecture_json(const Lab& lab) {
    if (!lab.pages) return lab.before_lecture.has_value();
    Json hidden = Json::array();
    for (const PagePartTraits& part : page_part_table)
        if (part.value != PagePart::play && !lab.pages->shows(part.value)) hidden.push_back(part.word);
    const bool asks = !lab.pages->current().question.options.empty();
    return {{"file", lab.pages->lecture->id},
            {"page", lab.pages->page + 1},
            {"pages", lab.pages->lecture->pages.size()},
            {"step", lab.pages->step},
            {"hidden", std::move(hidden)},
            {"notes", lab.pages->notes},
            {"hands", asks ? Json(lab.pages->hands[static_cast<std::size_t>(lab.pages->page)]) : Json::array()}};
}

// The pair that the sliders set, and all pairs of the vehicle.
void add_pairs(Json& state, const Snapshot& now, const VehicleView* vehicle, const SensorPair& shown) {
    state["pair"] = "";
    state["pairs"] = Json::array();
    if (!vehicle) return;
    for (const PairCharacter& each :
         characters_of(*brain_of(now, *vehicle), kind_of(now, *vehicle), readings_beside_pairs(now, *vehicle))) {
        if (each.pair.sensors == shown) state["pair"] = each.pair.name;
        state["pairs"].push_back({{"name", each.pair.name},
                                  {"channel", word(each.pair.channel)},
                                  {"character", each.is_wired ? name(each.character) : ""}});
    }
}

void add_brain(Json& state, const Snapshot& now, const VehicleView* vehicle, const std::string& pair_name) {
    const BrainGraph none;
    const BrainGraph& brain = vehicle ? *brain_of(now, *vehicle) : none;
    const SensorPair pair = vehicle ? chosen_pair(kind_of(now, *vehicle), pair_name) : SensorPair{};
    const FourNeurons four = read_dials(brain, pair);
    add_pairs(state, now, vehicle, pair);
    Json weights, thresholds;
    for (const Dial dial : weight_dials) {
        weights[std::string(name(dial))] = plain(at(four, dial));
        thresholds[std::string(name(dial))] = plain(at(four, threshold_of(dial)));
    }
    for (const Dial dial : {Dial::LM, Dial::RM}) weights[std::string(name(dial))] = plain(at(four, dial));
    state["character"] = vehicle ? name(character_of(now, *vehicle)) : "";
    state["weights"] = std::move(weights);
    state["thresholds"] = std::move(thresholds);
    state["lesions"] = std::count_if(brain.nodes.begin(), brain.nodes.end(), [](const Node& n) { return n.silenced; }) +
                       std::count_if(brain.wires.begin(), brain.wires.end(), [](const Wire& w) { return w.cut; });
    state["driver"] = vehicle ? word(vehicle->driver) : "";
    state["motor"] = vehicle ? Json{plain(vehicle->motor[0]), plain(vehicle->motor[1])} : Json(nullptr);
    for (const char* key : {"sensor_ranges", "sensor_names", "sensor_angles"}) state[key] = Json::array();
    state["neurons"] = state["learned"] = Json::object();
    if (vehicle) {
        for (const Sensor& sensor : kind_of(now, *vehicle).sensors) {
            state["sensor_ranges"].push_back(plain(sensor.range));
            state["sensor_names"].push_back(sensor.name);
            state["sensor_angles"].push_back(plain(maths::degrees(sensor.angle)));
        }
        for (const io::BrainValue& each : io::neuron_values(now, *vehicle))
            state["neurons"][each.name] = plain(static_cast<float>(each.value));
        for (const io::BrainValue& each : io::learned_values(now, *vehicle))
            state["learned"][each.name] = plain(static_cast<float>(each.value));
    }
    state["own_sensors"] = vehicle && vehicle->design >= 0;
    state["nodes"] = brain.nodes.size();
    state["wires"] = std::count_if(brain.wires.begin(), brain.wires.end(), [](const Wire& w) { return w.weight != 0; });
}

// The predicted path, ten points a second.
Json prediction_json(const std::optional<PredictionView>& shown) {
    if (!shown) return nullptr;
    constexpr std::size_t step = 6;  // ticks
    Json points = Json::array();
    for (const maths::vec2 at : positions(*shown->path, shown->path->size(), step))
        points.push_back({plain(at.x), plain(at.y)});
    return {{"points", std::move(points)},
            {"seconds", static_cast<double>(shown->path->size() - 1) / 60},
            {"tick", shown->tick},
            {"before", shown->before != nullptr},
            {"fan", shown->fan->size()}};
}

Json why_json(const insight::Why* why) {
    if (!why) return nullptr;
    Json sensors = Json::object();
    for (const insight::SensorPart& part : why->sensors)
        sensors[part.sensor] = {{"reading", plain(part.reading)}, {"value", plain(part.value)}};
    return {{"tick", why->tick},           {"left", plain(why->left)},
            {"right", plain(why->right)},  {"sensors", std::move(sensors)},
            {"bias", plain(why->bias)},    {"rest", plain(why->rest)},
            {"silenced_ticks", why->ticks}};
}

// The vehicle of the last run at this time.
Json ghost_json(const std::optional<GhostView>& ghost) {
    if (!ghost) return nullptr;
    return {{"x", plain(ghost->pose.x)},
            {"y", plain(ghost->pose.y)},
            {"heading", plain(ghost->pose.heading)},
            {"poses", ghost->path->size()}};
}

// Rows of the cells from the first value of y on; null while a cell is not known.
Json map_json(const std::optional<MapView>& map) {
    if (!map) return nullptr;
    const int size = map->cells->size;
    Json rows = Json::array();
    for (int y = 0; y < size; ++y) {
        Json row = Json::array();
        for (int x = 0; x < size; ++x) {
            const auto& cell = map->cells->at({x, y});
            if (!cell)
                row.push_back(nullptr);
            else if (map->measure == insight::MapMeasure::behaviour)
                row.push_back(word(cell->outcome.behaviour));
            else
                row.push_back(plain(insight::number_of(cell->outcome, map->measure)));
        }
        rows.push_back(std::move(row));
    }
    return {{"x", map->x.path},
            {"y", map->y.path},
            {"measure", word(map->measure)},
            {"seeds", map->seeds},
            {"done", map->progress >= 1},
            {"hovered", map->hovered ? Json{map->hovered->x, map->hovered->y} : Json(nullptr)},
            {"cells", std::move(rows)}};
}

// What is stored, and the numbers of the runs; null where there are none.
Json slots_json(const SlotsView& slots) {
    Json all = Json::object();
    for (std::size_t i = 0; i < 2; ++i) {
        const SlotView& slot = slots.slots[i];
        Json& json = all[i == 0 ? "a" : "b"];
        if (!slot.design) continue;
        json = {{"kind", slot.kind},
                {"character", name(slot.character)},
                {"in_vehicle", slot.is_in_vehicle},
                {"sensors", slot.design->sensors.size()},
                {"wires", slot.design->brain.wires.size()}};
        if (!slot.numbers) continue;
        for (const auto& row : insight::compare_measure_table) {
            const float number = (*slot.numbers)[static_cast<std::size_t>(row.value)];
            json["numbers"][std::string(row.word)] = std::isfinite(number) ? Json(plain(number)) : Json(nullptr);
        }
    }
    all["seconds"] = slots.seconds;
    all["ghost"] = ghost_json(slots.b);
    return all;
}

Json study_json(const StudyView& study) {
    if (!study.base) return nullptr;
    const insight::Study& of = study.base->study();
    return {{"id", of.id}, {"runs", of.runs()}, {"done", study.rows->size()}, {"running", study.runs}};
}

// The last complete generation, -1 before the first, and the scores of its champions against the panel.
Json breeding_json(const BreedingView& breeding) {
    if (!breeding.base) return nullptr;
    const int last = last_generation(breeding);
    Json panel = nullptr;
    for (const evolve::Side side : {evolve::Side::predator, evolve::Side::prey}) {
        if (last < 0) break;
        const float score = at(breeding.state->main.generations, side)[static_cast<std::size_t>(last)].panel;
        if (score >= 0) panel[std::string(word(side))] = plain(score);
    }
    Json cell = nullptr;
    if (!breeding.watched.empty()) cell = {breeding.watched.front().predator, breeding.watched.front().prey};
    return {{"generation", last}, {"running", breeding.runs}, {"cell", std::move(cell)}, {"panel", std::move(panel)}};
}

Json robots_json(const std::optional<RobotsView>& robots) {
    if (!robots) return nullptr;
    Json json{{"reality", robots->reality}, {"on", robots->is_on}, {"done", robots->report && robots->progress >= 1},
              {"working", nullptr},         {"weakest", nullptr},  {"replayed", nullptr}};
    if (robots->report) json["working"] = robots->report->working, json["weakest"] = robots->report->weakest + 1;
    if (robots->replayed)
        json["replayed"] = *robots->replayed == every_robot ? Json("all") : Json(*robots->replayed + 1);
    return json;
}

void add_insight(Json& state, const Lab& lab) {
    const LabView view = view_of(lab);
    state["prediction"] = prediction_json(view.features.prediction);
    state["ghost"] = ghost_json(view.features.last_run);
    state["why"] = why_json(view.features.why);
    state["slots"] = slots_json(view.features.slots);
    state["left_run"] = view.features.has_left_run;
    state["mystery"] = {
        {"hidden", view.features.mystery.hidden != no_vehicle},
        {"score", view.features.mystery.score ? Json(view.features.mystery.score->score) : Json(nullptr)}};
    state["map"] = map_json(view.features.map);
    state["study"] = study_json(view.features.study);
    state["breeding"] = breeding_json(view.features.breeding);
    state["robots"] = robots_json(view.features.robots);
}

}  // namespace

std::string anchors_json(const ui::Anchors& anchors) {
    Json all = Json::object();
    for (const auto& [id, r] : anchors.all()) all[id] = {r.x, r.y, r.w, r.h};
    return io::json_text(all, 1) + "\n";
}

std::string state_json(const Lab& lab, const ui::SceneInputState& scene_input, const FrameFacts& frame) {
    const Snapshot& now = shown_snapshot(lab);
    Json state{{"mode", word(lab.playback.mode)},
               {"tick", now.tick},
               {"seconds", now.seconds},
               {"seed", now.seed},
               {"hash", hash_text(lab.document.session.hash())},
               {"time_scale", lab.playback.time_scale},
               {"selected", lab.view.selection.vehicle}};
    add_brain(state, now, find_vehicle(now, lab.view.selection.vehicle), lab.view.selection.pair);
    state["watching"] = lab.view.watching;
    state["toggles"] = lab.playback.toggles;
    state["undo_depth"] = lab.document.session.undo_depth();
    state["redo_depth"] = lab.document.session.redo_depth();
    state["earliest"] = lab.document.session.earliest();
    state["latest"] = lab.document.session.latest();
    state["bookmarks"] = lab.playback.bookmarks.size();
    state["population"] = now.vehicles.size();
    state["predators"] = now.predators;
    state["prey"] = now.prey;
    state["generation"] = now.generation;
    state["overlays"] = {{"trails", lab.view.overlays.trails},
                         {"trail_colour", word(lab.view.overlays.trail_colour.value)},
                         {"surfaces", lab.view.overlays.surfaces},
                         {"memory", lab.view.overlays.memory},
                         {"labels", lab.view.overlays.labels},
                         {"field", lab.view.overlays.field ? word(*lab.view.overlays.field) : ""}};
    state["camera"] = word(lab.view.camera.mode);
    state["view"] = {{"azimuth", lab.view.camera.azimuth},
                     {"elevation", lab.view.camera.elevation},
                     {"zoom", lab.view.camera.zoom},
                     {"pan", {lab.view.camera.pan.x, lab.view.camera.pan.y}}};
    state["opened"] = lab.document.name;
    state["notice"] = lab.notice.words;
    state["notice_key"] = lab.notice.key;
    state["lecture"] = lecture_json(lab);
    state["sensors"] = lab.view.sensors;
    state["focus"] = frame.focus;
    state["menu"] = frame.menu;
    state["typed"] = frame.typed;
    state["probes"] = frame.probes;
    state["strips"] = frame.strips;
    state["language"] = lab.preferences.language;
    state["theme"] = word(lab.preferences.theme);
    state["type_size"] = plain(lab.preferences.type_size);
    state["draw_calls"] = frame.draw_calls;
    state["quality"] = word(frame.quality);
    state["resolution"] = frame.resolution;
    state["text"] = {{"smallest_px", plain(frame.text.smallest)}, {"clipped", frame.text.clipped}};
    state["graphics_watched"] = frame.graphics_watched;
    state["graphics_errors"] = frame.graphics_errors;
    state["frame_ms"] = frame.frame_ms;
    state["frames"] = frame.frames, state["pictures"] = frame.pictures;
    state["pointer"] = {static_cast<int>(frame.pointer.x), static_cast<int>(frame.pointer.y)};
    state["pressed"] = frame.pressed;
    state["exercise"] = exercise_json(lab);
    state["student"] = {{"name", lab.students.student().name},
                        {"students", lab.students.all.size()},
                        {"passed", passed_count(lab.students.student())},
                        {"exercises", lab.students.student().exercises.size()}};
    add_scene_input(state, lab, scene_input, frame);
    add_insight(state, lab);
    return io::json_text(state, 1) + "\n";
}

std::optional<Error> ReportFile::write(std::string text) {
    if (!wanted() || failed_ || text == last_) return std::nullopt;
    FileWriter writer(path_, false);
    writer.write(text);
    if (auto error = writer.commit()) {
        failed_ = true;
        return error;
    }
    last_ = std::move(text);
    return std::nullopt;
}

}  // namespace braitenlab
