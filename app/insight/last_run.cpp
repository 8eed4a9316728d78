#include "app/insight/last_run.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "app/course/reference_runs.h"
#include "app/lab.h"

namespace braitenlab {

namespace {

constexpr std::size_t most_vehicles = 16, most_poses = 36000;  // 7 MB
constexpr std::size_t least_poses = 30;

}  // namespace

void record_paths(Lab& lab) {
    const Session& session = lab.document.session;
    const Snapshot& now = session.snapshot();
    RunPaths& present = lab.last_run.present;
    const bool is_new = session.latest() == now.tick;  // else a recorded tick is repeated
    if (is_new && (present.run != lab.document.run_id || now.tick == 0)) present = {lab.document.run_id, {}};
    if (now.tick >= most_poses) return;
    for (std::size_t i = 0; i < std::min(most_vehicles, now.vehicles.size()); ++i) {
        const VehicleView& vehicle = now.vehicles[i];
        if (now.tick == 0) present.paths.try_emplace(vehicle.id);
        const auto found = present.paths.find(vehicle.id);
        if (found == present.paths.end()) continue;  // born later
        ReferencePath& path = found->second;
        if (is_new && path.size() > now.tick) path.resize(now.tick);
        if (path.size() == now.tick) path.push_back({vehicle.x, vehicle.y, vehicle.heading});
    }
}

void keep_run(Lab& lab, const std::map<VehicleId, VehicleId>& new_ids) {
    RunPaths ended = std::exchange(lab.last_run.present, {lab.document.run_id, {}});
    std::erase_if(ended.paths, [](const auto& path) { return path.second.size() < least_poses; });
    if (ended.run != lab.document.run_id || ended.paths.empty()) return;
    lab.last_run.last = {ended.run, {}};
    for (auto& [id, path] : ended.paths)
        if (const auto found = new_ids.find(id); found != new_ids.end())
            lab.last_run.last.paths[found->second] = std::move(path);
}

std::optional<GhostView> last_run_of(const Lab& lab) {
    const RunPaths& last = lab.last_run.last;
    if (!lab.view.overlays.last_run || lab.together || last.run != lab.document.run_id) return std::nullopt;
    const Snapshot& now = lab.document.session.snapshot();
    const VehicleView* vehicle = find_vehicle(now, lab.view.selection.vehicle);
    const auto found = last.paths.find(lab.view.selection.vehicle);
    if (!vehicle || found == last.paths.end()) return std::nullopt;
    return ghost_at(lab, found->second, kind_of(now, *vehicle).body);
}

}  // namespace braitenlab
