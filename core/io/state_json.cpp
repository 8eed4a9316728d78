#include "core/io/state_json.h"

#include <map>
#include <tuple>

#include "core/messages.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(VehicleLook, vehicle, look)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EventCounts, captures, deaths, births, contacts, falls)

namespace mechanics {
void visit_motion(auto members, auto& m) {
    members.value("place", m.position), members.value("ahead", m.ahead), members.value("velocity", m.velocity);
    members.value("turning", m.angular_velocity), members.value("heading", m.heading);
}
void to_json(io::Json& json, const Motion& m) { visit_motion(io::JsonWriter{json}, m); }
void from_json(const io::Json& json, Motion& m) { visit_motion(io::JsonReader{json}, m); }
}  // namespace mechanics

namespace world {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Touch, one, other)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Bite, pair, tick)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Strike, vehicle, at, tick, other)
void to_json(io::Json& json, const Mark& m) { json = {{"owner", m.owner}, {"place", m.position}, {"tick", m.tick}}; }
void from_json(const io::Json& json, Mark& m) {
    json.at("owner").get_to(m.owner);
    json.at("place").get_to(m.position);
    json.at("tick").get_to(m.tick);
}
}  // namespace world

namespace io {

using world::CompiledBrain;
using world::OwnDesign;
using world::SharedBrain;
using world::SharedDesign;
using world::State;
using world::Vehicles;

namespace {

// Numbers the brains of a state. Vehicles share brains: each graph is written once and referred to by its index.
struct BrainTable {
    std::map<const CompiledBrain*, int> number;
    Json graphs = Json::array();

    int add(const SharedBrain& brain) {
        const auto [known, is_new] = number.try_emplace(brain.get(), static_cast<int>(number.size()));
        if (is_new) graphs.push_back(brain->graph);
        return known->second;
    }
};

// Compiles the graphs of a file, each graph once per kind or own design that uses it.
class BrainMaker {
public:
    BrainMaker(const Json& graphs, const Scene& scene)
        : graphs_(graphs.get<std::vector<BrainGraph>>()), scene_(scene) {}

