#include "core/world/cosmetic_edits.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/messages.h"
#include "core/scene/scene_file.h"
#include "core/world/state.h"

namespace braitenlab::world {

namespace {

void set_places(BrainGraph& graph, const std::vector<NodePlace>& places) {
    for (const NodePlace& place : places)
        for (Node& node : graph.nodes)
            if (node.id == place.node) node.place = place.at;
}

// Copies of brains with moved nodes; vehicles that share a brain share its copy.
class MovedBrains {
public:
    explicit MovedBrains(const std::vector<NodePlace>& places) : places_(places) {}

    void move(SharedBrain& brain) {
        SharedBrain& moved = made_[brain];
        if (!moved) {
            CompiledBrain copy = *brain;
            set_places(copy.graph, places_);
            moved = std::make_shared<const CompiledBrain>(std::move(copy));
        }
        brain = moved;
    }

private:
    const std::vector<NodePlace>& places_;
    std::map<SharedBrain, SharedBrain> made_;  // never iterated: the order of pointers differs from run to run
};

bool is_on_canvas(const NodePlace& place) {
    const auto within = [](float along) { return std::fabs(along) <= limits::place; };  // false for NaN
    return !place.at || (within(place.at->x) && within(place.at->y));
}

std::optional<Error> refusal(const State& m, const PlaceNodes& c) {
    if (!std::all_of(c.places.begin(), c.places.end(), is_on_canvas))
        return Error{fmt::format("the position of a node is within -{0} .. {0} canvas units", limits::place)};
    const auto& ids = m.vehicles.id;
    if (c.target.vehicle != no_vehicle && !std::binary_search(ids.begin(), ids.end(), c.target.vehicle))
        return error_of(message_of("vehicle_is_gone", c.target.vehicle));
    const bool has_kind = c.target.kind >= 0 && static_cast<std::size_t>(c.target.kind) < m.kind_brains.size();
    if (c.target.vehicle == no_vehicle && !has_kind)
        return Error{fmt::format("the scene has no kind number {}", c.target.kind)};
    return std::nullopt;
}

Command keeping_places(Command later, const PlaceNodes& edit) {
    if (auto* brain = std::get_if<SetBrain>(&later); brain && brain->target == edit.target)
        set_places(brain->brain, edit.places);
    if (auto* places = std::get_if<PlaceNodes>(&later); places && places->target == edit.target)
        std::erase_if(places->places, [&](const NodePlace& place) {
            return std::any_of(edit.places.begin(), edit.places.end(),
                               [&](const NodePlace& known) { return known.node == place.node; });
        });
    return later;
}

Command keeping_texts(Command later, const Retitle& edit) {
    if (auto* texts = std::get_if<Retitle>(&later)) {
        if (edit.title) texts->title.reset();
        if (edit.story) texts->story.reset();
    }
    return later;
}

}  // namespace

bool is_cosmetic(const Command& command) {
    return std::holds_alternative<PlaceNodes>(command) || std::holds_alternative<Retitle>(command);
}

std::vector<NodePlace> places_of(const BrainGraph& graph) {
    std::vector<NodePlace> places;
    for (const Node& node : graph.nodes) places.push_back({node.id, node.place});
    return places;
}

std::optional<Error> execute_cosmetic(State& s, const PlaceNodes& c) {
    if (auto error = refusal(s, c)) return error;
    MovedBrains moved(c.places);
    const bool one = c.target.vehicle != no_vehicle;
    for (std::size_t row = 0; row < s.vehicles.size(); ++row)
        if (one ? s.vehicles.id[row] == c.target.vehicle : s.vehicles.kind[row] == c.target.kind)
            moved.move(s.vehicles.brain[row]);
    if (!one) moved.move(s.kind_brains[static_cast<std::size_t>(c.target.kind)]);
    return std::nullopt;
}

std::optional<Error> execute_cosmetic(State& s, const Retitle& c) {
    auto scene = std::make_shared<Scene>(*s.scene);
    if (c.title) scene->title = *c.title;
    if (c.story) scene->story = *c.story;
    if (auto error = check_scene(*scene)) return error;
    s.scene = std::move(scene);
    return std::nullopt;
}

std::shared_ptr<const State> with_cosmetic(const std::shared_ptr<const State>& state, const Command& edit) {
    auto edited = std::make_shared<State>(*state);
    std::optional<Error> refused;  // the vehicle may be absent from a later state
    if (const auto* places = std::get_if<PlaceNodes>(&edit)) refused = execute_cosmetic(*edited, *places);
    if (const auto* texts = std::get_if<Retitle>(&edit)) refused = execute_cosmetic(*edited, *texts);
    if (refused) return state;
    return edited;
}

Command keeping_cosmetic(Command later, const Command& edit) {
    if (const auto* places = std::get_if<PlaceNodes>(&edit)) return keeping_places(std::move(later), *places);
    if (const auto* texts = std::get_if<Retitle>(&edit)) return keeping_texts(std::move(later), *texts);
    return later;
}

}  // namespace braitenlab::world
