#include "app/files/edits_json.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "core/io/command_text.h"

namespace braitenlab {

namespace {

using nlohmann::json;

json json_of(const std::vector<SharedStep>& steps, std::size_t most) {
    json list = json::array();
    for (std::size_t i = steps.size() - std::min(most, steps.size()); i < steps.size(); ++i)
        list.push_back({{"back", json::parse(io::write_commands(steps[i]->back))},
                        {"again", json::parse(io::write_commands(steps[i]->again))},
                        {"tick", steps[i]->tick},
                        {"generation", steps[i]->generation}});
    return list;
}

std::optional<std::vector<SharedStep>> steps_of(const json& list) {
    std::vector<SharedStep> steps;
    for (const json& each : list) {
        auto back = io::read_commands(io::json_text(each.at("back")));
        auto again = io::read_commands(io::json_text(each.at("again")));
        if (!back || !again) return std::nullopt;
        steps.push_back(std::make_shared<const UndoStep>(UndoStep{
            .back = std::move(*back),
            .again = std::move(*again),
            .tick = each.at("tick").get<std::uint64_t>(),
            .generation = each.at("generation").get<int>(),
        }));
    }
    return steps;
}

}  // namespace

json edits_json(const Edits& edits, std::size_t most) {
    return {{"done", json_of(edits.done, most)}, {"undone", json_of(edits.undone, most)}};
}

std::optional<Edits> read_edits(const json& value) {
    try {
        auto done = steps_of(value.at("done")), undone = steps_of(value.at("undone"));
        if (!done || !undone) return std::nullopt;
        return Edits{std::move(*done), std::move(*undone)};
    } catch (const json::exception&) {
        return std::nullopt;
    }
}

}  // namespace braitenlab
