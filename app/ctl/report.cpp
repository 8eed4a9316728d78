#include "app/ctl/report.h"

#include <cmath>

#include <fmt/format.h>

#include "app/terminal.h"
#include "core/io/checked_json.h"
#include "core/io/vehicle_table.h"
#include "core/scene/enums.h"

namespace braitenlab {

namespace {

using Json = nlohmann::ordered_json;

Json sources_json(const Snapshot& now) {
    Json list = Json::array();
    for (const SourceView& s : now.sources)
        list.push_back({{"id", now.scene->sources[static_cast<std::size_t>(s.source)].name},
                        {"channel", word(s.channel)},
                        {"x", s.x},
                        {"y", s.y}});
    return list;
}

// An object of numbers by name.
Json by_name(const std::vector<io::BrainValue>& values) {
    Json json = Json::object();
    for (const io::BrainValue& each : values) json[each.name] = each.value;
    return json;
}

Json vehicles_json(const Snapshot& now) {
    Json list = Json::array();
    for (const VehicleView& v : now.vehicles) {
        const Kind& kind = kind_of(now, v);
        Json sensors = Json::array();
        for (std::size_t i = 0; i < kind.sensors.size(); ++i)
            sensors.push_back(now.sensed[static_cast<std::size_t>(v.first_sensed) + i]);
        list.push_back({{"id", v.id},
                        {"kind", kind.name},
                        {"role", word(v.role)},
                        {"x", v.x},
                        {"y", v.y},
                        {"heading", v.heading},
                        {"speed", v.speed},
                        {"energy", v.energy},
                        {"left", v.motor[0]},
                        {"right", v.motor[1]},
                        {"sensors", std::move(sensors)},
                        {"neurons", by_name(io::neuron_values(now, v))},
                        {"learned", by_name(io::learned_values(now, v))}});
    }
    return list;
}

}  // namespace

Json rounded_json(float number) {
    if (!std::isfinite(number)) return nullptr;
    return std::round(static_cast<double>(number) * 1e5) / 1e5;
}

std::string hash_text(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

std::string report_json(const Snapshot& now, std::uint64_t hash) {
    const Json report{{"scene", now.scene->name},
                      {"seed", now.seed},
                      {"ticks", now.tick},
                      {"seconds", now.seconds},
                      {"hash", hash_text(hash)},
                      {"generation", now.generation},
                      {"population", now.vehicles.size()},
                      {"predators", now.predators},
                      {"prey", now.prey},
                      {"events",
                       {{"captures", now.events.captures},
                        {"deaths", now.events.deaths},
                        {"births", now.events.births},
                        {"contacts", now.events.contacts}}},
                      {"sources", sources_json(now)},
                      {"vehicles", vehicles_json(now)}};
    return io::json_text(report, 2) + "\n";
}

std::string report_text(const Snapshot& now, std::uint64_t hash) {
    std::string text = format_lines("{}, seed {}, {:.1f} s ({} ticks), hash {}\n", now.scene->name, now.seed,
                                    now.seconds, now.tick, hash_text(hash));
    text +=
        fmt::format("generation {}, {} vehicles ({} predators, {} prey), {} captures, {} contacts\n", now.generation,
                    now.vehicles.size(), now.predators, now.prey, now.events.captures, now.events.contacts);
    return text;
}

}  // namespace braitenlab
