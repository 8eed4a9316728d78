// Two brains from the same start: the run of each, and what differs in numbers. Results depend on the question only.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/insight/predict.h"
#include "core/insight/run_judge.h"
#include "core/world/world.h"

namespace braitenlab::insight {

// A brain with the sensors that it reads.
struct Design {
    BrainGraph brain;
    std::vector<Sensor> sensors;
};
// True if both drive alike: canvas positions do not count.
bool is_same(const Design&, const Design&);

// What the vehicle has now.
Design design_of(const Snapshot&, const VehicleView&);

// The commands that give the target this design, the sensors first; empty for what the vehicle has already.
std::vector<Command> commands_for(const Design&, const Snapshot&, const VehicleView&, Target);

enum class CompareMeasure { closest, touch, final_distance, driven, in_light };
struct CompareMeasureTraits {
    CompareMeasure value;
    std::string_view word, unit;
};
inline constexpr auto compare_measure_table = std::to_array<CompareMeasureTraits>({
    {CompareMeasure::closest, "closest", "m"},  // to the nearest object, as Outcome::closest
    {CompareMeasure::touch, "touch", "s"},      // until it touches an object; INFINITY: never
    {CompareMeasure::final_distance, "final", "m"},
    {CompareMeasure::driven, "driven", "m"},      // length of its path
    {CompareMeasure::in_light, "in_light", "s"},  // time with light_at() of at least in_light_from
});
static_assert(is_complete_table<compare_measure_table>());
constexpr const auto& table_of(CompareMeasure) { return compare_measure_table; }
inline constexpr std::size_t compare_measure_count = compare_measure_table.size();

// One number per CompareMeasure. NAN: the scene has nothing to measure (no object, no light).
using CompareNumbers = std::array<float, compare_measure_count>;

// The light at the vehicle's origin, 0..1: the reading of its kind's light sensor if it looked in all directions and no
// obstacle was in the way; without such a sensor, that of a standard one. NAN in a scene without light.
float light_at(const Snapshot&, const VehicleView&);
inline constexpr float in_light_from = 0.25f;  // of light_at(): about 4 m from a lamp of full strength

struct CompareQuestion {
    Checkpoint start;  // the first tick of the runs
    VehicleId vehicle = no_vehicle;
    Target target{};           // gets the design
    std::size_t ticks = 1200;  // of each run
};

struct ComparedRun {
    Path path;  // one pose per tick, the first at the start; ends early where the vehicle leaves the world
    CompareNumbers numbers{};
};

// The run with one design in pieces, for a time slice or a thread. Its path is bit for bit the one that the vehicle
// drives when it gets the design at the start and nothing else is changed.
class DesignRun {
public:
    DesignRun(const CompareQuestion&, const Design&);

    // Computes at most this many ticks. True once the run is complete.
    bool advance(std::size_t ticks);
    const ComparedRun& run() const { return run_; }  // numbers: valid once complete
    float progress() const;                          // 0..1

private:
    void add_tick();

    std::optional<World> world_;  // nullopt: complete
    std::optional<RunJudge> judge_;
    VehicleId vehicle_;
    std::size_t ticks_;
    std::size_t lit_ticks_ = 0;
    bool has_light_ = false;
    Snapshot now_;
    ComparedRun run_;
};

// The whole run.
ComparedRun run_design(const CompareQuestion&, const Design&);

// B less A of one measure; nullopt where one of them is no finite number.
std::optional<float> difference(const CompareNumbers& a, const CompareNumbers& b, CompareMeasure);

}  // namespace braitenlab::insight
