#include "app/files/autosave.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "app/files/edits_json.h"
#include "app/files/file_commands.h"
#include "app/files/safe_file.h"
#include "core/io/checked_json.h"
#include "core/io/run_file.h"
#include "core/lesson/submission.h"
#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "core/scene/folder_entries.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

constexpr const char* autosave_extension = ".autosave";
constexpr const char* broken_extension = ".broken";
constexpr std::size_t most_edits_kept = 50;  // a browser has room for about 5 MB
constexpr int deepest_nesting = 32;          // of arrays and objects
constexpr int most_runs = 1'000'000;         // of an exercise, read from a file

std::string local_time() {
    const std::time_t now = std::time(nullptr);
    char text[32] = {};
    if (const std::tm* local = std::localtime(&now)) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", local);
    return text;
}

Result<std::string> autosave_text(const fs::path& path) { return read_text(path, io::most_run_bytes, "run_too_large"); }

// The array or object with which the text begins; empty if there is none, or if it is too deep for nlohmann's dump(),
// which recurses.
std::string_view first_value(std::string_view text) {
    int depth = 0;
    bool is_in_text = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (is_in_text && c == '\\') {
            ++i;
        } else if (c == '"') {
            is_in_text = !is_in_text;
        } else if (!is_in_text && (c == '{' || c == '[')) {
            if (++depth > deepest_nesting) return {};
        } else if (!is_in_text && (c == '}' || c == ']')) {
            if (--depth <= 0) return text.substr(0, i + 1);
        }
    }
    return {};
}

// The values of an autosave beside its run.
struct AutosaveKeys {
    std::string when, title, name;
    fs::path path;
    std::optional<std::uint64_t> content;
    bool ended = false;
    std::optional<Draft::Progress> exercise;
    Edits edits;
};

Draft::Progress read_progress_keys(const nlohmann::json& exercise) {
    Draft::Progress progress;
    exercise.at("prediction").get_to(progress.answers.prediction);
    exercise.at("hints_shown").get_to(progress.answers.hints_shown);
    exercise.at("has_run").get_to(progress.has_run);
    progress.outcome_known = exercise.value("outcome_known", false);
    progress.runs = std::clamp(exercise.value("runs", int{progress.has_run}), 0, most_runs);
    for (const auto& [x, y] : exercise.value("drawn_path", std::vector<std::pair<float, float>>()))
        if (std::isfinite(x) && std::isfinite(y)) progress.answers.drawn_path.push_back({x, y});
    progress.answers.drawn_seed = exercise.value("drawn_seed", std::uint64_t{0});
    if (exercise.contains("referee")) progress.referee = io::json_text(exercise.at("referee"));
    return progress;
}

nlohmann::json progress_keys(const Draft::Progress& progress) {
    nlohmann::json keys{{"prediction", progress.answers.prediction},
                        {"has_run", progress.has_run},
                        {"runs", progress.runs},
                        {"outcome_known", progress.outcome_known},
                        {"hints_shown", progress.answers.hints_shown}};
    if (!progress.answers.drawn_path.empty()) {
        std::vector<std::pair<float, float>> path;
        for (const maths::vec2 point : progress.answers.drawn_path) path.emplace_back(point.x, point.y);
        keys["drawn_path"] = path, keys["drawn_seed"] = progress.answers.drawn_seed;
    }
    if (!progress.referee.empty()) keys["referee"] = nlohmann::json::parse(progress.referee);
    return keys;
}

// Reads no more than these keys, with which the file begins.
Result<AutosaveKeys> read_keys(std::string_view text, const std::string& file_name) {
    constexpr std::string_view begin = "{\"autosave\":";
    const std::string_view value = text.starts_with(begin) ? first_value(text.substr(begin.size())) : "";
    if (value.empty()) return error_of(message_of("not_an_autosave"), file_name);
    try {
        const auto json = nlohmann::json::parse(value);
        AutosaveKeys keys;
        json.at("when").get_to(keys.when);
        json.at("name").get_to(keys.name);
        keys.title = json.value("title", keys.name);
        keys.path = json.at("path").get<std::string>();
        json.at("ended").get_to(keys.ended);
        if (const auto& content = json.value("content", nlohmann::json()); !content.is_null())
            keys.content = content.get<std::uint64_t>();
        if (json.contains("edits")) keys.edits = read_edits(json.at("edits")).value_or(Edits{});
        if (const auto& exercise = json.at("exercise"); !exercise.is_null())
            keys.exercise = read_progress_keys(exercise);
        return keys;
    } catch (const nlohmann::json::exception& problem) {
        return error_of(message_of("not_an_autosave") + Message(fmt::format(": {}", problem.what())), file_name);
    }
}

