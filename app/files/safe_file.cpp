#include "app/files/safe_file.h"

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/platform/platform.h"
#include "core/maths/fnv.h"
#include "core/messages.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

// `target`: the file behind the links of the path; empty where there is none.
Error not_saved(const fs::path& path, const fs::path& target, int reason) {
    const std::string cause = std::strerror(reason);
    std::error_code none;
    const Message stays = fs::is_regular_file(target, none) ? message_of("old_file_stays") : Message();
    bool is_full = reason == ENOSPC || reason == EFBIG;
#ifdef EDQUOT  // not on every system
    is_full = is_full || reason == EDQUOT;
#endif
    if (is_full) return error_of(message_of("disk_full", cause) + stays, path.string());
    if (reason == EACCES || reason == EPERM || reason == EROFS)
        return error_of(message_of("no_permission", cause) + stays, path.string());
    return error_of(message_of("not_saved", cause) + stays, path.string());
}

// The number of the C library for an error of the file system, which may have the system's own number.
int errno_of(const std::error_code& problem) { return problem.default_error_condition().value(); }

// True in the folders of devices and of the system's own state. /dev/shm is a folder for files of any program.
bool is_of_system(const fs::path& absolute) {
    std::vector<std::string> parts;
    for (const fs::path& part : absolute.parent_path()) parts.push_back(part.string());
    if (parts.size() < 2 || (parts[1] == "dev" && parts.size() > 2 && parts[2] == "shm")) return false;
    return parts[0] == "/" && (parts[1] == "dev" || parts[1] == "proc" || parts[1] == "sys");
}

std::optional<Error> fault_of(const fs::path& wanted, const fs::path& target) {
    std::error_code none;
    if (target.empty()) return not_saved(wanted, {}, ELOOP);
    if (fs::is_directory(target, none)) return not_saved(wanted, {}, EISDIR);
    if (is_of_system(target) || (fs::exists(target, none) && !fs::is_regular_file(target, none)))
        return error_of(message_of("special_file"), wanted.string());
    return std::nullopt;
}

// Makes the folder that a file is written to.
std::optional<Error> make_folder_of(const fs::path& file) {
    if (auto fault = replacement_fault(file)) return fault;
    std::error_code problem;
    fs::create_directories(behind_links(file).parent_path(), problem);
    if (problem) return not_saved(file, {}, errno_of(problem));
    return std::nullopt;
}

// The folders above a path that do not exist, the highest last.
std::vector<fs::path> missing_folders(fs::path folder) {
    std::vector<fs::path> missing;
    std::error_code none;
    for (; !folder.empty() && !fs::exists(folder, none); folder = folder.parent_path()) missing.push_back(folder);
    return missing;
}

std::optional<Error> commit_all(const std::vector<NewFile>& files) {
    std::vector<FileWriter> writers;
    writers.reserve(files.size());
    for (const NewFile& file : files) {
        if (auto error = make_folder_of(file.path)) return error;
        writers.emplace_back(file.path).write(file.text);
        if (auto error = writers.back().complete()) return error;
    }
    for (FileWriter& writer : writers)
        if (auto error = writer.commit()) return error;
    return std::nullopt;
}

}  // namespace

fs::path behind_links(const fs::path& path) {
    constexpr int most_links = 40;
    std::error_code problem;
    fs::path target = fs::absolute(path, problem);
    for (int links = 0; links < most_links; ++links) {
        if (fs::exists(target, problem) || !fs::is_symlink(fs::symlink_status(target, problem))) {
            const fs::path whole = fs::weakly_canonical(target, problem);
            return problem ? target : whole;
        }
        target = target.parent_path() / fs::read_symlink(target, problem);
    }
    return {};
}

std::optional<Error> replacement_fault(const fs::path& path) { return fault_of(path, behind_links(path)); }

FileWriter::FileWriter(const fs::path& path, bool flush) : wanted_(path), path_(behind_links(path)), flush_(flush) {
    error_ = fault_of(wanted_, path_);
    if (error_) return;
    constexpr std::size_t most = 200;  // bytes; a file system allows 255
    std::string name = path_.filename().string();
    if (name.size() > most) name = fmt::format("{:016x}", maths::fnv(name));
    beside_ = path_.parent_path() / fmt::format(".{}.{}.new", name, process_number());
    file_.reset(open_for_writing(beside_));
    if (!file_) fail(errno);
}

FileWriter::~FileWriter() { remove_beside(); }

void FileWriter::remove_beside() {
    if (beside_.empty()) return;
    file_.reset();
    std::error_code none;
    fs::remove(std::exchange(beside_, {}), none);
}

// Aborts: removes the temporary file and stores the first error.
void FileWriter::fail(int reason) {
    error_ = not_saved(wanted_, path_, reason ? reason : EIO);
    remove_beside();
}

void FileWriter::write(std::string_view text) {
    if (!file_) return;
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail(errno);
}

std::optional<Error> FileWriter::complete() {
    if (!file_) return error_;
    errno = 0;
    const bool written = std::fflush(file_.get()) == 0 && (!flush_ || flush_to_disk(file_.get()));
    const int reason = errno;
    if (std::fclose(file_.release()) != 0 || !written) fail(reason);
    return error_;
}

std::optional<Error> FileWriter::commit() {
    if (auto error = complete()) return error;
    std::error_code problem, none;
    if (const auto old = fs::status(path_, none); fs::exists(old)) fs::permissions(beside_, old.permissions(), none);
    fs::rename(beside_, path_, problem);
    if (problem) {
        fail(errno_of(problem));
        return error_;
    }
    beside_.clear();
    if (flush_) flush_folder_to_disk(path_.parent_path());
    return std::nullopt;
}

std::optional<Error> write_all(const std::vector<NewFile>& files) {
    std::vector<fs::path> made;
    for (const NewFile& file : files)
        for (const fs::path& folder : missing_folders(behind_links(file.path).parent_path())) made.push_back(folder);
    auto error = commit_all(files);
    std::error_code none;
    for (const fs::path& folder : made)
        if (error) fs::remove(folder, none);  // only one that is empty
    return error;
}

std::optional<Error> write_whole(const fs::path& path, std::string_view text) {
    if (auto error = make_folder_of(path)) return error;
    FileWriter writer(path);
    writer.write(text);
    return writer.commit();
}

std::optional<fs::path> set_aside(const fs::path& path) {
    std::error_code problem;
    fs::path aside = path;
    aside += ".broken";
    for (int i = 2; fs::exists(aside, problem); ++i) aside = path, aside += ".broken" + std::to_string(i);
    fs::rename(path, aside, problem);
    return problem ? std::nullopt : std::optional(aside);
}

std::filesystem::path free_name(const std::filesystem::path& folder, std::string_view stem,
                                std::string_view extension) {
    std::error_code none;
    for (int i = 1;; ++i)
        if (auto path = folder / fmt::format("{}-{:03}{}", stem, i, extension); !std::filesystem::exists(path, none))
            return path;
}

}  // namespace braitenlab
