#include "app/features/study_runs.h"

#include <algorithm>
#include <utility>

#include "app/files/data.h"
#include "app/jobs/in_pieces.h"
#include "app/lab_selection.h"
#include "app/workspace.h"
#include "core/insight/axis_value.h"

namespace braitenlab {

namespace {

constexpr std::size_t runs_per_job = 8;
constexpr std::size_t study_ticks = 60;  // a few milliseconds with twenty vehicles

void stop(StudyRuns& study) {
    study.runs = false;
    study.jobs.clear();
    study.begun = study.rows.size();
}

// Takes over the runs of a table that has more of them.
void take_rows(StudyRuns& study, const StudyTable& table) {
    if (table.rows().size() <= study.rows.size()) return;
    const bool runs = study.runs && table.rows().size() < study.base->study().runs();
    study.rows = table.rows();
    stop(study);
    study.runs = runs;
}

// Runs that are in files beside the study are taken over.
void take_table(StudyRuns& study) {
    StudyTable table(study.base, table_of_study(study.file, study.base->study()).string());
    std::vector<std::filesystem::path> files{study.file};
    if (const auto scene = scene_beside(study.file, study.base->study().scene)) files.push_back(*scene);
    table.read(files);
    if (table.rows().empty()) return;
    take_rows(study, table);
    study.table.emplace(std::move(table));
}

// A built study that is not saved is alone in a folder of its own.
std::filesystem::path built_in(const StudyRuns& study) { return study.kept_in / "built"; }

// Without a table beside its file, the runs of a study are kept for the next start, and those of the last start are
// taken over.
void keep_runs(StudyRuns& study) {
    if (study.table || study.kept_in.empty()) return;
    study.kept.emplace(study.base, (study.kept_in / (study.base->study().id + ".csv")).string(), OtherRuns::make_room);
    study.kept->read({});
    take_rows(study, *study.kept);
}

// Keeps the study for the next start of the lab. Without a folder, or where it cannot be written, there is no such
// file.
void keep_built_study(StudyRuns& study) {
    if (study.kept_in.empty()) return;
    std::error_code none;
    std::filesystem::remove_all(built_in(study), none);
    std::filesystem::create_directories(built_in(study), none);
    if (const auto file = write_study_files(study.base->study(), study.scene_text, built_in(study)))
        study.last = file->string();
}

void forget_study(StudyRuns& study) {
    study = {.shown = study.shown, .last = std::move(study.last), .kept_in = std::move(study.kept_in)};
}

void open_study(StudyRuns& study, const std::string& path_or_name) {
    forget_study(study);
    const auto path = find_shipped(path_or_name, Shipped::study);
    auto base = path ? load_study(*path) : path.error();
    if (!base) {
        study.error = base.error();
        return;
    }
    study.base = std::move(*base);
    study.last = ships(*path) ? study.base->study().id : std::filesystem::absolute(*path).string();
    const bool is_built = !study.kept_in.empty() && path->parent_path() == built_in(study);
    if (is_built) {
        const auto scene = scene_beside(*path, study.base->study().scene);
        const auto text = scene ? read_text(*scene) : scene.error();
        if (text) study.scene_text = *text;
    } else if (!ships(*path)) {
        study.file = *path;
        take_table(study);
    }
    keep_runs(study);
}

bool has_path_with(const insight::Study& study, std::string_view part) {
    for (const insight::StudyValue& value : study.values)
        for (const std::string& path : value.paths)
            if (path.find(part) != std::string::npos) return true;
    return false;
}

// A study of the open scene. It is read from the text that save_study() writes, so that its checks are those of a file.
void build_study(StudyRuns& study, const Workspace& space, insight::Study wanted) {
    forget_study(study);
    const VehicleView* vehicle = selected_vehicle(space);
    Scene scene = space.document.session.edited_scene();
    if (vehicle) {
        const Snapshot& now = space.document.session.snapshot();
        const Selection& selection = space.view.selection;
        const insight::ValueSubject subject{now, *vehicle, target_of(selection, *vehicle),
                                            chosen_pair(kind_of(now, *vehicle), selection.pair)};
        if (has_path_with(wanted, ".sensor.")) place_sensors(scene, subject);
        if (has_path_with(wanted, ".brain.")) place_brain(scene, subject);
    }
    wanted.id = (space.document.name.empty() ? "scene" : space.document.name) + "-study";
    wanted.scene = wanted.id + "-scene.toml";
    wanted.first_seed = space.document.session.seed();
    auto read = insight::parse_study(insight::write_study(wanted), wanted.id + ".toml");
    std::string text = write_scene(scene);
    auto base = read ? insight::StudyBase::create(std::move(*read), text, wanted.scene) : read.error();
    if (!base) {
        study.error = base.error();
        return;
    }
    study.base = std::move(*base), study.scene_text = std::move(text);
    keep_built_study(study);
    keep_runs(study);
}

// What is in the file already is not written twice.
std::optional<Error> add_missing(StudyTable& table, const std::vector<insight::StudyRow>& rows) {
    if (!table.is_begun())
        if (auto error = table.begin()) return error;
    if (table.rows().size() > rows.size()) return std::nullopt;
    return table.add({rows.begin() + static_cast<std::ptrdiff_t>(table.rows().size()), rows.end()});
}

// The next complete runs, also for the file of the table.
std::optional<Error> add_rows(StudyRuns& study, const std::vector<insight::StudyRow>& rows) {
    study.rows.insert(study.rows.end(), rows.begin(), rows.end());
    if (!study.table) {
        if (study.kept && add_missing(*study.kept, study.rows)) study.kept.reset();  // the study runs without it
        return std::nullopt;
    }
    if (auto error = add_missing(*study.table, study.rows)) return error;
    return study.rows.size() == study.base->study().runs() ? study.table->finish() : std::nullopt;
}

}  // namespace

void begin_studies(StudyRuns& study, std::filesystem::path kept_in, const std::string& last) {
    study.kept_in = std::move(kept_in);
    std::error_code none;
    if (!study.kept_in.empty()) std::filesystem::create_directories(study.kept_in, none);
    if (study.base) return keep_runs(study);  // of the command line
    if (!last.empty() && find_shipped(last)) study.last = last;
}

void handle_study(StudyRuns& study, const Workspace& space, const StudyRequest& wanted) {
    switch (wanted.edit) {
        case StudyEdit::open:
            return open_study(study, wanted.path);
        case StudyEdit::build:
            if (wanted.study) build_study(study, space, *wanted.study);
            return;
        case StudyEdit::run:
            study.runs = study.base && study.rows.size() < study.base->study().runs();
            return;
        case StudyEdit::stop:
            return stop(study);
        case StudyEdit::save:
        case StudyEdit::figure:
            return;
    }
}

Result<std::filesystem::path> save_study(StudyRuns& study, const std::filesystem::path& folder) {
    if (study.file.empty()) {
        auto path = write_study_files(study.base->study(), study.scene_text, folder);
        if (!path) return path.error();
        study.file = std::move(*path), study.scene_text.clear();
        study.last = study.file.string();
    }
    if (!study.table) take_table(study);
    if (!study.table) study.table.emplace(study.base, table_of_study(study.file, study.base->study()).string());
    if (study.table->rows().size() < study.base->study().runs())
        if (auto error = add_rows(study, {})) return *error;
    study.kept.reset();
    std::error_code none;
    if (!study.kept_in.empty()) std::filesystem::remove_all(built_in(study), none);
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
    while (study.jobs.size() < jobs_at_once && study.begun < all) {
        const std::size_t first = study.begun;
        const std::size_t count = std::min(parts_of_next_job(study.jobs.size(), runs_per_job), all - first);
        study.jobs.push_back(jobs.submit(count, [base = study.base, first](std::size_t part) {
            return InPieces(insight::StudyRun(base, first + part), study_ticks, &insight::StudyRun::row);
        }));
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
            .shown = study.shown,
            .last = study.last};
}

}  // namespace braitenlab