Result<Document> document_of(const AutosaveKeys& keys, SavedRun run) {
    if (!keys.exercise) {
        Document document = resume_document(std::move(run), keys.edits);
        document.name = keys.name;
        document.path = keys.path;
        document.on_disk = mark_of(keys.path);
        document.content = keys.content;
        if (auto scene = load_scene(keys.path)) {
            // A copy that states no name has that of its file; the run keeps the name that it began with.
            document.is_scene_named_by_file = scene->name == keys.path.stem().string();
            if (document.is_scene_named_by_file) scene->name = document.session.scene().name;
            document.file = std::make_shared<const Scene>(std::move(*scene));
        }
        return document;
    }
    auto document = open_document(keys.path, std::nullopt, {});
    if (!document) return document.error();
    RunObserver observer;
    if (document->lesson) {
        Referee referee(*document->lesson->exercise);
        if (auto state = read_referee_state(keys.exercise->referee, *document->lesson->exercise))
            referee.restore(std::move(*state));
        observer = RunObserver::of(std::move(referee));
        Attempt& attempt = document->lesson->attempt;
        const auto hints = static_cast<int>(document->lesson->exercise->hints.size());
        const Attempt::Answers& answers = keys.exercise->answers;
        attempt.answers.prediction = answers.prediction;
        attempt.answers.drawn_path = answers.drawn_path, attempt.answers.drawn_seed = answers.drawn_seed;
        attempt.work.has_run = keys.exercise->has_run;
        attempt.work.runs = keys.exercise->runs;
        attempt.answers.hint_ready |= attempt.work.has_run;
        attempt.work.outcome_known = keys.exercise->outcome_known;
        attempt.answers.hints_shown = std::clamp(answers.hints_shown, 0, hints);
    }
    document->session = Session::resume(std::move(run), std::move(observer), keys.edits);
    return document;
}

void set_aside_autosave(const fs::path& path) {
    std::error_code none;
    fs::path aside = path;
    aside += broken_extension;
    fs::rename(path, aside, none);
}

fs::path lock_of(fs::path file) { return file.replace_extension(".lock"); }

void remove_with_lock(const fs::path& file) {
    std::error_code none;
    fs::remove(file, none);
    fs::remove(lock_of(file), none);
}

bool is_too_old(const fs::path& file) {
    std::error_code problem;
    const auto written = fs::last_write_time(file, problem);
    return !problem && fs::file_time_type::clock::now() - written > Autosave::kept_for;
}

// Calls visit(path) for each autosave of a lab that has ended.
template <class Visit>
void for_each_leftover(const fs::path& folder, const Visit& visit) {
    for_each_entry(folder, [&](const fs::directory_entry& entry) {
        const fs::path& file = entry.path();
        if (file.extension() == autosave_extension && lock_file(lock_of(file))) visit(file);
    });
}

// True if a person has changed the scene, or what the student of an exercise may change, or has predicted; after a
// crash also for a run of predators and prey, whose population has a history.
bool has_work(const Autosaved& kept) {
    const Document& document = kept.document;
    const Snapshot& now = document.session.snapshot();
    if (const auto& lesson = document.lesson)
        return has_predicted(lesson->attempt.answers) ||
               submission_of(*lesson->exercise, now) != as_shipped(*lesson->exercise);
    const bool has_history = now.predators > 0 || now.prey > 0;
    return (has_history && !kept.ended) || !document.file || document.session.edited_scene() != *document.file;
}

Error cannot_store(const Error& reason) {
    return error_of(message_of("no_recovery") + message_of(reason), reason.file, reason.line);
}

}  // namespace

Draft draft_of(const Document& document) { return draft_of(document, document.session); }

Draft draft_of(const Document& document, const Session& session) {
    Draft draft{title_of(document), document.name,   document.path, document.content,
                session.save(),     session.edits(), std::nullopt,  false};
    if (document.lesson) {
        const Attempt& attempt = document.lesson->attempt;
        draft.hides_brain = !document.lesson->exercise->hides.empty();
        const auto& referee = *session.observer_at_keyframe().as<Referee>();
        draft.exercise = Draft::Progress{attempt.answers, attempt.work.has_run, attempt.work.outcome_known,
                                         attempt.work.runs, write_referee_state(referee.state())};
    }
    const auto& kinds = session.snapshot().scene->kinds;
    const bool has_hidden = std::any_of(kinds.begin(), kinds.end(), [](const Kind& kind) { return kind.hidden; });
    if (has_hidden || draft.hides_brain) draft.edits = {};
    return draft;
}

