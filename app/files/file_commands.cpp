#include "app/files/file_commands.h"

#include <algorithm>
#include <utility>

#include <fmt/ranges.h>

#include "app/course/edit_again.h"
#include "app/course/exercise_check.h"
#include "app/course/lab_lecture.h"
#include "app/course/lab_progress.h"
#include "app/features/slots.h"
#include "app/files/autosave.h"
#include "app/files/breeding_files.h"
#include "app/files/disk.h"
#include "app/files/export_folder.h"
#include "app/files/links.h"
#include "app/files/reports.h"
#include "app/files/safe_file.h"
#include "app/lab_edits.h"
#include "core/export/export.h"
#include "core/io/link.h"
#include "core/io/run_file.h"
#include "core/lesson/author.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/exercise_id.h"
#include "core/lesson/hand_in.h"
#include "core/lesson/write_exercise.h"
#include "core/messages.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

// True if the open exercise is passed with the present brain.
bool passed_before(const Lab& lab) { return lab.document.lesson && lab.document.lesson->standing.passed_before; }

bool has_passed(const Lab& lab) { return lab.document.lesson && has_passed(*lab.document.lesson); }

// True if there are unsaved edits. Then a sheet opens that asks about them before the document is left.
bool asks_before(const Lab& lab, FilesView& view, Leaving leaving) {
    if (!has_unsaved_edits(lab)) return false;
    leaving.title = title_of(lab.document);
    view.leaving = std::move(leaving);
    view.refused.reset();
    return true;
}

// A document of a file. A run that the lab has kept for recovery is its work: an exercise goes on.
Result<Document> open_kept(const FileText& file) {
    if (file.kind == FileKind::run)
        if (const auto text = read_text(file.path); text && text->find("\"autosave\"") != std::string::npos)
            if (auto kept = open_autosave(*text, file.path.string())) {
                kept->document.edits = 1;  // they are in no other file
                return std::move(kept->document);
            }
    return open_document(file, std::nullopt, {});
}

struct FileCommands {
    Lab& lab;
    FilesView& view;
    StoredState& state;
    const UserFolders& folders;

    void fail(const Error& error) const {
        view.refused = for_user(error);
        view.new_folder.clear();
        say(lab, error);
    }

    void done(const fs::path& path, std::string_view said) const {
        const std::string file = path.filename().string();
        if (said.starts_with("files.saved") && saves_by_download())
            say_downloaded(lab, "notice.downloaded", path);
        else if (!said.empty())
            say(lab, {NoticeKind::done, std::string(said), file});
        view.refused.reset();
        view.new_folder.clear();
        ++view.done;
        refresh(view, lab);
    }

    fs::path folder() const {
        std::error_code none;
        if (!view.listing.folder.empty()) return view.listing.folder;
        if (fs::is_directory(state.folder, none)) return state.folder;
        return folders.home;
    }

    void list(const fs::path& path) const {
        view.listing = list_folder(path);
        view.refused.reset();
    }

