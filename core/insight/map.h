// Map of behaviour: two values of a scene on two axes, a run from the start for each pair of values, and what the runs
// show. Coarse to fine: see map_levels(). The result does not depend on the order or the number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/insight/behaviour.h"
#include "core/insight/judged_run.h"
#include "core/result.h"
#include "core/scene/toml_tree.h"
#include "core/world/world.h"

namespace braitenlab::insight {

namespace limits {
inline constexpr int map_size = 128;  // cells along an axis
inline constexpr int map_seeds = 64;
}  // namespace limits

// The values along one axis.
struct MapAxis {
    std::string path;           // as given
    std::vector<Dial> dials{};  // of the brain that MapQuestion::target names
    // Paths of a scene file (core/scene/scene_file.h), used without dials; with '-' first: gets the negative value.
    std::vector<std::string> values{};
    float from = -2, to = 2;
    friend bool operator==(const MapAxis&, const MapAxis&) = default;
};

// "LL=RR": dials joined by '=' as an exercise offers them; "kind.prey.body.mass": the path of a value as --set takes
// it; "kind.prey.brain.LL=RR": several keys of one table, which get the same value;
// "kind.prey.sensor.SL.angle=-kind.prey.sensor.SR.angle": a whole path after '=', the negative value by '-'. The range
// of dials is theirs, of paths 0..1. Fails for an empty part and for dials of different ranges.
Result<MapAxis> axis_of(std::string_view path);
// Axes of the brain that has dials, for a choice: sums of both sides, then single numbers.
inline constexpr std::array brain_axes{"LL=RR",        "LR=RL",        "LM=RM",       "LL", "LR",
                                       "RL",           "RR",           "LM",          "RM", "threshold_LL",
                                       "threshold_LR", "threshold_RL", "threshold_RR"};
bool have_common_value(const MapAxis&, const MapAxis&);

// "PATH=A:B", A ≠ B. `option` names the argument in messages. Whether the scene has the value is checked later.
Result<MapAxis> parse_axis(const std::string& argument, const std::string& option);

// The value of row or column `index` < size. The first is `from`, the last `to`.
float value_at(const MapAxis&, int index, int size);

struct MapQuestion {
    Scene scene;  // every run begins with its start
    std::uint64_t seed = 1;
    int seeds = 1;                   // 1 .. limits::map_seeds; a cell has runs with seed, seed + 1, …
    VehicleId vehicle = no_vehicle;  // in a world of the scene; it is judged
    Target target{};                 // whose brain the dials of an axis set
    SensorPair pair{};
    MapAxis x{.path = "LL=RR", .dials = {Dial::LL, Dial::RR}}, y{.path = "LR=RL", .dials = {Dial::LR, Dial::RL}};
    int size = 32;             // 2 .. limits::map_size
    std::size_t ticks = 1200;  // of a run
};

// A cell: column and row, from 0.
struct MapPlace {
    int x = 0, y = 0;
    friend bool operator==(const MapPlace&, const MapPlace&) = default;
};

// What is common to all runs of a map. Constant, so that threads share it.
class MapBase {
public:
    // Fails when the scene is invalid, has no such vehicle, has no value of an axis' path, or a value is out of range.
    static Result<std::shared_ptr<const MapBase>> create(MapQuestion);

    const MapQuestion& question() const { return question_; }

    // The world at the start of the run with seed number 0 ≤ `seed` < seeds.
    Result<World> world(MapPlace, int seed) const;

    // The commands that give a running world the values of the axes with dials. Empty if both axes are paths.
    std::vector<Command> commands(MapPlace) const;

private:
    MapQuestion question_;
    std::optional<TomlFile> file_;    // of the scene; nullopt: both axes have dials
    std::vector<Checkpoint> starts_;  // by seed, without the values of the axes; empty with a file
};

// One run of a map in pieces.
class MapRun : public JudgedRun {
public:
    MapRun(const std::shared_ptr<const MapBase>& base, MapPlace place, int seed)
        : JudgedRun(base->world(place, seed), base->question().vehicle, base->question().ticks) {}
};

// What all seeds of a cell show: the most frequent behaviour, the first in the order of Behaviour of several; the share
// 0..1 of runs with this behaviour; of each number the median, of an even number of runs the lower of the middle ones.
struct MapCell {
    Outcome outcome;
    float agree = 1;
};
MapCell cell_of(const std::vector<Outcome>&);

// One cell, all seeds.
MapCell run_cell(const std::shared_ptr<const MapBase>&, MapPlace);

// The cells of a map in the order in which they are computed: the middles of 4×4 blocks of the map, then of 8×8, … to
// the remaining cells. Every cell is in one level.
std::vector<std::vector<MapPlace>> map_levels(int size);

// A map that is being computed: rows of `size` cells, the row of y = from first.
struct MapCells {
    int size = 0;
    std::vector<std::optional<MapCell>> cells;

    explicit MapCells(int map_size = 0)
        : size(map_size), cells(static_cast<std::size_t>(map_size) * static_cast<std::size_t>(map_size)) {}
    std::optional<MapCell>& at(MapPlace place) {
        return cells[static_cast<std::size_t>(place.y) * static_cast<std::size_t>(size) +
                     static_cast<std::size_t>(place.x)];
    }
    const std::optional<MapCell>& at(MapPlace place) const { return const_cast<MapCells*>(this)->at(place); }

    // The cell, or the computed middle of the smallest block around it; null before the first level.
    const MapCell* shown(MapPlace) const;
};

}  // namespace braitenlab::insight
