#include "app/features/mystery_runs.h"

#include <algorithm>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/jobs/in_pieces.h"
#include "app/lab_edits.h"
#include "app/lab_selection.h"
#include "app/workspace.h"
#include "ui/scene_input/edits.h"

namespace braitenlab {

namespace {

constexpr std::size_t mystery_ticks = 300;  // about half a millisecond with one vehicle

const VehicleView* first_hidden(const Workspace& space) {
    for (const VehicleView& each : shown_snapshot(space).vehicles)
        if (is_secret(space, each.kind)) return &each;
    return nullptr;
}

// The selected vehicle, or the first one with a brain that is shown.
const VehicleView* rebuilt_vehicle(const Workspace& space) {
    const Snapshot& now = shown_snapshot(space);
    const auto is_meant = [&](const VehicleView& v) { return v.driver == Driver::brain && !is_secret(space, v.kind); };
    const VehicleView* selected = find_vehicle(now, space.view.selection.vehicle);
    if (selected && is_meant(*selected)) return selected;
    for (const VehicleView& each : now.vehicles)
        if (is_meant(each)) return &each;
    return nullptr;
}

void set_hidden(Workspace& space, const VehicleView& vehicle, bool hidden) {
    const Snapshot& now = space.document.session.snapshot();
    const std::uint64_t gesture = new_gesture(space);
    const int index = vehicle.kind;
    // A brain of its own would be written to a file as it is.
    const BrainGraph brain = *brain_of(now, vehicle);
    if (hidden && !apply(space, SetBrain{{no_vehicle, index}, brain}, gesture)) return;
    Kind kind = now.scene->kinds[static_cast<std::size_t>(index)];
    kind.hidden = hidden;
    if (apply(space, EditKind{index, kind}, gesture))
        say(space, {NoticeKind::done, hidden ? "notice.brain_hidden" : "notice.brain_revealed"});
}

// The sensors and motors without a wire.
BrainGraph unwired(const std::vector<Sensor>& sensors) {
    BrainGraph brain;
    for (const Sensor& sensor : sensors)
        brain.nodes.push_back(
            {.id = static_cast<NodeId>(brain.nodes.size()), .kind = NodeKind::sensor, .name = sensor.name});
    for (const char* motor : {"ML", "MR"})
        brain.nodes.push_back({.id = static_cast<NodeId>(brain.nodes.size()), .kind = NodeKind::motor, .name = motor});
    return brain;
}

void add_rebuilt(Workspace& space, const VehicleView& hidden) {
    const Snapshot& now = space.document.session.snapshot();
    const std::uint64_t gesture = new_gesture(space);
    Kind kind = kind_of(now, hidden);
    const float aside = 1.5f * std::max(kind.body.length, kind.body.width);
    const Pose beside{hidden.x, hidden.y - aside, hidden.heading};
    kind.name = "rebuilt", kind.hidden = false, kind.share = 0, kind.colour.clear();
    kind.brain = unwired(kind.sensors);
    if (!apply(space, AddKind{kind}, gesture)) return;
    const int index = static_cast<int>(space.document.session.snapshot().scene->kinds.size()) - 1;
    const AddVehicle added{.kind = index, .at = beside};
    if (!apply(space, ui::with_room(space.document.session.snapshot(), added), gesture)) return;
    const Snapshot& after = space.document.session.snapshot();
    for (const VehicleView& each : after.vehicles)
        if (each.kind == index) select(space, vehicle_object(each.id));
    say(space, {NoticeKind::done, "notice.rebuilt"});
}

void ask_score(MysteryRuns& runs, const Workspace& space, const VehicleView& hidden, const VehicleView& rebuilt) {
    const Session& session = space.document.session;
    const Snapshot& now = session.snapshot();
    insight::MysteryQuestion question{.scene = session.edited_scene(),
                                      .seed = session.seed(),
                                      .hidden = insight::design_of(now, hidden),
                                      .rebuilt = insight::design_of(now, rebuilt)};
    question.vehicle = id_at_start(question.scene, question.seed, now, hidden);
    const VehicleId removed = id_at_start(question.scene, question.seed, now, rebuilt);
    if (removed != no_vehicle && removed != question.vehicle) question.removed = {removed};
    runs = {.run = space.document.run_id};
    runs.score.ask(std::move(question));
}

}  // namespace

void handle_mystery(MysteryRuns& runs, Workspace& space, const MysteryRequest& wanted) {
    const VehicleView* selected = selected_vehicle(space);
    const VehicleView* hidden = first_hidden(space);
    const VehicleView* rebuilt = rebuilt_vehicle(space);
    const bool in_exercise = space.document.lesson.has_value();
    switch (wanted.edit) {
        case MysteryEdit::hide:
            if (selected && !hidden && !in_exercise) set_hidden(space, *selected, true);
            return;
        case MysteryEdit::reveal:
            if (hidden && !in_exercise) set_hidden(space, *hidden, false);
            return;
        case MysteryEdit::rebuild:
            if (hidden && !in_exercise) add_rebuilt(space, *hidden);
            return;
        case MysteryEdit::score:
            if (hidden && rebuilt) ask_score(runs, space, *hidden, *rebuilt);
            return;
    }
}

void update_mystery(MysteryRuns& runs, const Workspace& space, Jobs& jobs) {
    if (runs.run != space.document.run_id) runs = {.run = space.document.run_id};
    runs.score.follow([&](const insight::MysteryQuestion& question) -> Result<Job<insight::MysteryScore>> {
        const auto base = insight::MysteryBase::create(question);
        if (!base) return base.error();
        return jobs.submit(
            question.starts,
            [base = *base](std::size_t start) {
                return InPieces(insight::MysteryRun(base, start), mystery_ticks, &insight::MysteryRun::result);
            },
            insight::score_of);
    });
}

bool is_computing(const MysteryRuns& runs) { return runs.score.is_computing(); }

MysteryView mystery_of(const MysteryRuns& runs, const Workspace& space) {
    MysteryView shown;
    if (const VehicleView* hidden = first_hidden(space)) shown.hidden = hidden->id;
    if (const VehicleView* rebuilt = rebuilt_vehicle(space)) shown.rebuilt = rebuilt->id;
    if (runs.run != space.document.run_id) return shown;
    shown.is_computing = is_computing(runs);
    shown.progress = runs.score.progress().fraction;
    if (runs.score.answer()) shown.score = runs.score.answer(), shown.scene = &runs.score.answered()->scene;
    shown.error = runs.score.error();
    return shown;
}

}  // namespace braitenlab
