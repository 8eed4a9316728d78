// Place memory: a vehicle stores a mark where it touches a wall, post or obstacle, and senses its own marks like lamps.
#include <algorithm>

#include "core/maths/portable.h"
#include "core/world/world_data.h"

namespace braitenlab::world {

namespace {

constexpr float halvings = 7;                // of its strength; then a mark is removed
constexpr std::uint64_t ticks_a_sweep = 60;  // between two removals of old marks

using MarkAt = std::vector<Mark>::iterator;

// Makes a mark the newest of its vehicle; `end` is the end of the vehicle's marks. The others keep their order.
void renew(MarkAt mark, MarkAt end, std::uint64_t tick) {
    mark->tick = tick;
    std::rotate(mark, mark + 1, end);
}

void forget(WorldData& s) {
    if (s.tick % ticks_a_sweep != 0) return;
    std::erase_if(s.marks, [&](const Mark& mark) {
        const std::size_t row = *s.row_of(mark.owner);
        const float fade = s.scene->kinds[s.kind(row)].memory.fade;
        return static_cast<float>(s.tick - mark.tick) * tick_seconds > halvings * fade;
    });
}

}  // namespace

void remember(WorldData& s) {
    if (!s.any_memory) return;
    forget(s);
    s.physics.find_bumps(s.bumps);
    const std::size_t before = s.marks.size();
    const float apart = mark_spacing(s.scene->arena);
    for (const Bump& bump : s.bumps) {
        const auto row = s.row_of(bump.vehicle);
        if (!row) continue;
        const auto most = s.scene->kinds[s.kind(*row)].memory.marks;
        if (most == 0) continue;
        const auto old = s.marks.begin() + static_cast<std::ptrdiff_t>(before);
        const auto by_owner = [](const Mark& mark, VehicleId id) { return mark.owner < id; };
        const auto first = std::lower_bound(s.marks.begin(), old, bump.vehicle, by_owner);
        const auto last = std::lower_bound(first, old, bump.vehicle + 1, by_owner);
        const auto near = std::find_if(
            first, last, [&](const Mark& mark) { return maths::distance(mark.position, bump.at) < apart; });
        if (near != last) {
            renew(near, last, s.tick);
        } else if (last - first >= most) {  // replaces the oldest mark
            first->position = bump.at;
            renew(first, last, s.tick);
        } else {
            s.marks.push_back({bump.vehicle, bump.at, s.tick});
        }
    }
    // New marks are at the end, by owner. The merge puts each after the older marks of its owner.
    std::inplace_merge(s.marks.begin(), s.marks.begin() + static_cast<std::ptrdiff_t>(before), s.marks.end(),
                       [](const Mark& a, const Mark& b) { return a.owner < b.owner; });
}

float strength(const State& s, const Mark& mark) {
    const auto row = std::lower_bound(s.vehicles.id.begin(), s.vehicles.id.end(), mark.owner) - s.vehicles.id.begin();
    const auto kind = static_cast<std::size_t>(s.vehicles.kind[static_cast<std::size_t>(row)]);
    const PlaceMemory& memory = s.scene->kinds[kind].memory;
    constexpr float ln2 = 0.69314718f;
    const float age = static_cast<float>(s.tick - mark.tick) * tick_seconds;
    return memory.strength * maths::exponential(-ln2 * age / memory.fade);
}

float read_memory(const WorldData& s, const sensing::CompiledSensor& sensor, const sensing::SensorPose& pose,
                  std::size_t row) {
    const auto before = [](const Mark& a, const Mark& b) { return a.owner < b.owner; };
    const auto [first, end] = std::equal_range(s.marks.begin(), s.marks.end(), Mark{s.vehicles.id[row], {}, 0}, before);
    float sum = 0;
    for (auto mark = first; mark != end; ++mark)
        sum += response_to(sensor, pose, pose.position + s.environment.seam.shortest(mark->position - pose.position),
                           strength(s, *mark));
    return total_reading(sensor, sum, 0);
}

}  // namespace braitenlab::world
