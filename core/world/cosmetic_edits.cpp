#include "core/world/cosmetic_edits.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/world/state.h"

namespace braitenlab::world {

namespace {

void put(BrainGraph& graph, const std::vector<NodePlace>& places) {
    for (const NodePlace& place : places)
        for (Node& node : graph.nodes)
            if (node.id == place.node) node.place = place.at;
}

// BrainMaker with their nodes moved; vehicles that share one go on sharing.
class Moved {
public:
    explicit Moved(const std::vector<NodePlace>& places) : places_(places) {}

    void move(SharedBrain& brain) {
        SharedBrain& moved = made_[brain];
        if (!moved) {
            CompiledBrain copy = *brain;
            put(copy.graph, places_);
            moved = std::make_shared<const CompiledBrain>(std::move(copy));
        }
        brain = moved;
    }

private:
    const std::vector<NodePlace>& places_;
    std::map<SharedBrain, SharedBrain> made_;  // looked up in, never walked through
};

bool is_on_canvas(const NodePlace& place) {
    const auto within = [](float along) { return std::fabs(along) <= limits::place; };  // false for NaN
    return !place.at || (within(place.at->x) && within(place.at->y));
}

std::optional<Error> refusal(const State& m, const PlaceNodes& c) {
    if (!std::all_of(c.places.begin(), c.places.end(), is_on_canvas))
        return Error{fmt::format("a node stands within -{0} .. {0} canvas units", limits::place)};
    const auto& ids = m.vehicles.id;
    if (c.target.vehicle != no_vehicle && !std::binary_search(ids.begin(), ids.end(), c.target.vehicle))
        return Error{fmt::format("vehicle {} is no longer in the world; select another one", c.target.vehicle)};
    const bool has_kind = c.target.kind >= 0 && static_cast<std::size_t>(c.target.kind) < m.kind_brains.size();
    if (c.target.vehicle == no_vehicle && !has_kind)
        return Error{fmt::format("the scene has no kind number {}", c.target.kind)};
    return std::nullopt;
}

}  // namespace

bool is_cosmetic(const Command& command) { return std::holds_alternative<PlaceNodes>(command); }

std::vector<NodePlace> places_of(const BrainGraph& graph) {
    std::vector<NodePlace> places;
    for (const Node& node : graph.nodes) places.push_back({node.id, node.place});
    return places;
}

std::optional<Error> place_nodes(State& m, const PlaceNodes& c) {
    if (auto error = refusal(m, c)) return error;
    Moved moved(c.places);
    const bool one = c.target.vehicle != no_vehicle;
    for (std::size_t row = 0; row < m.vehicles.size(); ++row)
        if (one ? m.vehicles.id[row] == c.target.vehicle : m.vehicles.kind[row] == c.target.kind)
            moved.move(m.vehicles.brain[row]);
    if (!one) moved.move(m.kind_brains[static_cast<std::size_t>(c.target.kind)]);
    return std::nullopt;
}

std::shared_ptr<const State> with_places(const State& moment, const PlaceNodes& c) {
    auto moved = std::make_shared<State>(moment);
    (void)place_nodes(*moved, c);  // the vehicle may not be there yet
    return moved;
}

Command keeping_places(Command later, const PlaceNodes& moved) {
    if (auto* brain = std::get_if<SetBrain>(&later); brain && brain->target == moved.target)
        put(brain->brain, moved.places);
    if (auto* places = std::get_if<PlaceNodes>(&later); places && places->target == moved.target)
        std::erase_if(places->places, [&](const NodePlace& place) {
            return std::any_of(moved.places.begin(), moved.places.end(),
                               [&](const NodePlace& known) { return known.node == place.node; });
        });
    return later;
}

}  // namespace braitenlab::world
