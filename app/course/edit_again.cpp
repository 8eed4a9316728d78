#include "app/course/edit_again.h"

#include <utility>

#include "app/lab_edits.h"
#include "app/lab_reset.h"
#include "core/insight/compare.h"
#include "core/lesson/author.h"
#include "core/lesson/submission.h"

namespace braitenlab {

namespace {

// The vehicle of the scene gets this brain and these sensors, as one step of undo.
void put_submission(Lab& lab, const std::string& vehicle, const Submission& submission) {
    reset(lab);
    const Snapshot& now = lab.document.session.snapshot();
    const std::size_t start = subject_start({.vehicle = vehicle}, *now.scene);
    const std::uint64_t gesture = new_gesture(lab);
    for (const VehicleView& each : now.vehicles) {
        if (each.start != static_cast<int>(start)) continue;
        const VehicleView subject = each;
        const bool is_own = now.scene->starts[start].brain || now.scene->starts[start].sensors;
        const Target target = is_own ? Target{subject.id, -1} : Target{no_vehicle, subject.kind};
        for (const Command& command :
             insight::commands_for({submission.brain, submission.sensors}, now, subject, target))
            apply(lab, command, gesture);
        return;
    }
}

}  // namespace

void open_authored(Lab& lab, Document exercise, const std::filesystem::path& path, const std::string& vehicle) {
    auto kept = std::make_shared<AuthoredScene>(
        AuthoredScene{.scene = std::move(lab.document), .vehicle = vehicle, .path = path, .content = exercise.content});
    lab.document.run_id = kept->scene.run_id;  // the exercise gets the next one
    replace_document(lab, std::move(exercise));
    kept->exercise_run = lab.document.run_id;
    lab.authored = std::move(kept);
}

void edit_again(Lab& lab) {
    if (!has_draft(lab.authored.get(), lab.document)) return;
    const Exercise& exercise = *lab.document.lesson->exercise;
    const Submission now = submission_of(exercise, lab.document.session.snapshot());
    const bool edited = is_edited(exercise, now);
    AuthoredScene& kept = *lab.authored;
    replace_document(lab, std::move(kept.scene));
    kept.exercise_run = 0;
    kept.restored_run = lab.document.run_id;
    if (edited) put_submission(lab, kept.vehicle, now);
}

}  // namespace braitenlab
