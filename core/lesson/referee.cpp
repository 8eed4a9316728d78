#include "core/lesson/referee.h"

#include <algorithm>

namespace braitenlab {

namespace {

// Equal but for the brain, which a snapshot's scene does not keep up to date.
bool same_but_for_brain(Kind a, const Kind& b) {
    a.brain = b.brain;
    return a == b;
}

bool same_but_for_submission(Kind a, const Kind& b) {
    a.sensors = b.sensors;
    a.body = b.body;
    return same_but_for_brain(std::move(a), b);
}

}  // namespace

bool is_as_given(const Exercise& exercise, const Scene& now) {
    const Scene& given = exercise.scene;
    if (now.kinds.size() != given.kinds.size()) return false;
    for (std::size_t k = 0; k < given.kinds.size(); ++k) {
        const bool is_subject = !given.starts.empty() && static_cast<int>(k) == subject_kind(given);
        if (!(is_subject ? same_but_for_submission : same_but_for_brain)(now.kinds[k], given.kinds[k])) return false;
    }
    const bool has_no_other_source = std::all_of(now.sources.begin(), now.sources.end(), [&](const Source& source) {
        return std::find(given.sources.begin(), given.sources.end(), source) != given.sources.end();
    });
    return has_no_other_source && now.arena == given.arena && now.ecology == given.ecology &&
           now.starts == given.starts && now.obstacles == given.obstacles && now.zones == given.zones;
}

Referee::Referee(const Exercise& exercise) : exercise_(std::make_shared<const Exercise>(exercise)) {
    for (const Step& step : exercise.steps) state_.steps.push_back({initial_state(step.check)});
}

void Referee::begin(const Snapshot& now) {
    const std::vector<Start>& starts = exercise_->scene.starts;
    state_ = {};
    state_.begun = true;
    for (const Step& step : exercise_->steps) state_.steps.push_back({initial_state(step.check)});
    state_.subjects.assign(std::max<std::size_t>(1, starts.size()), no_vehicle);
    for (const VehicleView& vehicle : now.vehicles)
        if (vehicle.start >= 0 && static_cast<std::size_t>(vehicle.start) < starts.size())
            state_.subjects[static_cast<std::size_t>(vehicle.start)] = vehicle.id;
    if (starts.empty() && !now.vehicles.empty()) state_.subjects.front() = now.vehicles.front().id;
}

void Referee::watch(const Snapshot& now) {
    const bool is_new_run = !state_.begun || now.tick == 0 || now.tick < state_.tick;
    if (!is_new_run && now.tick == state_.tick) return;
    if (is_new_run) begin(now);
    state_.tick = now.tick;
    const Subjects subjects{exercise_->scene.starts, state_.subjects};
    if (!find_vehicle(now, subjects.id({}))) return;
    state_.by_hand = state_.disturbed || !is_undisturbed(now);
    if (state_.by_hand) return;
    for (std::size_t i = 0; i < state_.steps.size(); ++i) {
        RefereeState::Judged& step = state_.steps[i];
        if (!step.done) step.done = update(exercise_->steps[i].check, step.check, now, subjects);
    }
}

// The scene, the brains of other kinds, and who drives.
bool Referee::is_undisturbed(const Snapshot& now) {
    const Scene& given = exercise_->scene;
    if (compared_ != now.scene) {
        compared_ = now.scene;
        as_given_ = is_as_given(*exercise_, *now.scene);
    }
    if (!as_given_) return false;
    const int subject = given.starts.empty() ? -1 : subject_kind(given);
    for (std::size_t k = 0; k < std::min(given.kinds.size(), now.kind_brains.size()); ++k)
        if (static_cast<int>(k) != subject && *now.kind_brains[k] != given.kinds[k].brain) return false;
    for (std::size_t i = 0; i < std::min(given.starts.size(), state_.subjects.size()); ++i) {
        const VehicleView* vehicle = find_vehicle(now, state_.subjects[i]);
        const int kind = find_kind(given, given.starts[i].kind);
        if (vehicle && kind >= 0 && vehicle->driver != given.kinds[static_cast<std::size_t>(kind)].driver) return false;
    }
    return true;
}

std::vector<Verdict> Referee::verdicts() const {
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < state_.steps.size(); ++i)
        verdicts.push_back({state_.steps[i].done, measures(exercise_->steps[i].check, state_.steps[i].check)});
    return verdicts;
}

bool Referee::passed() const {
    return std::all_of(state_.steps.begin(), state_.steps.end(), [](const auto& step) { return step.done; });
}

}  // namespace braitenlab
