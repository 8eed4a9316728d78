#include "core/world/world.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/scene/scene_file.h"
#include "core/world/node_places.h"
#include "core/world/tick.h"

namespace braitenlab {

namespace {

// Rows, strip by strip of the floor. Box2D's tree of boxes is good when neighbours enter one after the other; entered
// as they come, beside long walls, 20,000 vehicles would cost its first step seconds.
std::vector<std::size_t> by_place(const std::vector<Motion>& motion) {
    constexpr float strip = 4;  // m
    std::vector<std::size_t> rows(motion.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    const auto key = [&](std::size_t row) {
        return std::tuple(std::floor(motion[row].place.y / strip), motion[row].place.x, row);
    };
    std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    return rows;
}

}  // namespace

WorldState::WorldState(Moment moment)
    : Moment(std::move(moment)),
      ground(*scene),
      outlines(*scene, obstacles),
      seam(scene->arena),
      physics(*scene, obstacles) {
    for (const Kind& design : scene->kinds) {
        kinds.push_back(compile_kind(design));
        anyone_remembers |= design.memory.marks > 0;
    }
    for (int c = 0; c < channel_count; ++c) {
        float farthest = 0;
        for (const CompiledKind& compiled : kinds)
            for (const Eye& eye : compiled.eyes)
                if (static_cast<int>(eye.channel) == c) farthest = std::max(farthest, eye.range);
        const auto channel = static_cast<std::size_t>(c);
        sensed_channel[channel] = farthest > 0;
        if (farthest > 0) fields[channel].lay_out(scene->arena, farthest);
    }
    for (const std::size_t row : by_place(vehicles.motion))
        physics.add(row, vehicles.id[row], scene->kinds[kind(row)].body, vehicles.motion[row]);
}

std::optional<std::size_t> WorldState::row_of(VehicleId id) const {
    // Ids ascend. Where nobody has left yet, an id tells its row.
    if (vehicles.size() == 0 || id < vehicles.id.front()) return std::nullopt;
    const auto guess = static_cast<std::size_t>(id - vehicles.id.front());
    if (guess < vehicles.size() && vehicles.id[guess] == id) return guess;
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
    Moment begin;
    begin.scene = std::make_shared<const Scene>(scene);
    begin.seed = seed;
    for (const Kind& kind : scene.kinds) {
        auto design = make_design(kind.brain, kind);
        if (!design) return design.error();
        begin.newcomers.push_back(*design);
    }
    for (const Obstacle& o : scene.obstacles) begin.obstacles.push_back(at_rest({o.x, o.y, o.heading}));
    auto state = std::make_unique<WorldState>(std::move(begin));
    populate(*state);
    World world(std::move(state));
    world.begin_keyframe();
    return world;
}

void World::begin_keyframe() { since_ = {braitenlab::begin_keyframe(*state_), state_->tick, {}, state_->tick}; }

Save World::save() const {
    Save save = since_;
    save.tick = state_->tick;
    return save;
}

World World::restore(const Save& save) {
    World world(std::make_unique<WorldState>(Moment(*save.keyframe)));
    world.since_ = {save.keyframe, save.keyframe_tick, {}, save.keyframe_tick};
    auto next = save.commands.begin();
    const auto carry_out_due = [&] {
        for (; next != save.commands.end() && next->tick <= world.tick(); ++next) (void)world.apply(next->command);
    };
    for (carry_out_due(); world.tick() < save.tick; carry_out_due()) world.step();
    return world;
}

void World::step() {
    braitenlab::tick(*state_, [](TickPart) {});
    if (state_->tick % keyframe_ticks == 0) begin_keyframe();
}

std::uint64_t World::tick() const { return state_->tick; }

std::optional<Error> World::apply(const Command& command) {
    if (auto error = carry_out(*state_, command)) return error;
    state_->eyes_are_stale = true;
    since_.commands.push_back({state_->tick, command});
    // A keyframe makes the world anew, which decides later bits; where nodes stand must not.
    if (changes_looks_alone(command)) return std::nullopt;
    const auto happened = std::count_if(since_.commands.begin(), since_.commands.end(),
                                        [](const LoggedCommand& c) { return !changes_looks_alone(c.command); });
    if (static_cast<std::size_t>(happened) >= keyframe_commands) begin_keyframe();
    return std::nullopt;
}

void World::capture(Snapshot& out) const {
    if (state_->eyes_are_stale) foresee(*state_);
    braitenlab::capture(*state_, out);
}

std::uint64_t World::hash() const { return braitenlab::hash(*state_); }

}  // namespace braitenlab