std::string write_autosave(const Draft& draft, std::string_view when, bool ended) {
    nlohmann::json keys{{"when", when},
                        {"ended", ended},
                        {"title", draft.title},
                        {"name", draft.name},
                        {"path", draft.path.string()},
                        {"exercise", nullptr},
                        {"content", nullptr}};
    if (draft.content) keys["content"] = *draft.content;
    keys["edits"] = edits_json(draft.edits, most_edits_kept);
    if (draft.exercise) keys["exercise"] = progress_keys(*draft.exercise);
    // The first key of the run's object, so that read_keys() need not read the run.
    std::string text = io::write_run(draft.run, draft.hides_brain ? io::Seals::always : io::Seals::hidden_kinds);
    return text.insert(1, "\"autosave\":" + io::json_text(keys) + ",");
}

Result<Autosaved> open_autosave(std::string_view text, std::string file_name) {
    const auto keys = read_keys(text, file_name);
    if (!keys) return keys.error();
    auto run = io::read_run(text, file_name);
    if (!run) return run.error();
    auto document = document_of(*keys, std::move(*run));
    if (!document) return document.error();
    return Autosaved{std::move(*document), keys->when, keys->ended};
}

Autosave::Autosave(fs::path folder, std::vector<Error>& errors) : folder_(std::move(folder)) {
    if (folder_.empty()) return;
    for_each_entry(folder_, [](const fs::directory_entry& entry) {
        std::error_code none;
        if (entry.path().extension() == broken_extension && is_too_old(entry.path())) fs::remove(entry.path(), none);
    });
    for_each_entry(folder_, [&](const fs::directory_entry& entry) {
        const fs::path& file = entry.path();
        if (file.extension() != autosave_extension) return;
        lock_file(lock_of(file)) ? take_up(file, errors) : locked_.push_back(file);
    });
    offer_newest();
}

void Autosave::take_up(const fs::path& file, std::vector<Error>& errors) {
    if (is_too_old(file)) return remove_with_lock(file);
    const auto text = autosave_text(file);
    const auto keys = text ? read_keys(*text, file.string()) : text.error();
    std::optional<Error> fault = keys ? std::nullopt : std::optional(keys.error());
    bool work = true;
    if (keys && text->size() <= most_at_start) {
        const auto opened = open_autosave(*text, file.string());
        opened ? void(work = has_work(*opened)) : void(fault = opened.error());
    }
    if (fault) {
        errors.push_back(
            error_of(message_of(*fault) + Message("; its work cannot be recovered; the file is renamed to " +
                                                  file.filename().string() + ".broken"),
                     fault->file, fault->line));
        set_aside_autosave(file);
        return;
    }
    std::error_code none;
    older_.push_back(
        {file, {keys->title, keys->path.string(), keys->when, keys->ended, work}, fs::last_write_time(file, none)});
}

void Autosave::offer_newest() {
    if (leftover_) older_.push_back(std::move(*leftover_));
    const auto rank = [](const Leftover& each) {
        return std::tuple(each.offer.has_work, std::string_view(each.offer.when), each.written);
    };
    std::sort(older_.begin(), older_.end(), [&](const Leftover& a, const Leftover& b) { return rank(a) < rank(b); });
    pass_over();
}

void Autosave::follow_ending_labs(double wall_seconds, std::vector<Error>& errors) {
    constexpr double between = 0.1;  // s
    if (locked_.empty() || wall_seconds - searched_at_ < between) return;
    searched_at_ = wall_seconds;
    const std::size_t known = older_.size();
    std::error_code none;
    std::erase_if(locked_, [&](const fs::path& file) {
        if (!fs::exists(file, none)) return true;  // its lab has ended properly
        if (!lock_file(lock_of(file))) return false;
        take_up(file, errors);
        return true;
    });
    if (older_.size() > known) offer_newest();
    if (wall_seconds > still_ending) locked_.clear();
}

Result<Document> Autosave::recover() const {
    if (!leftover_) return error_of(message_of("nothing_to_recover"));
    const auto text = autosave_text(leftover_->file);
    if (!text) return text.error();
    auto opened = open_autosave(*text, leftover_->file.string());
    if (!opened) return opened.error();
    return std::move(opened->document);
}

void Autosave::forget() {
    if (!leftover_) return;
    remove_with_lock(leftover_->file);
    pass_over();
}

void Autosave::pass_over() {
    leftover_.reset();
    if (older_.empty()) return;
    leftover_ = std::move(older_.back());
    older_.pop_back();
}

