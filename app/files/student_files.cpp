#include "app/files/student_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "app/files/folder_entries.h"
#include "app/files/safe_file.h"
#include "core/messages.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

constexpr const char* nameless_stem = "this-computer";
constexpr const char* progress_extension = ".json";

std::string progress_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), {}};
}

// Renames the file, so that it is reported once and its text is kept. An earlier broken file is not replaced.
Error keep_aside(const fs::path& path, const Error& error) {
    std::error_code problem;
    fs::path aside = path;
    aside += ".broken";
    for (int i = 2; fs::exists(aside, problem); ++i) aside = path, aside += ".broken" + std::to_string(i);
    fs::rename(path, aside, problem);
    return error_of(message_of(error) + message_of("kept_aside", aside.filename().string()), error.file, error.line);
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
    std::string stem;
    for (const char letter : name) {
        const char lower = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
        const bool plain = (lower >= 'a' && lower <= 'z') || (lower >= '0' && lower <= '9');
        if (plain)
            stem += lower;
        else if (!stem.empty() && stem.back() != '-')
            stem += '-';
    }
    while (!stem.empty() && stem.back() == '-') stem.pop_back();
    return stem.empty() ? "student" : stem;
}

}  // namespace

std::vector<Error> StudentFiles::read(StudentBook& book, const std::string& current) {
    std::vector<Error> errors;
    book = {};
    files_ = {{nameless_stem}};
    if (folder_.empty()) return errors;
    for (const fs::path& path : progress_files(folder_)) {
        auto progress = read_progress(progress_text(path), path.string());
        if (!progress) {
            errors.push_back(keep_aside(path, progress.error()));
            continue;
        }
        const std::string stem = path.stem().string();
        if (stem == nameless_stem) {
            progress->name.clear();
            book.all.front() = files_.front().written = std::move(*progress);
        } else if (is_free_name(book, progress->name) && book.all.size() < most_students) {
            if (stem == current) book.current = book.all.size();
            files_.push_back({stem, *progress}), book.all.push_back(std::move(*progress));
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

std::optional<Error> StudentFiles::write(const StudentBook& book) {
    if (folder_.empty()) return std::nullopt;
    if (files_.empty()) files_ = {{nameless_stem}};
    while (files_.size() < book.all.size()) files_.push_back({free_stem(book.all[files_.size()].name)});
    std::optional<Error> failed;
    for (std::size_t i = 0; i < book.all.size(); ++i) {
        OnDisk& file = files_[i];
        if (file.written == book.all[i]) continue;
        auto error = write_whole(folder_ / (file.stem + progress_extension), write_progress(book.all[i]));
        if (!error) file.written = book.all[i];
        if (error && !file.failed) failed = error;
        file.failed = error.has_value();
    }
    return failed;
}

std::string StudentFiles::current_file(const StudentBook& book) const {
    return book.current > 0 && book.current < files_.size() ? files_[book.current].stem : std::string();
}

}  // namespace braitenlab
