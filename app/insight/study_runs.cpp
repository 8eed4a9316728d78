#include "app/insight/study_runs.h"

#include <algorithm>
#include <utility>

#include "app/files/data.h"
#include "app/files/disk.h"
#include "app/lab.h"
#include "app/lab_selection.h"

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

void stop(StudyRuns& study) {
    study.runs = false;
    study.jobs.clear();
    study.begun = study.rows.size();
}

// Runs that are in files beside the study are taken over.
void take_table(StudyRuns& study) {
    StudyTable table(study.base, table_of_study(study.file).string());
    std::vector<std::filesystem::path> files{study.file};
    if (const auto scene = scene_of_study(study.base->study(), study.file)) files.push_back(*scene);
    table.read(files);
    if (table.rows().empty()) return;
    if (table.rows().size() > study.rows.size()) {
        const bool runs = study.runs && table.rows().size() < study.base->study().runs();
        study.rows = table.rows();
        stop(study);
        study.runs = runs;
    }
    study.table.emplace(std::move(table));
}

void open_study(StudyRuns& study, const std::string& path_or_name) {
    study = {.shown = study.shown};
    const auto path = find_shipped(path_or_name);
    auto base = path ? load_study(*path) : path.error();
    if (!base) {
        study.error = base.error();
        return;
    }
    study.base = std::move(*base);
    if (ships(*path)) return;
    study.file = *path;
    take_table(study);
}

bool has_path_with(const insight::Study& study, std::string_view part) {
    for (const insight::StudyValue& value : study.values)
        for (const std::string& path : value.paths)
            if (path.find(part) != std::string::npos) return true;
    return false;
}

// A study of the open scene. It is read from the text that save_study() writes, so that its checks are those of a file.
void build_study(Lab& lab, insight::Study wanted) {
    StudyRuns& study = lab.study;
    study = {.shown = study.shown};
    const VehicleView* vehicle = selected_vehicle(lab);
    const LabView view = view_of(lab);
    Scene scene = lab.document.session.edited_scene();
    if (vehicle) {
        const insight::ValueSubject subject{*view.now, *vehicle, target_of(view, *vehicle), shown_pair(view, *vehicle)};
        if (has_path_with(wanted, ".sensor.")) place_sensors(scene, subject);
        if (has_path_with(wanted, ".brain.")) place_brain(scene, subject);
    }
    wanted.id = (lab.document.name.empty() ? "scene" : lab.document.name) + "-study";
    wanted.scene = wanted.id + "-scene.toml";
    wanted.first_seed = lab.document.session.seed();
    auto read = insight::parse_study(insight::write_study(wanted), wanted.id + ".toml");
    std::string text = write_scene(scene);
    auto base = read ? insight::StudyBase::create(std::move(*read), text, wanted.scene) : read.error();
    if (base)
        study.base = std::move(*base), study.scene_text = std::move(text);
    else
        study.error = base.error();
}

// The next complete runs, also for the file of the table.
std::optional<Error> add_rows(StudyRuns& study, const std::vector<insight::StudyRow>& rows) {
    study.rows.insert(study.rows.end(), rows.begin(), rows.end());
    if (!study.table) return std::nullopt;
    if (!study.table->is_begun())
        if (auto error = study.table->begin()) return error;
    // What is in the file already is not written twice.
    if (study.table->rows().size() > study.rows.size()) return std::nullopt;
    const std::vector<insight::StudyRow> missing(
        study.rows.begin() + static_cast<std::ptrdiff_t>(study.table->rows().size()), study.rows.end());
    if (auto error = study.table->add(missing)) return error;
    return study.rows.size() == study.base->study().runs() ? study.table->finish() : std::nullopt;
}

}  // namespace

void handle_study(Lab& lab, const StudyRequest& wanted) {
    StudyRuns& study = lab.study;
    switch (wanted.edit) {
        case StudyEdit::open:
            return open_study(study, wanted.path);
        case StudyEdit::build:
            if (wanted.study) build_study(lab, *wanted.study);
            return;
        case StudyEdit::run:
            study.runs = study.base && study.rows.size() < study.base->study().runs();
            return;
        case StudyEdit::stop:
            return stop(study);
        case StudyEdit::save:
            lab.files.push_back(wanted);
            return;
    }
}

Result<std::filesystem::path> save_study(StudyRuns& study, const std::filesystem::path& folder) {
    if (study.file.empty()) {
        auto path = write_study_files(study.base->study(), study.scene_text, folder);
        if (!path) return path.error();
        study.file = std::move(*path), study.scene_text.clear();
    }
    if (!study.table) take_table(study);
    if (!study.table) study.table.emplace(study.base, table_of_study(study.file).string());
    if (study.table->rows().size() < study.base->study().runs())
        if (auto error = add_rows(study, {})) return *error;
    return study.table->path();
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
        if (auto error = add_rows(study, **done)) {
            study.error = std::move(error);
            return stop(study);
        }
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
    return {.base = study.base,
            .rows = &study.rows,
            .runs = study.runs,
            .is_built = study.base && !study.scene_text.empty(),
            .has_file = !study.file.empty(),
            .table = study.table ? study.table->path().string() : "",
            .error = study.error,
            .shown = study.shown};
}

}  // namespace braitenlab
