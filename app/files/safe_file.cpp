#include "app/files/safe_file.h"

#include <cerrno>
#include <cstring>
#include <system_error>

#include <fmt/format.h>

#include "app/platform/platform.h"
#include "core/messages.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

Error not_saved(const fs::path& path, int reason) {
    const std::string cause = std::strerror(reason);
    bool is_full = reason == ENOSPC || reason == EFBIG;
#ifdef EDQUOT  // not on every system
    is_full = is_full || reason == EDQUOT;
#endif
    if (is_full) return error_of(message_of("disk_full", cause), path.string());
    if (reason == EACCES || reason == EPERM || reason == EROFS)
        return error_of(message_of("no_permission", cause), path.string());
    return error_of(message_of("not_saved", cause), path.string());
}

// The number of the C library for an error of the file system, which may have the system's own number.
int errno_of(const std::error_code& problem) { return problem.default_error_condition().value(); }

// The target of a link, so that the link itself is not replaced.
fs::path behind_links(const fs::path& path) {
    std::error_code problem;
    const fs::path target = fs::weakly_canonical(path, problem);
    return problem ? path : target;
}

}  // namespace

FileWriter::FileWriter(const fs::path& path, bool flush) : wanted_(path), path_(behind_links(path)), flush_(flush) {
    std::error_code none;
    if (fs::is_directory(path_, none)) {
        fail(EISDIR);
        return;
    }
    if (fs::exists(path_, none) && !fs::is_regular_file(path_, none)) {
        error_ = error_of(message_of("special_file"), wanted_.string());
        return;
    }
    beside_ = path_.parent_path() / fmt::format(".{}.{}.new", path_.filename().string(), process_number());
    file_.reset(open_for_writing(beside_));
    if (!file_) fail(errno);
}

FileWriter::~FileWriter() {
    if (!file_) return;
    file_.reset();
    std::error_code none;
    fs::remove(beside_, none);
}

// Aborts: removes the temporary file and stores the first error.
void FileWriter::fail(int reason) {
    error_ = not_saved(wanted_, reason ? reason : EIO);
    if (!file_) return;
    file_.reset();
    std::error_code none;
    fs::remove(beside_, none);
}

void FileWriter::write(std::string_view text) {
    if (!file_) return;
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) fail(errno);
}

std::optional<Error> FileWriter::commit() {
    if (!file_) return error_;
    errno = 0;
    const bool written = std::fflush(file_.get()) == 0 && (!flush_ || flush_to_disk(file_.get()));
    const int reason = errno;
    const bool closed = std::fclose(file_.release()) == 0;
    std::error_code problem, none;
    if (written && closed) {
        if (const auto old = fs::status(path_, none); fs::exists(old))
            fs::permissions(beside_, old.permissions(), none);
        fs::rename(beside_, path_, problem);
    }
    if (!written || !closed || problem) {
        fs::remove(beside_, none);
        const int code = problem ? errno_of(problem) : reason;
        return not_saved(wanted_, code ? code : EIO);
    }
    if (flush_) flush_folder_to_disk(path_.parent_path());
    return std::nullopt;
}

std::optional<Error> write_whole(const fs::path& path, std::string_view text) {
    const fs::path folder = behind_links(path).parent_path();
    std::error_code problem;
    if (!folder.empty()) fs::create_directories(folder, problem);
    if (problem) return not_saved(path, errno_of(problem));
    FileWriter writer(path);
    writer.write(text);
    return writer.commit();
}

}  // namespace braitenlab
