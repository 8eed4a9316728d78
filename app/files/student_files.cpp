#include "app/files/student_files.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <system_error>
#include <thread>
#include <utility>

#include "app/files/safe_file.h"
#include "core/lesson/hand_in.h"
#include "core/messages.h"
#include "core/plain_letters.h"
#include "core/scene/file_kind.h"
#include "core/scene/folder_entries.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

constexpr const char* nameless_stem = "this-computer";
constexpr const char* progress_extension = ".json";
constexpr std::uintmax_t most_bytes = 64U << 20U;  // of a student; a brain has at most 1 MB

// Fails as read_text() and read_progress().
Result<StudentProgress> progress_in(const Result<std::string>& text, const fs::path& path) {
    return text ? read_progress(*text, path.string()) : text.error();
}

Result<std::string> progress_text(const fs::path& path) { return read_text(path, most_bytes, "too_large"); }

Error keep_aside(const fs::path& path, const Error& error) {
    const auto aside = set_aside(path);
    const Message kept = aside ? message_of("kept_aside", aside->filename().string()) : message_of("not_kept_aside");
    return error_of(message_of(error) + kept, error.file, error.line);
}

std::vector<fs::path> progress_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for_each_entry(folder, [&](const fs::directory_entry& entry) {
        if (entry.path().extension() == progress_extension) files.push_back(entry.path());
    });
    std::sort(files.begin(), files.end());
    return files;
}

// Lower-case ASCII letters, digits and '-'; never empty.
std::string stem_of(const std::string& name) {
    const std::string stem = with_dashes(name);
    return stem.empty() ? "student" : stem;
}

}  // namespace

// Why the file of a further student is not used; nullopt if it is.
std::optional<Error> StudentFiles::unused(const fs::path& path, const StudentProgress& progress,
                                          const StudentBook& book) const {
    if (progress.name.empty()) return error_of(message_of("student_without_name"), path.string());
    for (std::size_t i = 1; i < book.all.size(); ++i)
        if (is_same_student(book.all[i].name, progress.name))
            return error_of(message_of("student_twice", progress.name, path_of(files_[i]).filename().string()),
                            path.string());
    if (book.all.size() >= most_students)
        return error_of(message_of("too_many_students", most_students), path.string());
    return std::nullopt;
}

std::vector<Error> StudentFiles::read(StudentBook& book, const std::string& current) {
    std::vector<Error> errors;
    book = {};
    files_ = {{nameless_stem}};
    unused_.clear();
    if (folder_.empty()) return errors;
    for (const fs::path& path : progress_files(folder_)) {
        auto text = progress_text(path);
        auto progress = progress_in(text, path);
        if (!progress) {
            errors.push_back(keep_aside(path, progress.error()));
            continue;
        }
        const std::string stem = path.stem().string();
        if (stem == nameless_stem) {
            progress->name.clear();
            book.all.front() = files_.front().written = std::move(*progress);
            files_.front().text = std::move(*text);
        } else if (auto error = unused(path, *progress, book)) {
            errors.push_back(std::move(*error)), unused_.push_back(stem);
        } else {
            if (stem == current) book.current = book.all.size();
            files_.push_back({stem, *progress, std::move(*text)}), book.all.push_back(std::move(*progress));
        }
    }
    return errors;
}

std::string StudentFiles::free_stem(const std::string& name) const {
    const std::string wanted = stem_of(name);
    std::error_code none;
    const auto is_taken = [&](const std::string& stem) {
        return std::any_of(files_.begin(), files_.end(), [&](const OnDisk& each) { return each.stem == stem; }) ||
               fs::exists(folder_ / (stem + progress_extension), none);
    };
    std::string stem = wanted;
    for (int i = 2; is_taken(stem); ++i) stem = wanted + "-" + std::to_string(i);
    return stem;
}

// The file of a student who was added: one that another window has written, else a new one.
std::string StudentFiles::stem_for(const std::string& name) const {
    for (const fs::path& path : progress_files(folder_)) {
        std::string stem = path.stem().string();
        const bool is_ours =
            std::any_of(files_.begin(), files_.end(), [&](const OnDisk& each) { return each.stem == stem; });
        if (is_ours || stem == nameless_stem) continue;
        const auto progress = progress_in(progress_text(path), path);
        if (progress && is_same_student(progress->name, name)) return stem;
    }
    return free_stem(name);
}

