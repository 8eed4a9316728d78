#include "core/world/moment_json.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/scene/scene_file.h"
#include "core/world/check_moment.h"

namespace braitenlab {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Motion, place, ahead, velocity, turning, heading)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Touch, one, other)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Bite, pair, tick)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Mark, owner, place, tick)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EventCounts, captures, deaths, births, contacts, falls)

namespace {

// Vehicles share designs; each is written once and known by its number.
struct DesignTable {
    std::map<const Design*, int> number;
    Json graphs = Json::array();

    int add(const SharedDesign& design) {
        const auto [known, is_new] = number.try_emplace(design.get(), static_cast<int>(number.size()));
        if (is_new) graphs.push_back(design->graph);
        return known->second;
    }
};

// Designs are made anew from their graphs, one for each kind that uses one.
class Designs {
public:
    Designs(const Json& graphs, const Scene& scene) : graphs_(graphs.get<std::vector<BrainGraph>>()), scene_(scene) {}

    Result<SharedDesign> make(std::size_t number, std::size_t kind) {
        if (number >= graphs_.size()) return Error{fmt::format("there is no brain number {}", number)};
        if (kind >= scene_.kinds.size()) return Error{fmt::format("there is no kind number {}", kind)};
        SharedDesign& design = made_[{number, kind}];
        if (design) return design;
        auto made = make_design(graphs_[number], scene_.kinds[kind]);
        if (made) design = *made;
        return made;
    }

private:
    std::vector<BrainGraph> graphs_;
    const Scene& scene_;
    std::map<std::pair<std::size_t, std::size_t>, SharedDesign> made_;
};

Json vehicles_json(const Vehicles& v, DesignTable& designs) {
    Json design = Json::array();
    for (const SharedDesign& one : v.design) design.push_back(designs.add(one));
    return {{"id", v.id},
            {"kind", v.kind},
            {"start", v.start},
            {"driver", v.driver},
            {"motion", v.motion},
            {"energy", v.energy},
            {"hand", v.hand},
            {"waypoint", v.waypoint},
            {"gain", v.gain},
            {"motor", v.motor},
            {"wheel_angle", v.wheel_angle},
            {"design", design},
            {"sensed", v.sensed},
            {"neurons", v.neurons},
            {"late", v.late}};
}

std::optional<Error> read_vehicles(const Json& json, const Scene& scene, Designs& designs, Vehicles& v) {
    json.at("id").get_to(v.id);
    json.at("kind").get_to(v.kind);
    json.at("start").get_to(v.start);
    json.at("driver").get_to(v.driver);
    json.at("motion").get_to(v.motion);
    json.at("energy").get_to(v.energy);
    json.at("hand").get_to(v.hand);
    json.at("waypoint").get_to(v.waypoint);
    json.at("gain").get_to(v.gain);
    json.at("motor").get_to(v.motor);
    json.at("wheel_angle").get_to(v.wheel_angle);
    json.at("sensed").get_to(v.sensed);
    json.at("neurons").get_to(v.neurons);
    json.at("late").get_to(v.late);
    const auto design = json.at("design").get<std::vector<std::size_t>>();
    if (design.size() != v.size() || v.kind.size() != v.size())
        return Error{"not every vehicle has a kind and a brain"};
    std::uint32_t sensed = 0, neurons = 0, late = 0;
    for (std::size_t row = 0; row < v.size(); ++row) {
        const auto kind = static_cast<std::size_t>(v.kind[row]);
        auto made = designs.make(design[row], kind);
        if (!made) return made.error();
        v.first_sensed.push_back(sensed);
        v.first_neuron.push_back(neurons);
        v.first_late.push_back(late);
        sensed += static_cast<std::uint32_t>(scene.kinds[kind].sensors.size());
        late += late_readings(scene.kinds[kind]);
        neurons += static_cast<std::uint32_t>((*made)->brain.state_size());
        v.design.push_back(*made);
    }
    if (v.sensed.size() != sensed || v.neurons.size() != neurons || v.late.size() != late)
        return Error{"the vehicles' readings and neurons do not fit their sensors and brains"};
    return std::nullopt;
}

}  // namespace

Json moment_json(const Moment& m) {
    DesignTable designs;
    Json newcomers = Json::array();
    for (const SharedDesign& design : m.newcomers) newcomers.push_back(designs.add(design));
    Json vehicles = vehicles_json(m.vehicles, designs);
    return {{"scene", *m.scene},
            {"brains", designs.graphs},
            {"newcomers", newcomers},
            {"seed", m.seed},
            {"tick", m.tick},
            {"generation", m.generation},
            {"still_ticks", m.still_ticks},
            {"next_id", m.next_id},
            {"events", m.events},
            {"bites", m.bites},
            {"marks", m.marks},
            {"vehicles", vehicles},
            {"obstacles", m.obstacles},
            {"touching", m.touching}};
}

Result<Moment> read_moment(const Json& json) {
    Moment m;
    auto scene = std::make_shared<Scene>(json.at("scene").get<Scene>());
    if (auto error = check_scene(*scene)) return *error;
    m.scene = scene;
    Designs designs(json.at("brains"), *scene);
    const auto newcomers = json.at("newcomers").get<std::vector<std::size_t>>();
    for (std::size_t kind = 0; kind < newcomers.size(); ++kind) {
        auto design = designs.make(newcomers[kind], kind);
        if (!design) return design.error();
        m.newcomers.push_back(*design);
    }
    json.at("seed").get_to(m.seed);
    json.at("tick").get_to(m.tick);
    json.at("generation").get_to(m.generation);
    json.at("still_ticks").get_to(m.still_ticks);
    json.at("next_id").get_to(m.next_id);
    json.at("events").get_to(m.events);
    json.at("bites").get_to(m.bites);
    json.at("marks").get_to(m.marks);
    json.at("obstacles").get_to(m.obstacles);
    json.at("touching").get_to(m.touching);
    if (auto error = read_vehicles(json.at("vehicles"), *scene, designs, m.vehicles)) return *error;
    if (auto error = check_moment(m)) return *error;
    return m;
}

}  // namespace braitenlab
