#include "core/scene/subject.h"

#include <utility>

namespace braitenlab {

int subject_kind(const Scene& scene) { return scene.starts.empty() ? -1 : find_kind(scene, scene.starts.front().kind); }

Submission submission_of(const Kind& kind) { return {kind.brain, kind.sensors, kind.body}; }

Kind with_submission(Kind kind, Submission submission) {
    kind.brain = std::move(submission.brain);
    kind.sensors = std::move(submission.sensors);
    kind.body = submission.body;
    return kind;
}

bool differ_in_submission_only(const Kind& a, const Kind& b) { return with_submission(a, submission_of(b)) == b; }

}  // namespace braitenlab
