#include "core/world/world.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/scene/scene_file.h"
#include "core/world/cosmetic_edits.h"
#include "core/world/tick.h"

namespace braitenlab {

using world::State;
using world::WorldData;

namespace {

// Rows ordered by strips of the floor. Box2D builds a balanced tree when neighbouring bodies are added one after the
// other. Added by id beside long walls, 20,000 vehicles make its first step take seconds.
std::vector<std::size_t> rows_by_position(const std::vector<mechanics::Motion>& motion) {
    constexpr float strip = 4;  // m
    std::vector<std::size_t> rows(motion.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    const auto key = [&](std::size_t row) {
        return std::tuple(std::floor(motion[row].position.y / strip), motion[row].position.x, row);
    };
    std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    return rows;
}

}  // namespace

WorldData::WorldData(State state)
    : State(std::move(state)), compiled_scene(scene), environment(*scene, obstacles), physics(*scene, obstacles) {
    for (const Kind& kind_of_scene : scene->kinds) {
        kinds.push_back(compile_kind(kind_of_scene));
        any_memory |= kind_of_scene.memory.marks > 0;
    }
    lay_out_grids();
    add_bodies();
}

void WorldData::rebuild() {
    readings_are_stale = true;
    if (compiled_scene != scene) {
        *this = WorldData(std::move(static_cast<State&>(*this)));
        return;
    }
    environment.outlines = sensing::Outlines(*scene, obstacles);
    lay_out_grids();
    bumps.clear(), begun.clear(), struck.clear();
    physics = Physics(*scene, obstacles);
    add_bodies();
}

void WorldData::add_bodies() {
    for (const std::size_t row : rows_by_position(vehicles.motion))
        physics.add(row, vehicles.id[row], scene->kinds[kind(row)].body, vehicles.motion[row]);
}

void WorldData::lay_out_grids() {
    std::array<float, channel_count> longest_range{};
    const auto add = [&](const CompiledKind& of) {
        for (const sensing::CompiledSensor& sensor : of.sensors) {
            float& longest = longest_range[static_cast<std::size_t>(sensor.channel)];
            longest = std::max(longest, sensor.range);
        }
    };
    for (const CompiledKind& of_kind : kinds) add(of_kind);
    for (const SharedDesign& own : vehicles.design)
        if (own) add(own->compiled);
    for (std::size_t channel = 0; channel < longest_range.size(); ++channel) {
        sensed_channel[channel] = longest_range[channel] > 0;
        if (sensed_channel[channel]) sensing_buffers.grids[channel].lay_out(scene->arena, longest_range[channel]);
    }
}

std::optional<std::size_t> WorldData::row_of(VehicleId id) const {
    // Ids ascend. Until a vehicle is removed, the row is the difference to the first id.
    if (vehicles.size() == 0 || id < vehicles.id.front()) return std::nullopt;
    const auto guess = static_cast<std::size_t>(id - vehicles.id.front());
    if (guess < vehicles.size() && vehicles.id[guess] == id) return guess;
    const auto found = std::lower_bound(vehicles.id.begin(), vehicles.id.end(), id);
    if (found == vehicles.id.end() || *found != id) return std::nullopt;
    return static_cast<std::size_t>(found - vehicles.id.begin());
}

World::World(std::unique_ptr<WorldData> data) : data_(std::move(data)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const Scene& scene, std::uint64_t seed) {
    if (auto error = check_scene(scene)) return *error;
    State begin;
    begin.scene = std::make_shared<const Scene>(scene);
    begin.seed = begin.parts_seed = seed;
    for (const Kind& kind : scene.kinds) {
        auto brain = world::compile_brain(kind.brain, kind);
        if (!brain) return brain.error();
        begin.kind_brains.push_back(*brain);
    }
    for (const Obstacle& o : scene.obstacles) begin.obstacles.push_back(mechanics::at_rest({o.x, o.y}, o.heading));
    auto data = std::make_unique<WorldData>(std::move(begin));
    spawn_population(*data);
    World made(std::move(data));
    made.begin_keyframe();
    return made;
}

void World::begin_keyframe() { since_ = {world::begin_keyframe(*data_), data_->tick, {}, data_->tick}; }

Checkpoint World::checkpoint() const {
    Checkpoint now = since_;
    now.tick = data_->tick;
    return now;
}

World World::restore(const Checkpoint& checkpoint) {
    World restored(std::make_unique<WorldData>(State(*checkpoint.keyframe)));
    restored.since_ = {checkpoint.keyframe, checkpoint.keyframe_tick, {}, checkpoint.keyframe_tick};
    auto next = checkpoint.commands.begin();
    const auto apply_due = [&] {
        for (; next != checkpoint.commands.end() && next->tick <= restored.tick(); ++next)
            (void)restored.apply(next->command);
    };
    for (apply_due(); restored.tick() < checkpoint.tick; apply_due()) restored.step();
    return restored;
}

void World::step() {
    world::tick(*data_, [](world::TickPart) {});
    if (data_->tick % keyframe_ticks == 0) begin_keyframe();
}

std::uint64_t World::tick() const { return data_->tick; }

const EventCounts& World::events() const { return data_->events; }

std::optional<Error> World::apply(const Command& command) {
    if (auto error = execute(*data_, command)) return error;
    data_->readings_are_stale = true;
    since_.commands.push_back({data_->tick, command});
    // A keyframe rebuilds the world, which changes later bits; a cosmetic command must not.
    if (world::is_cosmetic(command)) return std::nullopt;
    const auto effective = std::count_if(since_.commands.begin(), since_.commands.end(),
                                         [](const LoggedCommand& c) { return !world::is_cosmetic(c.command); });
    if (static_cast<std::size_t>(effective) >= keyframe_commands) begin_keyframe();
    return std::nullopt;
}

void World::capture(Snapshot& out) const { world::capture(*data_, out); }

bool World::trace(VehicleId id, VehicleTrace& out) const { return world::trace(*data_, id, out); }

Pose World::nearest_free_pose(int kind, const Pose& pose) const { return world::nearest_free_pose(*data_, kind, pose); }

World World::fork() const { return fork(data_->seed); }

World World::fork(std::uint64_t seed) const {
    State now(*data_);
    now.seed = seed;
    auto start = std::make_shared<const State>(now);
    World copy(std::make_unique<WorldData>(std::move(now)));
    copy.data_->readings_are_stale = data_->readings_are_stale;
    copy.since_ = {std::move(start), tick(), {}, tick()};
    return copy;
}

std::uint64_t World::hash() const { return world::hash(*data_); }

}  // namespace braitenlab
