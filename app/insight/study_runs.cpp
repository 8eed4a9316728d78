#include "app/insight/study_runs.h"

#include <algorithm>
#include <utility>

#include "app/files/data.h"
#include "app/files/study_files.h"
#include "ui/lab_view.h"

namespace braitenlab {

namespace {

constexpr std::size_t runs_per_job = 8;
constexpr std::size_t study_ticks = 60;  // a few milliseconds with twenty vehicles

// A run of a study as a part of a job.
class RunPiece {
public:
    RunPiece(const std::shared_ptr<const insight::StudyBase>& base, std::size_t run) : run_(base, run) {}
    std::optional<insight::StudyRow> operator()() {
        if (!run_.advance(study_ticks)) return std::nullopt;
        return run_.row();
    }

private:
    insight::StudyRun run_;
};

void open_study(StudyRuns& study, const std::string& path_or_name) {
    study = {.shown = study.shown};
    const auto path = find_shipped(path_or_name);
    auto base = path ? load_study(*path) : path.error();
    if (base)
        study.base = std::move(*base);
    else
        study.error = base.error();
}

void stop(StudyRuns& study) {
    study.runs = false;
    study.jobs.clear();
    study.begun = study.rows.size();
}

}  // namespace

void handle_study(StudyRuns& study, const StudyRequest& wanted) {
    switch (wanted.edit) {
        case StudyEdit::open:
            return open_study(study, wanted.path);
        case StudyEdit::run:
            study.runs = study.base && study.rows.size() < study.base->study().runs();
            return;
        case StudyEdit::stop:
            return stop(study);
    }
}

void show_study(StudyRuns& study, const std::string& path) {
    open_study(study, path);
    ++study.shown;
}

void update_study(StudyRuns& study, Jobs& jobs) {
    if (!study.runs) return;
    while (!study.jobs.empty()) {
        auto done = study.jobs.front().take();
        if (!done) break;
        study.jobs.pop_front();
        if (!*done) {
            study.error = done->error();
            return stop(study);
        }
        for (insight::StudyRow& row : **done) study.rows.push_back(std::move(row));
    }
    const std::size_t all = study.base->study().runs();
    while (study.jobs.size() < 2 && study.begun < all) {
        const std::size_t first = study.begun, count = std::min(runs_per_job, all - first);
        study.jobs.push_back(
            jobs.submit(count, [base = study.base, first](std::size_t part) { return RunPiece(base, first + part); }));
        study.begun += count;
    }
    if (study.rows.size() == all) study.runs = false;
}

StudyView study_of(const StudyRuns& study) {
    return {.base = study.base, .rows = &study.rows, .runs = study.runs, .error = study.error, .shown = study.shown};
}

}  // namespace braitenlab
