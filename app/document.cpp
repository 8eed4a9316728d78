#include "app/document.h"

#include <fstream>

#include "app/files/data.h"
#include "core/io/run_file.h"
#include "core/lesson/exercise_file.h"
#include "core/maths/fnv.h"

namespace braitenlab {

namespace {

Result<Document> open_run(const std::filesystem::path& path) {
    const auto content = content_of(path);  // before: a change during reading is noticed
    auto run = io::load_run(path);
    if (!run) return run.error();
    Document document = resume_document(std::move(*run));
    document.name = path.stem().string();
    document.path = absolute_path(path);
    document.content = content;
    document.saved_tick = document.session.snapshot().tick;
    return document;
}

}  // namespace

Scene scene_to_keep(const Document& document) {
    Scene scene = document.session.edited_scene();
    if (document.lesson) io::hide_brains(scene, document.lesson->exercise->hides);
    return scene;
}

SavedRun run_to_keep(const Document& document) {
    SavedRun run = document.session.save();
    if (document.lesson) io::hide_brains(run, document.lesson->exercise->hides);
    return run;
}

const Referee& referee_of(const Document& document) { return *document.session.observer().as<Referee>(); }

std::string title_of(const Document& document) {
    const std::string& title =
        document.lesson ? document.lesson->exercise->title : document.session.snapshot().scene->title;
    return title.empty() ? document.name : title;
}

std::filesystem::path absolute_path(const std::filesystem::path& path) {
    std::error_code problem;
    const auto whole = path.empty() ? path : std::filesystem::absolute(path, problem).lexically_normal();
    return problem ? path : whole;
}

FileMark mark_of(const std::filesystem::path& path) {
    std::error_code problem, other;
    const FileMark mark{std::filesystem::last_write_time(path, problem), std::filesystem::file_size(path, other)};
    return problem || other ? FileMark{} : mark;
}

std::optional<std::uint64_t> content_of(const std::filesystem::path& path) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(path, none)) return std::nullopt;  // opening a pipe blocks without a writer
    std::ifstream file(path, std::ios::binary);
    std::uint64_t hash = maths::fnv_start;
    std::string part(1U << 16U, '\0');
    while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
        hash = maths::fnv({part.data(), static_cast<std::size_t>(file.gcount())}, hash);
    return file.eof() ? std::optional(hash) : std::nullopt;
}

Result<FileText> read_file(const std::filesystem::path& path) {
    FileText file{path, detect_kind(path, {}), {}, mark_of(path)};  // marked first: a change during reading is noticed
    if (file.kind == FileKind::run) return file;
    auto text = read_text(path);
    if (!text) return text.error();
    file.text = std::move(*text);
    file.kind = detect_kind(path, file.text);
    return file;
}

Result<Document> open_document(const FileText& file, std::optional<std::uint64_t> seed,
                               const std::vector<Setting>& settings) {
    if (file.kind == FileKind::run) return open_run(file.path);
    std::shared_ptr<const Exercise> exercise;
    if (file.kind == FileKind::exercise) {
        auto parsed = parse_exercise(file.text, file.path, settings);
        if (!parsed) return parsed.error();
        exercise = std::make_shared<const Exercise>(std::move(*parsed));
    }
    auto scene = exercise ? Result<Scene>(exercise->scene) : parse_scene(file.text, file.path.string(), settings);
    if (!scene) return scene.error();
    auto session = Session::open(*scene, seed.value_or(exercise ? exercise->seed : 1),
                                 exercise ? RunObserver::of(Referee(*exercise)) : RunObserver());
    if (!session) return session.error();
    Document document{.session = std::move(*session),
                      .name = file.path.stem().string(),
                      .path = absolute_path(file.path),
                      .is_scene_named_by_file = scene->name == file.path.stem().string(),
                      .file = std::make_shared<const Scene>(std::move(*scene)),
                      .on_disk = file.mark,
                      .content = maths::fnv(file.text),
                      .settings = settings};
    if (exercise) {
        const std::string key = ships(document.path) ? exercise->id : document.path.string();
        document.lesson = Lesson{exercise, key, {.answers = unanswered(*exercise)}};
    }
    return document;
}

Result<Document> open_document(const std::filesystem::path& path, std::optional<std::uint64_t> seed,
                               const std::vector<Setting>& settings) {
    const auto file = read_file(path);
    if (!file) return file.error();
    return open_document(*file, seed, settings);
}

Document resume_document(SavedRun run, Edits edits) {
    Document document{.session = Session::resume(std::move(run), {}, std::move(edits))};
    document.file = std::make_shared<const Scene>(document.session.scene());
    return document;
}

}  // namespace braitenlab