    // `design`: that of a vehicle with sensors of its own, or null.
    Result<SharedBrain> make(std::size_t number, std::size_t kind, const OwnDesign* design = nullptr) {
        if (number >= graphs_.size()) return error_of(message_of("no_brain_number", number));
        if (kind >= scene_.kinds.size()) return error_of(message_of("no_kind_number", kind));
        SharedBrain& brain = made_[{number, kind, design}];
        if (brain) return brain;
        auto made = world::compile_brain(graphs_[number], design ? design->kind : scene_.kinds[kind]);
        if (made) brain = *made;
        return made;
    }

private:
    std::vector<BrainGraph> graphs_;
    const Scene& scene_;
    std::map<std::tuple<std::size_t, std::size_t, const OwnDesign*>, SharedBrain> made_;
};

// The sensor lists of vehicles that have their own, each list once, and the index of each vehicle's list, −1 without
// one. Absent when no vehicle has its own.
void add_own_sensors(Json& json, const Vehicles& v) {
    std::map<const OwnDesign*, int> number;
    Json lists = Json::array(), of_vehicle = Json::array();
    for (const SharedDesign& design : v.design) {
        int index = -1;
        if (design) {
            const auto [known, is_new] = number.try_emplace(design.get(), static_cast<int>(number.size()));
            if (is_new) lists.push_back(design->kind.sensors);
            index = known->second;
        }
        of_vehicle.push_back(index);
    }
    if (number.empty()) return;
    json["sensor_lists"] = lists;
    json["own_sensors"] = of_vehicle;
}

// The design of a vehicle of the kind with sensors from a file.
Result<SharedDesign> read_design(const Kind& kind, const std::vector<Sensor>& sensors) {
    Scene alone;
    alone.kinds = {kind};
    alone.kinds.front().sensors = sensors;
    if (auto error = check_scene(alone)) return *error;
    return world::own_design(kind, sensors);
}

std::optional<Error> read_own_sensors(const Json& json, const Scene& scene, Vehicles& v) {
    v.design.resize(v.size());
    if (!json.contains("own_sensors")) return std::nullopt;
    const auto lists = json.at("sensor_lists").get<std::vector<std::vector<Sensor>>>();
    const auto of_vehicle = json.at("own_sensors").get<std::vector<int>>();
    if (of_vehicle.size() != v.size()) return error_of(message_of("vehicles_incomplete"));
    std::map<std::pair<int, std::int32_t>, SharedDesign> made;  // by list and kind
    for (std::size_t row = 0; row < v.size(); ++row) {
        const int list = of_vehicle[row];
        if (list < 0) continue;
        if (static_cast<std::size_t>(list) >= lists.size()) return error_of(message_of("no_sensors_number", list));
        const auto [known, is_new] = made.try_emplace({list, v.kind[row]});
        if (is_new) {
            auto design =
                read_design(scene.kinds[static_cast<std::size_t>(v.kind[row])], lists[static_cast<std::size_t>(list)]);
            if (!design) return design.error();
            known->second = *design;
        }
        v.design[row] = known->second;
    }
    return std::nullopt;
}

Json vehicles_json(const Vehicles& v, BrainTable& brains) {
    Json brain = Json::array();
    for (const SharedBrain& one : v.brain) brain.push_back(brains.add(one));
    Json json{{"design", brain}, {"sensed", v.sensed}, {"neurons", v.neurons}, {"late", v.delayed}};
    add_own_sensors(json, v);
    world::each_vehicle_value([&](const auto& value) { json[std::string(value.word)] = v.*value.column; });
    return json;
}

std::optional<Error> read_vehicles(const Json& json, const Scene& scene, BrainMaker& brains, Vehicles& v) {
    world::each_vehicle_value([&](const auto& value) { json.at(std::string(value.word)).get_to(v.*value.column); });
    json.at("sensed").get_to(v.sensed);
    json.at("neurons").get_to(v.neurons);
    json.at("late").get_to(v.delayed);
    const auto brain = json.at("design").get<std::vector<std::size_t>>();
    if (brain.size() != v.size() || v.kind.size() != v.size()) return error_of(message_of("vehicles_incomplete"));
    const auto count = static_cast<std::int32_t>(scene.kinds.size());
    for (const std::int32_t kind : v.kind)
        if (kind < 0 || kind >= count) return error_of(message_of("no_kind_number", kind));
    if (auto error = read_own_sensors(json, scene, v)) return error;
    std::uint32_t sensed = 0, neurons = 0, late = 0;
    for (std::size_t row = 0; row < v.size(); ++row) {
        const auto kind = static_cast<std::size_t>(v.kind[row]);
        const OwnDesign* own = v.design[row].get();
        auto made = brains.make(brain[row], kind, own);
        if (!made) return made.error();
        const Kind& design = own ? own->kind : scene.kinds[kind];
        v.first_sensed.push_back(sensed);
        v.first_neuron.push_back(neurons);
        v.first_delayed.push_back(late);
        sensed += static_cast<std::uint32_t>(design.sensors.size());
        late += world::delayed_readings(design);
        neurons += static_cast<std::uint32_t>((*made)->flat.state_size());
        v.brain.push_back(*made);
    }
    if (v.sensed.size() != sensed || v.neurons.size() != neurons || v.delayed.size() != late)
        return error_of(message_of("vehicles_incomplete"));
    return std::nullopt;
}

void visit_world_values(auto members, auto& m) {
    members.value("seed", m.seed), members.value("tick", m.tick), members.value("generation", m.generation);
    members.value("still_ticks", m.still_ticks), members.value("next_id", m.next_id);
    members.value("events", m.events), members.value("bites", m.bites), members.value("strikes", m.strikes);
    members.value("marks", m.marks), members.value("looks", m.looks);
    members.value("obstacles", m.obstacles), members.value("touching", m.touching);
}

}  // namespace

Json state_json(const State& m) {
    BrainTable brains;
    Json kind_brains = Json::array();
    for (const SharedBrain& brain : m.kind_brains) kind_brains.push_back(brains.add(brain));
    Json vehicles = vehicles_json(m.vehicles, brains);
    Json json{{"scene", *m.scene}, {"brains", brains.graphs}, {"newcomers", kind_brains}, {"vehicles", vehicles}};
    visit_world_values(JsonWriter{json}, m);
    return json;
}

Result<State> read_state(const Json& json) {
    State m;
    auto scene = std::make_shared<Scene>(json.at("scene").get<Scene>());
    if (auto error = check_scene(*scene)) return *error;
    m.scene = scene;
    BrainMaker brains(json.at("brains"), *scene);
    const auto kind_brains = json.at("newcomers").get<std::vector<std::size_t>>();
    for (std::size_t kind = 0; kind < kind_brains.size(); ++kind) {
        auto brain = brains.make(kind_brains[kind], kind);
        if (!brain) return brain.error();
        m.kind_brains.push_back(*brain);
    }
    visit_world_values(JsonReader{json}, m);
    m.parts_seed = m.seed;  // other worlds are predictions, which are not saved
    if (auto error = read_vehicles(json.at("vehicles"), *scene, brains, m.vehicles)) return *error;
    if (auto error = check_state(m)) return *error;
    return m;
}

}  // namespace io
}  // namespace braitenlab