    void open(const std::string& typed, bool discard = false, bool dropped = false, bool resume = false,
              std::uint64_t seed = 1) const {
        if (io::is_link(typed) || io::begins_like_link(typed)) return open_link(typed, discard, seed);
        const fs::path path = resolved(typed, folder(), folders.home);
        std::error_code none;
        if (dropped && holds_breeding(path)) return open(breeding_in(path).string(), discard, true);
        if (fs::is_directory(path, none)) {
            list(path);
            if (dropped) say(lab, {NoticeKind::notice, "files.dropped_folder", path.filename().string()});
            return;
        }
        const auto file = read_file(path);
        if (!file) return fail(file.error());
        // A file of megabytes is parsed as few times as possible: the window waits.
        if (dropped) {
            if (const auto error = fault_of_dropped(*file)) return fail(*error);
            if (const auto error = list_errors_for_author(lab, path, file->text)) return fail(*error);
        }
        if (holds_hand_in(path.filename().string(), file->text))
            if (const auto handed_in = parse_hand_in(file->text, typed))
                return say(lab, {NoticeKind::notice, "files.is_hand_in", handed_in->student, handed_in->exercise});
        if (path.extension() == ".json")
            if (const auto progress = read_progress(file->text, typed)) return open_progress(*progress, path);
        if (file->kind == FileKind::brain) {
            const std::uint64_t latest = lab.document.session.latest();
            end_together(lab);
            if (const auto error = take_brain(lab, *file)) return fail(*error);
            done(path, "files.took_brain");
            return report_time_change(lab, latest);
        }
        if (file->kind == FileKind::lecture) return open_pages(path, discard, resume);
        if (file->kind == FileKind::study) {
            show_study(lab.study, path.string());
            return done(path, {});
        }
        if (file->kind == FileKind::breeding) {
            show_breeding(lab.breeding, path);
            return done(path, {});
        }
        auto opened = open_kept(*file);
        if (!opened) return fail(opened.error());
        if (!discard &&
            asks_before(lab, view,
                        {.next = path.string(), .next_title = title_of(*opened), .passed = passed_before(lab)}))
            return;
        leave_pages(lab);
        if (path != lab.document.path) empty_slots(lab.slots);
        replace_document(lab, std::move(*opened));
        add_recent_file(state, path, lab.document);
        done(path, {});
        if (dropped) check_exercise_for_author(lab, CheckVoice::quiet);
    }

    void open_progress(const StudentProgress& given, const fs::path& path) const {
        if (!take_progress(lab, given))
            return fail(error_of(message_of("too_many_students", most_students), path.string()));
        done(path, "files.took_progress");
    }

    void open_link(const std::string& link, bool discard, std::uint64_t seed) const {
        auto linked = io::decode_link(link);
        if (!linked) return fail(linked.error());
        if (!linked->exercise.empty()) {
            const auto path = linked_exercise(linked->exercise);
            return path ? open(path->string(), discard) : fail(path.error());
        }
        auto opened = linked_document(std::move(linked->scene), seed);
        if (!opened) return fail(opened.error());
        if (!discard && asks_before(lab, view, {.next = link, .next_title = title_of(*opened), .seed = seed})) return;
        leave_pages(lab);
        empty_slots(lab.slots);
        replace_document(lab, std::move(*opened));
        done({}, {});
    }

    void open_pages(const fs::path& path, bool discard, bool resume) const {
        auto lecture = read_whole_lecture(path);
        if (!lecture) return fail(lecture.error());
        if (!discard &&
            asks_before(
                lab, view,
                {.next = path.string(), .next_title = lecture->title, .resume = resume, .passed = passed_before(lab)}))
            return;
        auto shared = std::make_shared<const Lecture>(std::move(*lecture));
        const bool goes_on = resume && lab.lectures.left && lab.lectures.left->lecture->id == shared->id;
        goes_on ? resume_lecture(lab, std::move(shared)) : open_lecture(lab, std::move(shared));
        done(path, {});
    }

    // The user's answer to FilesView::leaving.
    void leave(Leave answer) const {
        if (!view.leaving) return;
        if (answer == Leave::stay) return view.leaving.reset();
        if (answer == Leave::save) save({view.save_to, FileKind::scene});
        if (answer != Leave::discard && has_unsaved_edits(lab)) return;  // not written: the sheet stays open
        const Leaving left = *std::exchange(view.leaving, std::nullopt);
        if (!left.next.empty()) return open(left.next, true, false, left.resume, left.seed);
        lab.document.saved_edits = lab.document.edits;  // nothing is left to keep, neither edits nor the run
        lab.document.saved_tick = lab.document.session.snapshot().tick;
        lab.window.exit = true;
    }

    void save_numbers(const ExportRequest& wanted, const fs::path& into) const {
        if (const auto error = write_new(lab, into, "braitenlab-" + wanted.name, ".csv", wanted.text, "notice.numbers"))
            fail(*error);
    }

