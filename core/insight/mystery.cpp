#include "core/insight/mystery.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/brain/four_neurons.h"
#include "core/maths/angle.h"
#include "core/maths/portable.h"
#include "core/maths/random.h"
#include "core/sensing/seam.h"

namespace braitenlab::insight {

namespace {

// Streams of random numbers that nothing else uses.
constexpr std::uint64_t start_stream = 0x6d797374, brain_stream = 0x6d797375;
constexpr std::size_t runs_beside_random = 3;  // from each start

Pose start_pose(const Snapshot& now, std::uint64_t seed, std::size_t start) {
    constexpr float share = 0.8f;  // of the arena
    maths::Random chance{seed * 1000 + start, start_stream};
    const Arena& arena = now.scene->arena;
    const float half_width = share * arena.width / 2, half_height = share * arena.height / 2;
    maths::vec2 at;
    do at = {chance.uniform(-half_width, half_width), chance.uniform(-half_height, half_height)};
    while (arena.round && std::hypot(at.x / half_width, at.y / half_height) > 1);
    float middle = 0, spread = maths::pi, nearest = INFINITY;
    for (const SourceView& source : now.sources) {
        const float distance = maths::distance(at, {source.x, source.y});
        if (distance >= nearest) continue;
        nearest = distance;
        middle = maths::arctangent2(source.y - at.y, source.x - at.x), spread = maths::pi / 2;
    }
    return {at.x, at.y, maths::wrap_angle(middle + chance.uniform(-spread, spread))};
}

}  // namespace

float path_gap(const Path& a, const Path& b, const Arena& arena) {
    if (a.empty() || b.empty()) return 0;
    const sensing::Seam seam(arena);
    const std::size_t count = std::max(a.size(), b.size());
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Pose &one = a[std::min(i, a.size() - 1)], &other = b[std::min(i, b.size() - 1)];
        sum += static_cast<double>(maths::length(seam.shortest({other.x - one.x, other.y - one.y})));
    }
    return static_cast<float>(sum / static_cast<double>(count));
}

BrainGraph random_brain(const std::vector<Sensor>& sensors, std::uint64_t seed, std::uint64_t number) {
    maths::Random chance{seed * 1000 + number, brain_stream};
    BrainGraph brain;
    NodeId next = 0;
    for (const Sensor& sensor : sensors)
        brain.nodes.push_back({.id = next++, .kind = NodeKind::sensor, .name = sensor.name});
    for (const char* motor : {"ML", "MR"}) {
        const NodeId id = next++;
        for (NodeId from = 0; from < static_cast<NodeId>(sensors.size()); ++from)
            brain.wires.push_back({.from = from,
                                   .to = id,
                                   .weight = chance.uniform(-braitenlab::limits::weight, braitenlab::limits::weight)});
        brain.nodes.push_back(
            {.id = id, .kind = NodeKind::motor, .name = motor, .bias = chance.uniform(0, braitenlab::limits::bias)});
    }
    return brain;
}

Result<std::shared_ptr<const MysteryBase>> MysteryBase::create(MysteryQuestion question) {
    auto base = std::make_shared<MysteryBase>();
    base->question_ = std::move(question);
    const MysteryQuestion& q = base->question_;
    for (std::size_t start = 0; start < q.starts; ++start) {
        auto world = World::create(q.scene, q.seed);
        if (!world) return world.error();
        for (const VehicleId removed : q.removed) (void)world->apply(RemoveVehicle{removed});
        const Snapshot now = snapshot_of(*world);
        const VehicleView* vehicle = find_vehicle(now, q.vehicle);
        if (!vehicle) return Error{"the scene has no vehicle with a hidden brain"};
        const Pose pose = world->nearest_free_pose(vehicle->kind, start_pose(now, q.seed, start));
        (void)world->apply(MoveVehicle{q.vehicle, pose.x, pose.y, pose.heading});
        (void)world->apply(ChooseDriver{q.vehicle, Driver::brain});
        base->starts_.push_back(world->checkpoint());
        if (start > 0) continue;
        for (const Design* design : {&q.hidden, &q.rebuilt})
            for (const Command& command : commands_for(*design, now, *vehicle, {q.vehicle, -1}))
                if (const auto error = world->apply(command)) return *error;
    }
    return std::shared_ptr<const MysteryBase>(std::move(base));
}

Question MysteryBase::run(std::size_t start, const Design& design) const {
    Question run{.from = starts_[start], .vehicle = question_.vehicle, .ticks = question_.ticks};
    const Snapshot now = snapshot_of(World::restore(run.from));
    run.changes = commands_for(design, now, *find_vehicle(now, question_.vehicle), {question_.vehicle, -1});
    return run;
}

MysteryRun::MysteryRun(std::shared_ptr<const MysteryBase> base, std::size_t start)
    : base_(std::move(base)), start_(start) {
    begin_run();
}

void MysteryRun::begin_run() {
    const MysteryQuestion& q = base_->question();
    if (number_ < 2) {
        run_.emplace(base_->run(start_, number_ == 0 ? q.hidden : q.rebuilt));
    } else {
        const BrainGraph brain =
            number_ == 2 ? BrainGraph{} : random_brain(q.hidden.sensors, q.seed, number_ - runs_beside_random);
        run_.emplace(base_->run(start_, Design{brain, q.hidden.sensors}));
    }
}

void MysteryRun::end_run(Path path) {
    const MysteryQuestion& q = base_->question();
    const Arena& arena = q.scene.arena;
    if (number_ == 0)
        result_.hidden = std::move(path);
    else if (number_ == 1)
        result_.gap = path_gap(result_.hidden, path, arena), result_.rebuilt = std::move(path);
    else if (number_ == 2)
        result_.still_gap = path_gap(result_.hidden, path, arena);
    else
        result_.random_gap += path_gap(result_.hidden, path, arena) / static_cast<float>(q.random_brains);
    run_.reset();
    if (++number_ < runs_beside_random + q.random_brains) begin_run();
}

bool MysteryRun::advance(std::size_t ticks) {
    if (run_ && run_->advance(ticks)) end_run(run_->path());
    return !run_;
}

float MysteryRun::progress() const {
    const auto runs = static_cast<float>(runs_beside_random + base_->question().random_brains);
    return run_ ? (static_cast<float>(number_) + run_->progress()) / runs : 1;
}

MysteryScore score_of(std::vector<MysteryStart> starts) {
    MysteryScore score{.starts = std::move(starts)};
    const auto count = static_cast<float>(std::max<std::size_t>(score.starts.size(), 1));
    for (const MysteryStart& start : score.starts)
        score.gap += start.gap / count, score.random_gap += start.random_gap / count,
            score.still_gap += start.still_gap / count;
    const float chance = std::min(score.random_gap, score.still_gap);
    if (score.gap <= 0)
        score.score = 100;
    else if (chance > 0)
        score.score = static_cast<int>(std::floor(100 * std::max(0.0f, 1 - score.gap / chance)));
    return score;
}

}  // namespace braitenlab::insight
