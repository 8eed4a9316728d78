#include "app/ctl/brain_of_file.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include "app/files/data.h"
#include "core/io/run_file.h"
#include "core/lesson/hand_in.h"
#include "core/scene/file_kind.h"
#include "core/scene/nearest.h"
#include "core/scene/scene_file.h"
#include "core/text_parts.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

// The index of the element with this name, or an Error that says so.
template <class Named>
Result<std::size_t> index_of(const std::vector<Named>& all, const std::string& name, const std::string& what,
                             const std::string& file) {
    const std::vector<std::string_view> names = known_names(all);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    return Error{"there is no " + what + " " + in_quotes(name) + name_nearest(name, names), file};
}

// The kind that is chosen, or the one taken without a choice.
Result<std::size_t> kind_index(const Scene& scene, const std::string& chosen, const std::string& file) {
    if (!chosen.empty()) return index_of(scene.kinds, chosen, "kind", file);
    if (scene.kinds.empty()) return Error{"there is no kind, so there is no brain; add a [kind.NAME]", file};
    return scene.starts.empty() ? std::size_t{0} : index_of(scene.kinds, scene.starts.front().kind, "kind", file);
}

std::optional<Error> hidden_fault(const Kind& kind, const std::string& file) {
    if (!kind.hidden) return std::nullopt;
    return Error{"the brain of the kind " + in_quotes(kind.name) + " is hidden", file};
}

BrainOfFile of_kind(const Kind& kind, const BrainGraph& brain, const std::string& owner) {
    return {brain, owner, kind.sensors, kind.body.length, kind.body.width};
}

Result<BrainOfFile> brain_of_scene(const Scene& scene, const BrainChoice& choice, const std::string& file) {
    if (!choice.vehicle.empty()) {
        const auto start = index_of(scene.starts, choice.vehicle, "vehicle", file);
        if (!start) return start.error();
        const auto kind = index_of(scene.kinds, scene.starts[*start].kind, "kind", file);
        if (!kind) return kind.error();
        if (auto fault = hidden_fault(scene.kinds[*kind], file)) return *fault;
        return BrainOfFile{scene.starts[*start].brain.value_or(scene.kinds[*kind].brain), "vehicle " + choice.vehicle,
                           scene.starts[*start].sensors.value_or(scene.kinds[*kind].sensors),
                           scene.kinds[*kind].body.length, scene.kinds[*kind].body.width};
    }
    const auto kind = kind_index(scene, choice.kind, file);
    if (!kind) return kind.error();
    if (auto fault = hidden_fault(scene.kinds[*kind], file)) return *fault;
    return of_kind(scene.kinds[*kind], scene.kinds[*kind].brain, "kind " + scene.kinds[*kind].name);
}

// The vehicle with this start; null when it is gone.
const VehicleView* vehicle_of_start(const Snapshot& now, std::size_t start) {
    const auto found = std::find_if(now.vehicles.begin(), now.vehicles.end(),
                                    [&](const VehicleView& v) { return v.start == static_cast<int>(start); });
    return found == now.vehicles.end() ? nullptr : &*found;
}

Result<BrainOfFile> brain_of_vehicle(const Snapshot& now, const std::string& name, const std::string& file) {
    const VehicleView* vehicle = nullptr;
    if (const auto start = index_of(now.scene->starts, name, "vehicle", file)) {
        vehicle = vehicle_of_start(now, *start);
        if (!vehicle) return Error{"the vehicle " + in_quotes(name) + " is gone; choose another, or a kind", file};
    } else {
        if (const auto id = whole_number<VehicleId>(name)) vehicle = find_vehicle(now, *id);
        if (!vehicle) return start.error();
    }
    if (auto fault = hidden_fault(kind_of(now, *vehicle), file)) return *fault;
    return of_kind(kind_of(now, *vehicle), *brain_of(now, *vehicle), "vehicle " + name);
}

Result<BrainOfFile> brain_of_run(const Snapshot& now, const BrainChoice& choice, const std::string& file) {
    if (!choice.vehicle.empty()) return brain_of_vehicle(now, choice.vehicle, file);
    const auto& starts = now.scene->starts;
    if (choice.kind.empty() && !starts.empty())
        if (const VehicleView* first = vehicle_of_start(now, 0); first && !kind_of(now, *first).hidden)
            return of_kind(kind_of(now, *first), *brain_of(now, *first), "vehicle " + starts.front().name);
    const auto kind = kind_index(*now.scene, choice.kind, file);
    if (!kind) return kind.error();
    if (auto fault = hidden_fault(now.scene->kinds[*kind], file)) return *fault;
    return of_kind(now.scene->kinds[*kind], *now.kind_brains[*kind], "kind " + now.scene->kinds[*kind].name);
}

Result<BrainOfFile> in_arena(Result<BrainOfFile> found, const Arena& arena) {
    if (found) found->ambient = arena.ambient, found->lux = arena.lux;
    return found;
}

Result<BrainOfFile> load_run_brain(const std::filesystem::path& path, const BrainChoice& choice) {
    const auto saved = io::load_run(path);
    if (!saved) return saved.error();
    const Snapshot now = snapshot_of(World::restore(saved->checkpoint));
    return in_arena(brain_of_run(now, choice, path.string()), now.scene->arena);
}

}  // namespace

Result<BrainOfFile> brain_of_text(const std::string& text, const std::string& file, const BrainChoice& choice) {
    if (holds_hand_in(file, text)) {
        auto hand_in = parse_hand_in(text, file);
        if (!hand_in) return hand_in.error();
        return BrainOfFile{std::move(hand_in->submission.brain), "hand-in of " + hand_in->student,
                           std::move(hand_in->submission.sensors)};
    }
    const FileKind kind = detect_kind(file, text);
    if (kind == FileKind::exercise)
        return Error{"this is an exercise; give a brain, a scene, a saved run or a hand-in", file};
    if (kind == FileKind::brain) {
        auto brain = parse_brain(text, file);
        if (!brain) return brain.error();
        return BrainOfFile{std::move(*brain), "", {}};
    }
    const auto scene = parse_scene(text, file);
    if (!scene) return scene.error();
    return in_arena(brain_of_scene(*scene, choice, file), scene->arena);
}

Result<BrainOfFile> brain_of_file(const std::string& file, const BrainChoice& choice) {
    const auto path = find_shipped(file);
    if (!path) return path.error();
    if (detect_kind(*path, "") == FileKind::run) return load_run_brain(*path, choice);
    const auto text = read_text(*path);
    if (!text) return text.error();
    return brain_of_text(*text, path->string(), choice);
}

Submission submission_with(const Exercise& exercise, BrainOfFile found) {
    Submission submission = with_brain(exercise, std::move(found.brain));
    if (!found.sensors.empty() && offers(exercise, offer_parts::sensors)) submission.sensors = std::move(found.sensors);
    return submission;
}

}  // namespace braitenlab