void Autosave::set_aside() {
    if (leftover_) set_aside_autosave(leftover_->file);
    pass_over();
}

void Autosave::forget_work_on(const fs::path& saved) {
    if (folder_.empty()) return;
    for_each_leftover(folder_, [&](const fs::path& file) {
        const auto text = autosave_text(file);
        const auto keys = text ? read_keys(*text, file.string()) : text.error();
        if (!keys || keys->path != absolute_path(saved)) return;
        std::erase_if(older_, [&](const Leftover& each) { return each.file == file; });
        if (leftover_ && leftover_->file == file) pass_over();
        remove_with_lock(file);
    });
}

Autosave::Reached Autosave::reached_by(const Document& document) {
    Reached here{document.edits, document.session.snapshot().tick};
    if (const auto& lesson = document.lesson)
        here.prediction = lesson->attempt.answers.prediction, here.drawn_path = lesson->attempt.answers.drawn_path;
    return here;
}

bool Autosave::lock() {
    if (lock_) return true;
    std::error_code problem;
    fs::create_directories(folder_, problem);
    // Process numbers are reused. With the time, the name differs from that of an earlier leftover.
    file_ = folder_ / fmt::format("{}-{}{}", std::time(nullptr), process_number(), autosave_extension);
    lock_ = lock_file(lock_of(file_));
    return lock_.has_value();
}

std::optional<Error> Autosave::settle() {
    if (!writing_.valid()) return std::nullopt;
    const std::optional<Error> error = writing_.get();
    if (!error) return failed_ = false, std::nullopt;
    written_ = {};  // try again
    return std::exchange(failed_, true) ? std::nullopt : error;
}

std::optional<Error> Autosave::keep(const Lab& lab, double wall_seconds, Occasion occasion) {
    if (folder_.empty()) return std::nullopt;
    const Document& document = lab.document;
    const bool now = occasion != Occasion::frame;
    due_ |= std::exchange(mode_, lab.playback.mode) != lab.playback.mode;
    const bool busy = writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
    if (busy && !now) return std::nullopt;
    auto error = settle();
    const Reached here = reached_by(document);
    if (lab.pages || here == Reached{document.saved_edits, document.saved_tick}) {
        finish();
        return error;
    }
    if (here == written_ && occasion != Occasion::end) return error;
    if (dirty_since_ < 0) dirty_since_ = wall_seconds;
    const double by_period = std::max(dirty_since_ + soon, written_at_ + period);
    const bool is_costly = failed_ || !has_threads();  // a page writes on the window's thread, also when it is hidden
    const double due_at = here.edits == written_.edits || is_costly ? by_period : written_at_ + soon;
    const bool is_answered = here.prediction >= 0 || !here.drawn_path.empty();
    const bool is_new_answer =
        is_answered && (here.prediction != written_.prediction || here.drawn_path != written_.drawn_path);
    if (!now && !due_ && (failed_ || !is_new_answer) && wall_seconds < due_at) return error;
    if (here.tick == document.saved_tick && !is_answered && !has_unsaved_edits(lab)) {
        finish();
        written_ = here;
        return error;
    }
    dirty_since_ = -1;
    written_at_ = wall_seconds;
    due_ = false;
    written_ = here;
    write(lab, occasion == Occasion::end);
    return now ? settle() : error;
}

void Autosave::write(const Lab& lab, bool ended) {
    if (!lock()) {
        std::promise<std::optional<Error>> failed;
        failed.set_value(cannot_store({"check that the folder may be written to and has room", folder_.string()}));
        writing_ = failed.get_future();
        return;
    }
    const auto own = session_with_own_brain(lab.slots, lab);
    const Session& kept = own ? *own : lab.document.session;
    const auto task = [file = file_, draft = draft_of(lab.document, kept), when = local_time(),
                       ended]() -> std::optional<Error> {
        if (auto error = write_whole(file, write_autosave(draft, when, ended))) return cannot_store(*error);
        return std::nullopt;
    };
    writing_ = has_threads() ? start_or_run(task, [](const auto& job) { return std::async(std::launch::async, job); })
                             : run_now(task);
}

void Autosave::finish() {
    (void)settle();
    written_ = {};
    dirty_since_ = -1;
    written_at_ = -period;
    due_ = false;
    if (!lock_) return;
    std::error_code none;
    fs::remove(file_, none);  // before the lock: no other lab may take it for a leftover
    lock_.reset();            // before the file of the lock: Windows keeps a file that is open
    fs::remove(lock_of(file_), none);
}

}  // namespace braitenlab