    // The progress of the present student, as another computer takes it over.
    void save_progress(const fs::path& into) const {
        const std::string text = write_progress(lab.students.student());
        if (const auto error = write_new(lab, into, "braitenlab-progress", ".json", text, "files.saved")) fail(*error);
    }

    // The study of the open scene and the table of a study.
    void save_results(const fs::path& folder) const {
        if (!lab.study.base) return;
        const auto table = save_study(lab.study, folder);
        if (!table) return fail(table.error());
        say_saved(lab, "notice.study", *table);
    }

    // Writes the files of an export. The folder above theirs must exist, so that a typing error makes no folders.
    void write_files(const WriteFilesRequest& wanted) const {
        const fs::path into = resolved(wanted.folder, folder(), folders.home);
        std::error_code none;
        if (!fs::exists(into.parent_path(), none)) return fail(error_of(message_of("no_such_folder"), into.string()));
        std::vector<std::string> existing = edited_files(into, *wanted.files);
        for (const robots::ExportedFile& file : *wanted.files)
            if (fs::exists(into / file.name, none) &&
                std::find(existing.begin(), existing.end(), file.name) == existing.end())
                existing.push_back(file.name);
        if (!wanted.replace && !existing.empty())
            return fail(
                error_of(message_of("files_exist", fmt::format("{}", fmt::join(existing, ", "))), into.string()));
        if (auto fault = export_folder_fault(into); fault && !wanted.replace)
            return fail(error_of(message_of("foreign_folder") + message_of("foreign_folder_window"), into.string()));
        if (const auto error = write_export(into, *wanted.files)) return fail(*error);
        view.exported_to = into.string();
        say_saved(lab, "notice.exported", into);
        done(into, {});
    }

    // False if the folder of the file does not exist, and the user has not agreed that it is created.
    bool has_folder(const fs::path& path, const SaveRequest& wanted) const {
        std::error_code none;
        if (wanted.create_folder || fs::exists(path.parent_path(), none)) return true;
        fail(error_of(message_of("no_such_folder"), path.string()));
        view.new_folder = path.parent_path().string();
        return false;
    }

    // True once for each change of the document's file by another program, which saving would replace. Compares
    // contents: a file that is written twice within the resolution of its time keeps time and, perhaps, size.
    bool replaces_work_of_others(const fs::path& path) const {
        Document& document = lab.document;
        if (document.lesson || path != document.path) return false;
        const auto now = content_of(path);
        return now && now != std::exchange(document.content, now);
    }

    // The same for the exercise that its author goes on with.
    bool replaces_edits_of_exercise() const {
        const auto now = content_of(lab.authored->path);
        return now && now != std::exchange(lab.authored->content, now);
    }

    // Writes the exercise, opens it and begins its check.
    void save_exercise(const SaveExerciseRequest& wanted) const {
        const fs::path path = with_extension(resolved(wanted.path, folder(), folders.home), FileKind::scene);
        std::error_code none;
        if (!fs::exists(path.parent_path(), none)) return fail(error_of(message_of("no_such_folder"), path.string()));
        const Document& now = lab.document;
        const bool is_own = lab.authored && lab.authored->path == path && lab.authored->restored_run == now.run_id;
        if (!wanted.replace && !is_own && fs::exists(path, none))
            return fail(error_of(message_of("file_exists"), path.string()));
        if (is_own && replaces_edits_of_exercise()) return fail(error_of(message_of("changed_outside"), path.string()));
        auto made = make_exercise(*wanted.draft, exercise_id_of(path), now.session.edited_scene(), *now.file);
        if (!made) return fail(made.error());
        const std::string text = write_exercise(*made);
        if (auto read = parse_exercise(text, path); !read) return fail(read.error());
        if (const auto error = write_whole(path, text)) return fail(*error);
        auto opened = open_document(path, std::nullopt, {});
        if (!opened) return fail(opened.error());
        lab.students.student().exercises.erase(path.string());  // it is another exercise now
        open_authored(lab, std::move(*opened), path, wanted.draft->vehicle);
        add_recent_file(state, path, lab.document);
        if (!view.listing.folder.empty()) list(view.listing.folder);
        done(path, {});
        check_exercise_for_author(lab);
    }

