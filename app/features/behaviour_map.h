// The map of behaviour of the selected vehicle, computed in the background while it is shown, coarse to fine.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/jobs/asked.h"
#include "core/insight/axis_value.h"

namespace braitenlab {

struct Workspace;
struct MapRequest;
struct MapView;

// What the cells depend on. The values of the axes are 0 in the scene: dragging the dot keeps the map.
struct MapSubject {
    Scene scene;
    std::uint64_t seed = 0, run = 0;  // Document::run_id
    VehicleId vehicle = no_vehicle;   // in the world at the start
    Target target{};
    SensorPair pair{};
    insight::MapAxis x{}, y{};
    int seeds = 1;
    friend bool operator==(const MapSubject&, const MapSubject&) = default;
};

// What an axis shows.
struct MapChoice {
    std::string id;  // insight::AxisValue::id
    float from = 0, to = 1;
    friend bool operator==(const MapChoice&, const MapChoice&) = default;
};

// What may change the subject: it is compared after a change of one of these only.
struct MapKey {
    std::int64_t edits = 0;           // Document::edits
    std::uint64_t run = 0, seed = 0;  // Document::run_id
    VehicleId vehicle = no_vehicle;
    bool whole_kind = false;
    std::string pair{};
    MapChoice x{}, y{};
    int seeds = 0;
    friend bool operator==(const MapKey&, const MapKey&) = default;
};

// The cells that jobs have computed since the last call of take(). Used by several threads.
class NewCells {
public:
    void add(insight::MapPlace, insight::MapCell);
    std::vector<std::pair<insight::MapPlace, insight::MapCell>> take();

private:
    std::mutex mutex_;
    std::vector<std::pair<insight::MapPlace, insight::MapCell>> cells_;
};

struct BehaviourMap {
    MapChoice x{"LL=RR", -2, 2}, y{"LR=RL", -2, 2};
    insight::MapMeasure measure = insight::MapMeasure::behaviour;
    int seeds = 1;
    std::optional<insight::MapPlace> hovered{};  // set once per frame; nullopt: none

    std::optional<MapSubject> subject{};             // of the cells
    std::optional<MapKey> compared{};                // when the subject was compared
    std::uint64_t run = 0;                           // Document::run_id of the ranges
    std::shared_ptr<const insight::MapBase> base{};  // null: there is no map
    insight::MapCells cells{};
    std::vector<insight::MapPlace> order{};  // of computation
    std::size_t begun = 0;                   // of `order`
    std::size_t known = 0;                   // of the cells
    std::shared_ptr<NewCells> new_cells{};   // of the jobs; null with `base`
    std::deque<Job<bool>> jobs{};            // true once their cells are among the new ones

    Asked<insight::MapPlace, insight::Path> path{};  // of the hovered cell
};

// The string key of the reason why the map may not show what other brains of the selected vehicle would do; empty if it
// may: see why_no_map() in ui/lab_view.h.
std::string_view why_no_map(const Workspace&);

// Call once per turn, after Jobs::deliver. A change of the scene or the choice begins the map anew.
void update_map(BehaviourMap&, const Workspace&, Jobs&);

// Changes what the map shows. A value that the other axis has goes to this one, which then gives its own in exchange.
void choose_map(BehaviourMap&, const Workspace&, const MapRequest&);

bool is_computing(const BehaviourMap&);

// nullopt: not shown, or it may not be shown now. Points into the map.
std::optional<MapView> map_of(const BehaviourMap&, const Workspace&);

}  // namespace braitenlab
