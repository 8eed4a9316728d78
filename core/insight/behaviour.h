// The kind of behaviour of one run, judged from the path of a vehicle, and numbers of the run.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/insight/predict.h"
#include "core/sensing/seam.h"
#include "core/world/snapshot.h"

namespace braitenlab::insight {

// In the order in which a path is tested, except that stands and flees have two conditions each: see behaviour_of().
// The object is the nearest source that the vehicle can sense; without one the nearest source; without sources the
// nearest other vehicle.
enum class Behaviour { touches, rests_near, circles, passes, approaches, flees, leaves, stands };
inline constexpr auto behaviour_table = std::to_array<Word<Behaviour>>({
    {Behaviour::touches, "touches"},
    {Behaviour::rests_near, "rests_near"},
    {Behaviour::circles, "circles"},
    {Behaviour::passes, "passes"},
    {Behaviour::approaches, "approaches"},
    {Behaviour::flees, "flees"},
    {Behaviour::leaves, "leaves"},
    {Behaviour::stands, "stands"},
});
static_assert(is_complete_table<behaviour_table>());
constexpr const auto& table_of(Behaviour) { return behaviour_table; }
inline constexpr std::size_t behaviour_count = behaviour_table.size();

// What one run shows. Distances are those of the vehicle's origin from the object.
struct Outcome {
    Behaviour behaviour = Behaviour::stands;
    float closest = 0, final_distance = 0;  // m; NAN in a scene without an object
    float time_to_touch = 0;                // s; INFINITY: never
    float captures = 0;                     // by all vehicles of the run
    float survival = 0;                     // s until the vehicle died or fell over an edge; else the whole run
};

// What a map shows: the kind of behaviour or a number.
enum class MapMeasure { behaviour, closest, final_distance, time_to_touch, captures, survival };
struct MapMeasureTraits {
    MapMeasure value;
    std::string_view word, unit;
    float Outcome::*number = nullptr;  // null: the kind
};
inline constexpr auto map_measure_table = std::to_array<MapMeasureTraits>({
    {MapMeasure::behaviour, "kind", ""},
    {MapMeasure::closest, "closest", "m", &Outcome::closest},
    {MapMeasure::final_distance, "final", "m", &Outcome::final_distance},
    {MapMeasure::time_to_touch, "touch", "s", &Outcome::time_to_touch},
    {MapMeasure::captures, "captures", "", &Outcome::captures},
    {MapMeasure::survival, "survival", "s", &Outcome::survival},
});
static_assert(is_complete_table<map_measure_table>());
constexpr const auto& table_of(MapMeasure) { return map_measure_table; }

// The number of a measure. Precondition: not MapMeasure::behaviour.
inline float number_of(const Outcome& outcome, MapMeasure measure) { return outcome.*row_of(measure).number; }

// Follows one vehicle from the first tick of a run.
class Judge {
public:
    // Precondition: the vehicle is in the snapshot.
    Judge(const Snapshot& start, VehicleId);

    // The next tick. `others`: positions of the vehicles in others(), in their order; of one that is gone NAN. False
    // once the vehicle fell over an edge: its run ends before this pose.
    bool add(const VehicleTrace&, const std::vector<maths::vec2>& others);
    // The vehicles that are the objects; empty where sources are.
    const std::vector<VehicleId>& others() const { return others_; }

    // is_gone: the vehicle has left the world before the end. The rules, in this order:
    //   leaves      it is gone, fell over an edge or is outside the arena
    //   touches     its chassis has been within 0.2 m of the object; of another vehicle within half its length + 0.05 m
    //   stands      it has never been 0.3 m from its start
    //   circles     it has gone once round the object
    //   rests_near, flees, stands: it does not move in the last two seconds and its wheels are told to stand, so it is
    //               not stuck; nearer to the object than at the start, farther by 0.5 m, neither
    //   flees       never nearer than half the distance at the start, and farther at the end by 0.5 m
    //   leaves      at the end the object is beyond the range of its sensors
    //   approaches  at the end nearer than at the start by 0.5 m, and within 0.5 m of the closest approach
    //   passes      any other path: it comes nearer and drives on
    Outcome outcome(const EventCounts&, bool is_gone) const;

private:
    struct Nearest {
        std::size_t index = 0;
        maths::vec2 offset;
        float distance = 0;
    };
    std::optional<Nearest> nearest(maths::vec2 at, const std::vector<maths::vec2>& objects) const;
    Behaviour behaviour_of(bool is_gone) const;
    bool rests() const;

    Arena arena_;
    sensing::Seam seam_;
    std::vector<maths::vec2> sources_;
    std::vector<VehicleId> others_;
    std::vector<float> half_lengths_;                     // m, of the others
    float half_length_ = 0, half_width_ = 0, reach_ = 0;  // m, chassis; longest range of its sensors
    std::int64_t captures_before_ = 0;

    std::vector<maths::vec2> places_;           // by tick
    float first_ = 0, closest_ = 0, last_ = 0;  // m, distances
    float touched_at_ = 0;                      // s
    float farthest_from_start_ = 0;             // m
    float told_ = 0, dead_band_ = 0;            // largest size of a wheel command at the last tick
    float turned_ = 0, most_turned_ = 0;        // rad round the nearest object
    std::size_t round_ = 0;                     // that object
    float bearing_ = 0;
    bool has_object_ = false, fell_ = false;
};

}  // namespace braitenlab::insight