    void save(const SaveRequest& wanted) const {
        const fs::path path = with_extension(resolved(wanted.path, folder(), folders.home), wanted.kind);
        if (!has_folder(path, wanted)) return;
        if (replaces_work_of_others(path)) return fail(error_of(message_of("changed_outside"), path.string()));
        const std::uint64_t latest = lab.document.session.latest();
        if (wanted.title || wanted.story) {
            if (const auto error = lab.document.session.apply(Retitle{wanted.title, wanted.story})) return fail(*error);
            ++lab.document.edits;
        }
        const auto saved = save_as(lab, path, wanted.kind);
        if (!saved) return fail(saved.error());
        if (wanted.kind == FileKind::run) add_recent_file(state, path, lab.document);
        if (wanted.kind == FileKind::scene) {
            if (!lab.document.lesson) lab.document.path = path, lab.document.name = path.stem().string();
            add_recent_file(state, path, lab.document);
            if (!lab.document.lesson) {
                lab.document.file = std::make_shared<const Scene>(lab.document.session.edited_scene());
                lab.document.on_disk = mark_of(path);
                lab.document.broken.reset();
                lab.window.saved.push_back(path);
            }
        }
        if (path == lab.document.path) lab.document.content = *saved;
        if (wanted.kind != FileKind::brain || lab.document.lesson) lab.document.saved_edits = lab.document.edits;
        if (wanted.kind == FileKind::run) lab.document.saved_tick = lab.document.session.snapshot().tick;
        if (!view.listing.folder.empty()) list(view.listing.folder);
        done(path, wanted.kind == FileKind::brain ? "files.saved_brain" : "files.saved");
        report_time_change(lab, latest);
    }
};

// True if the file that was read again says what the document was opened from: only its time or its comments differ.
bool says_the_same(const Document& opened, const Document& now) {
    if (!now.file || *opened.file != *now.file || opened.lesson.has_value() != now.lesson.has_value()) return false;
    return !now.lesson || write_exercise(*opened.lesson->exercise) == write_exercise(*now.lesson->exercise);
}

void reload(Lab& lab, FilesView& view, Document opened) {
    const Playback before{
        .mode = lab.playback.mode, .time_scale = lab.playback.time_scale, .toggles = lab.playback.toggles};
    const Camera camera = lab.view.camera;
    const bool whole_kind = lab.view.selection.whole_kind;
    replace_document(lab, std::move(opened));
    lab.playback = before;
    lab.view.camera = camera;
    lab.view.selection.whole_kind = whole_kind;
    refresh(view, lab);
    say(lab, {NoticeKind::notice, "files.reloaded", title_of(lab.document)});
    if (lab.document.lesson) set_mode(lab, Mode::paused), check_exercise_for_author(lab);
}

}  // namespace

void say_saved(Lab& lab, std::string_view key, const fs::path& path) {
    if (saves_by_download()) return say_downloaded(lab, "notice.downloaded", path);
    say(lab, {NoticeKind::done, std::string(key), path.string()});
}

// The notice shows the whole path, because the user has not chosen it.
std::optional<Error> write_new(Lab& lab, const fs::path& folder, const std::string& stem, std::string_view extension,
                               std::string_view text, std::string_view key) {
    const fs::path path = free_name(folder, stem, extension);
    if (auto error = write_whole(path, text)) return error;
    say_saved(lab, key, path);
    return std::nullopt;
}

void add_recent_file(StoredState& state, const fs::path& file, const Document& document) {
    add_recent(state, file, title_of(document));
    if (!ships(file)) state.folder = fs::path(state.last_opened).parent_path().string();
}

