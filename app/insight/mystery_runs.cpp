#include "app/insight/mystery_runs.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/lab.h"
#include "app/lab_edits.h"
#include "app/lab_selection.h"
#include "ui/scene_input/edits.h"

namespace braitenlab {

namespace {

constexpr std::size_t mystery_ticks = 300;  // about half a millisecond with one vehicle

// The runs from one start as a part of a job.
class MysteryPiece {
public:
    MysteryPiece(const std::shared_ptr<const insight::MysteryBase>& base, std::size_t start) : run_(base, start) {}
    std::optional<insight::MysteryStart> operator()() {
        if (!run_.advance(mystery_ticks)) return std::nullopt;
        return run_.result();
    }
    float progress() const { return run_.progress(); }

private:
    insight::MysteryRun run_;
};

const VehicleView* first_hidden(const Lab& lab) {
    for (const VehicleView& each : shown_snapshot(lab).vehicles)
        if (is_secret(lab, each.kind)) return &each;
    return nullptr;
}

// The selected vehicle, or the first one with a brain that is shown.
const VehicleView* rebuilt_vehicle(const Lab& lab) {
    const Snapshot& now = shown_snapshot(lab);
    const auto is_meant = [&](const VehicleView& v) { return v.driver == Driver::brain && !is_secret(lab, v.kind); };
    const VehicleView* selected = find_vehicle(now, lab.view.selection.vehicle);
    if (selected && is_meant(*selected)) return selected;
    for (const VehicleView& each : now.vehicles)
        if (is_meant(each)) return &each;
    return nullptr;
}

void set_hidden(Lab& lab, const VehicleView& vehicle, bool hidden) {
    const Snapshot& now = lab.document.session.snapshot();
    const std::uint64_t gesture = gestures::lab + ++lab.gesture;
    const int index = vehicle.kind;
    // A brain of its own would be written to a file as it is.
    const BrainGraph brain = *brain_of(now, vehicle);
    if (hidden && !apply(lab, SetBrain{{no_vehicle, index}, brain}, gesture)) return;
    Kind kind = now.scene->kinds[static_cast<std::size_t>(index)];
    kind.hidden = hidden;
    if (apply(lab, EditKind{index, kind}, gesture))
        say(lab, {NoticeKind::done, hidden ? "notice.brain_hidden" : "notice.brain_revealed"});
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

void add_rebuilt(Lab& lab, const VehicleView& hidden) {
    const Snapshot& now = lab.document.session.snapshot();
    const std::uint64_t gesture = gestures::lab + ++lab.gesture;
    Kind kind = kind_of(now, hidden);
    const float aside = 1.5f * std::max(kind.body.length, kind.body.width);
    const Pose beside{hidden.x, hidden.y - aside, hidden.heading};
    kind.name = "rebuilt", kind.hidden = false, kind.share = 0, kind.colour.clear();
    kind.brain = unwired(kind.sensors);
    if (!apply(lab, AddKind{kind}, gesture)) return;
    const int index = static_cast<int>(lab.document.session.snapshot().scene->kinds.size()) - 1;
    const AddVehicle added{.kind = index, .at = beside};
    if (!apply(lab, ui::with_room(lab.document.session.snapshot(), added), gesture)) return;
    const Snapshot& after = lab.document.session.snapshot();
    for (const VehicleView& each : after.vehicles)
        if (each.kind == index) select(lab, vehicle_object(each.id));
    say(lab, {NoticeKind::done, "notice.rebuilt"});
}

void ask_score(Lab& lab, const VehicleView& hidden, const VehicleView& rebuilt) {
    const Session& session = lab.document.session;
    const Snapshot& now = session.snapshot();
    MysteryRuns& runs = lab.mystery;
    runs = {.run = lab.document.run_id, .begins = true};
    insight::MysteryQuestion question{.scene = session.edited_scene(),
                                      .seed = session.seed(),
                                      .hidden = insight::design_of(now, hidden),
                                      .rebuilt = insight::design_of(now, rebuilt)};
    question.vehicle = id_at_start(question.scene, question.seed, now, hidden);
    const VehicleId removed = id_at_start(question.scene, question.seed, now, rebuilt);
    if (removed != no_vehicle && removed != question.vehicle) question.removed = {removed};
    runs.question = std::move(question);
}

}  // namespace

void handle_mystery(Lab& lab, const MysteryRequest& wanted) {
    const VehicleView* selected = selected_vehicle(lab);
    const VehicleView* hidden = first_hidden(lab);
    const VehicleView* rebuilt = rebuilt_vehicle(lab);
    const bool in_exercise = lab.document.lesson.has_value();
    switch (wanted.edit) {
        case MysteryEdit::hide:
            if (selected && !hidden && !in_exercise) set_hidden(lab, *selected, true);
            return;
        case MysteryEdit::reveal:
            if (hidden && !in_exercise) set_hidden(lab, *hidden, false);
            return;
        case MysteryEdit::rebuild:
            if (hidden && !in_exercise) add_rebuilt(lab, *hidden);
            return;
        case MysteryEdit::score:
            if (hidden && rebuilt) ask_score(lab, *hidden, *rebuilt);
            return;
    }
}

void update_mystery(Lab& lab, Jobs& jobs) {
    MysteryRuns& runs = lab.mystery;
    if (runs.run != lab.document.run_id) runs = {.run = lab.document.run_id};
    if (runs.begins) {
        runs.begins = false;
        auto base = insight::MysteryBase::create(*runs.question);
        if (!base) return void(runs.error = base.error());
        runs.job = jobs.submit(
            (*base)->question().starts, [base = *base](std::size_t start) { return MysteryPiece(base, start); },
            [](std::vector<insight::MysteryStart> starts) { return insight::score_of(std::move(starts)); });
    }
    if (!runs.job) return;
    auto done = runs.job->take();
    if (!done) return;
    runs.job.reset();
    if (*done)
        runs.score = std::move(**done);
    else
        runs.error = done->error();
}

bool is_computing(const MysteryRuns& runs) { return runs.begins || runs.job; }

MysteryView mystery_of(const Lab& lab) {
    MysteryView shown;
    if (const VehicleView* hidden = first_hidden(lab)) shown.hidden = hidden->id;
    if (const VehicleView* rebuilt = rebuilt_vehicle(lab)) shown.rebuilt = rebuilt->id;
    const MysteryRuns& runs = lab.mystery;
    if (runs.run != lab.document.run_id) return shown;
    shown.is_computing = is_computing(runs);
    if (runs.job) shown.progress = runs.job->progress().fraction;
    if (runs.score) shown.score = &*runs.score, shown.scene = &runs.question->scene;
    shown.error = runs.error;
    return shown;
}

}  // namespace braitenlab