// The lock that windows hold while they write; nullopt if it cannot be had within 0.1 s.
std::optional<FileLock> StudentFiles::locked() const {
    std::error_code none;  // write_whole() reports it
    fs::create_directories(folder_, none);
    const fs::path path = folder_ / ".lock";
    for (int attempt = 0; attempt < 20; ++attempt) {
        if (auto lock = lock_file(path)) return lock;
        if (!fs::exists(path, none)) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return std::nullopt;
}

// Differs after each change, but for one of the same size within the resolution of the file's time.
std::pair<fs::file_time_type, std::uintmax_t> StudentFiles::stamp_of(const OnDisk& file) const {
    std::error_code none;
    const fs::path path = path_of(file);
    if (!fs::exists(path, none)) return {};
    return {fs::last_write_time(path, none), fs::file_size(path, none)};
}

// Takes over what another window has written to the file. Fails if the file cannot be read and not be renamed.
std::optional<Error> StudentFiles::merge(OnDisk& file, StudentProgress& progress, Written& done) const {
    const fs::path path = path_of(file);
    std::error_code none;
    file.stamp = stamp_of(file);
    if (!fs::exists(path, none)) return std::nullopt;
    const auto text = progress_text(path);
    if (text && *text == file.text) return std::nullopt;
    auto found = progress_in(text, path);
    if (!found) {
        const Error error = keep_aside(path, found.error());
        if (fs::exists(path, none)) return error;
        done.failed = error;
        return std::nullopt;
    }
    if (file.stem == nameless_stem) found->name.clear();
    StudentProgress both = merged_progress(file.written, progress, *found);
    done.merged = done.merged || both != progress;
    progress = std::move(both);
    file.written = std::move(*found), file.text = *text;
    return std::nullopt;
}

std::optional<Error> StudentFiles::write(OnDisk& file, StudentProgress& progress, Written& done) const {
    if (auto error = merge(file, progress, done)) return error;
    std::string text = write_progress(progress);
    if (auto error = write_whole(path_of(file), text)) return error;
    file.written = progress, file.text = std::move(text), file.stamp = stamp_of(file);
    return std::nullopt;
}

// True if the book goes on with a student whom another window has added.
bool StudentFiles::follow_name(StudentBook& book) {
    if (book.current > 0 || files_.size() != book.all.size()) return false;
    for (const fs::path& path : progress_files(folder_)) {
        const std::string stem = path.stem().string();
        const bool is_known =
            std::any_of(files_.begin(), files_.end(), [&](const OnDisk& each) { return each.stem == stem; }) ||
            std::find(unused_.begin(), unused_.end(), stem) != unused_.end();
        if (is_known) continue;
        auto text = progress_text(path);
        auto progress = progress_in(text, path);
        if (!progress || unused(path, *progress, book)) {
            unused_.push_back(stem);
            continue;
        }
        files_.push_back({stem, *progress, std::move(*text)});
        book.all.push_back(std::move(*progress));
        book.current = book.all.size() - 1, book.before_reset.reset();
        return true;
    }
    return false;
}

StudentFiles::Written StudentFiles::write(StudentBook& book) {
    Written done;
    if (folder_.empty()) return done;
    done.merged = !files_.empty() && follow_name(book);
    if (files_.empty()) files_ = {{nameless_stem}};
    bool changed = files_.size() < book.all.size();
    for (std::size_t i = 0; i < files_.size() && i < book.all.size(); ++i)
        changed = changed || files_[i].written != book.all[i] || files_[i].stamp != stamp_of(files_[i]);
    if (!changed) return done;
    const auto lock = locked();
    while (files_.size() < book.all.size()) files_.push_back({stem_for(book.all[files_.size()].name)});
    for (std::size_t i = 0; i < book.all.size(); ++i) {
        OnDisk& file = files_[i];
        const bool differs = file.written != book.all[i];
        if (!differs && file.stamp == stamp_of(file)) continue;
        const auto error = differs ? write(file, book.all[i], done) : merge(file, book.all[i], done);
        if (error && !file.failed) done.failed = error;
        file.failed = error.has_value();
    }
    return done;
}

std::string StudentFiles::current_file(const StudentBook& book) const {
    return book.current > 0 && book.current < files_.size() ? files_[book.current].stem : std::string();
}

}  // namespace braitenlab
