#include "core/world/world.h"

#include <algorithm>

#include "core/scene/scene_file.h"
#include "core/world/state.h"

namespace braitenlab {

WorldState::WorldState(const Scene& given, std::uint64_t the_seed)
    : scene(std::make_shared<const Scene>(given)), seed(the_seed), outlines(outlines_of(given)), physics(given) {
    for (const Kind& kind : given.kinds) kinds.push_back(compile_kind(kind, given.arena));
    for (int c = 0; c < channel_count; ++c) {
        float farthest = 0;
        for (const CompiledKind& kind : kinds)
            for (const Eye& eye : kind.eyes)
                if (static_cast<int>(eye.channel) == c) farthest = std::max(farthest, eye.range);
        const auto channel = static_cast<std::size_t>(c);
        sensed_channel[channel] = farthest > 0;
        if (farthest > 0) fields[channel].lay_out(given.arena, farthest);
    }
    for (const Source& source : given.sources) sources.push_back({source.x, source.y});
}

std::optional<std::size_t> WorldState::row_of(VehicleId id) const {
    const auto found = std::lower_bound(vehicles.id.begin(), vehicles.id.end(), id);
    if (found == vehicles.id.end() || *found != id) return std::nullopt;
    return static_cast<std::size_t>(found - vehicles.id.begin());
}

World::World(std::unique_ptr<WorldState> state) : state_(std::move(state)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const Scene& scene, std::uint64_t seed) {
    if (auto error = check_scene(scene)) return *error;
    auto state = std::make_unique<WorldState>(scene, seed);
    for (std::size_t k = 0; k < state->kinds.size(); ++k) {
        auto design = make_design(scene.kinds[k].brain, state->kinds[k].sensor_names);
        if (!design) return design.error();
        state->kinds[k].design = *design;
    }
    populate(*state);
    return World(std::move(state));
}

namespace {

// Every vehicle's brain turns its readings into wheel commands; `neurons` holds all vehicles' units.
void think_with(WorldState& s, std::vector<float>& neurons) {
    Vehicles& v = s.vehicles;
    for (std::size_t row = 0; row < v.size(); ++row) {
        const auto kind = static_cast<std::size_t>(v.kind[row]);
        if (s.scene->kinds[kind].driver == Driver::parked) {
            v.motor[row] = {};
            continue;
        }
        const Brain& brain = v.design[row]->brain;
        think(brain, {v.sensed.data() + v.first_sensed[row], s.kinds[kind].eyes.size()},
              {neurons.data() + v.first_neuron[row], brain.units.size()}, v.motor[row]);
    }
}

// After a command and before the next tick, a picture shows what the eyes see now and what the brains make of it; the
// brains' own state waits for the tick.
void foresee(WorldState& s) {
    sense(s);
    s.foreseen_neurons = s.vehicles.neurons;
    think_with(s, s.foreseen_neurons);
}

}  // namespace

void think(WorldState& s) {
    think_with(s, s.vehicles.neurons);
    s.foreseen_neurons.clear();
}

void World::step() {
    WorldState& s = *state_;
    sense(s);
    think(s);
    drive(s);
    s.physics.step();
    for (std::size_t row = 0; row < s.vehicles.size(); ++row) read_motion(s, row);
    touch_and_live(s);
    ++s.tick;
}

std::uint64_t World::tick() const { return state_->tick; }

std::optional<Error> World::apply(const Command& command) {
    auto error = carry_out(*state_, command);
    if (!error) state_->eyes_are_stale = true;
    return error;
}

void World::capture(Snapshot& out) const {
    if (state_->eyes_are_stale) foresee(*state_);
    braitenlab::capture(*state_, out);
}

std::uint64_t World::hash() const { return braitenlab::hash(*state_); }

}  // namespace braitenlab