void execute_file_requests(Lab& lab, FilesView& view, StoredState& state, const UserFolders& folders) {
    const FileCommands commands{lab, view, state, folders};
    for (const Request& request : std::exchange(lab.window.files, {})) {
        if (const auto* open = std::get_if<OpenRequest>(&request))
            commands.open(open->path, open->next_exercise && has_passed(lab), open->dropped, open->resume, open->seed);
        if (const auto* save = std::get_if<SaveRequest>(&request)) commands.save(*save);
        if (const auto* save = std::get_if<SaveExerciseRequest>(&request)) commands.save_exercise(*save);
        if (const auto* files = std::get_if<WriteFilesRequest>(&request)) commands.write_files(*files);
        if (const auto* leave = std::get_if<LeaveRequest>(&request)) commands.leave(leave->answer);
        if (const auto* numbers = std::get_if<ExportRequest>(&request))
            commands.save_numbers(*numbers, folders.pictures);
        if (const auto* students = std::get_if<StudentRequest>(&request)) {
            const fs::path reports = reports_folder(folders.documents);
            if (students->edit == StudentEdit::save)
                commands.save_numbers({"progress", progress_csv(lab.students.all)}, reports);
            if (students->edit == StudentEdit::save_progress) commands.save_progress(reports);
        }
        if (const auto* study = std::get_if<StudyRequest>(&request); study && study->edit == StudyEdit::save)
            commands.save_results(reports_folder(folders.documents));
        if (const auto* browse = std::get_if<BrowseRequest>(&request))
            commands.list(resolved(browse->path, commands.folder(), folders.home));
    }
}

bool has_unsaved_edits(const Lab& lab) {
    if (!has_edits_to_keep(lab)) return false;
    if (const auto& lesson = lab.document.lesson) {
        const Submission now = submission_of(*lesson->exercise, lab.document.session.snapshot());
        return now != as_shipped(*lesson->exercise) && !is_kept(lab, now);
    }
    return lab.document.session.edited_scene() != *lab.document.file;
}

bool may_leave(const Lab& lab, FilesView& view) { return !asks_before(lab, view, {.passed = passed_before(lab)}); }

void follow_file(Lab& lab, FilesView& view) {
    Document& document = lab.document;
    if (lab.pages || document.path.empty() || document.path.extension() == io::run_ending) return;
    const FileMark mark = mark_of(document.path);
    if (mark == document.on_disk) {
        if (document.broken && lab.wall_seconds >= lab.notice_until) say(lab, *document.broken);
        return;
    }
    if (mark == FileMark{}) {
        document.on_disk = mark;
        return say(lab, {NoticeKind::notice, "files.deleted", title_of(document)});
    }
    if (std::exchange(document.noticed, mark) != mark) return;  // it may be incomplete: wait until it stays unchanged
    document.on_disk = mark;
    if (content_of(document.path) == document.content && !document.broken) return;
    // Document::content stays, so that saving asks before it replaces the file.
    if (has_unsaved_edits(lab)) return say(lab, {NoticeKind::notice, "files.changed", title_of(document)});
    auto opened = open_document(document.path, document.session.seed(), document.settings);
    const bool was_broken = document.broken.has_value();
    document.broken.reset();
    if (!opened) {
        if (const auto text = read_text(document.path)) list_errors_for_author(lab, document.path, *text);
        return say(lab, document.broken.emplace(opened.error()));
    }
    document.content = opened->content;
    if (was_broken || !says_the_same(*opened, document)) reload(lab, view, std::move(*opened));
}

void refresh(FilesView& view, const Lab& lab) {
    view.save_to = own_file(lab.document).string();
    view.suggested = lab.document.name;
    view.ships = lab.document.lesson || (!lab.document.path.empty() && ships(lab.document.path));
}

}  // namespace braitenlab
