#include "app/document.h"

#include "app/data.h"
#include "core/world/run_file.h"

namespace braitenlab {

namespace {

Result<Document> open_run(const std::filesystem::path& path) {
    auto run = load_run(path);
    if (!run) return run.error();
    Document document = resume_document(std::move(*run));
    document.name = path.stem().string();
    document.path = path;
    document.saved_tick = document.session.snapshot().tick;
    return document;
}

}  // namespace

FileMark mark_of(const std::filesystem::path& path) {
    std::error_code problem, other;
    const FileMark mark{std::filesystem::last_write_time(path, problem), std::filesystem::file_size(path, other)};
    return problem || other ? FileMark{} : mark;
}

Result<Document> open_document(const std::filesystem::path& path, std::optional<std::uint64_t> seed,
                               const std::vector<Setting>& settings) {
    if (path.extension() == run_ending) return open_run(path);
    const FileMark mark = mark_of(path);  // before reading, so that a change during reading is noticed later
    std::optional<Exercise> exercise;
    std::optional<Scene> scene;
    if (is_exercise(path)) {
        auto loaded = load_exercise(path, settings);
        if (!loaded) return loaded.error();
        exercise = std::move(*loaded);
        scene = exercise->scene;
    } else {
        auto loaded = load_scene(path, settings);
        if (!loaded) return loaded.error();
        scene = std::move(*loaded);
    }
    auto session = Session::open(*scene, seed.value_or(exercise ? exercise->seed : 1));
    if (!session) return session.error();
    Document document{.session = std::move(*session),
                      .name = path.stem().string(),
                      .path = path,
                      .file = std::make_shared<const Scene>(std::move(*scene)),
                      .on_disk = mark,
                      .settings = settings};
    if (exercise) {
        auto shared = std::make_shared<const Exercise>(std::move(*exercise));
        document.lesson = Lesson{shared, Referee(*shared), {.exercise = shared.get()}};
    }
    return document;
}

Document resume_document(SavedRun run) {
    Document document{.session = Session::resume(std::move(run))};
    document.file = std::make_shared<const Scene>(document.session.scene());
    return document;
}

}  // namespace braitenlab
