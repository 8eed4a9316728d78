#include "app/safe_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

#include "app/platform.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

Error refused(const fs::path& path, int reason) {
    std::string advice = "choose another place";
    if (reason == ENOSPC || reason == EDQUOT || reason == EFBIG)
        advice = "make room on the disk or choose another place";
    if (reason == EACCES || reason == EPERM || reason == EROFS) advice = "choose a folder that you may write to";
    return {
        fmt::format("could not be saved: {}; {}. What was there before still stands", std::strerror(reason), advice),
        path.string()};
}

// The file that a link leads to, so that the link stays one; the path itself where there is none.
fs::path behind_links(const fs::path& path) {
    std::error_code problem;
    const fs::path target = fs::weakly_canonical(path, problem);
    return problem ? path : target;
}

// Writes and flushes to the disk; the reason it did not work, or 0.
int write_through(const fs::path& path, std::string_view text) {
    std::FILE* file = std::fopen(path.string().c_str(), "wb");
    if (!file) return errno;
    errno = 0;
    bool good = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    good = good && std::fflush(file) == 0 && flush_to_disk(file);
    const int reason = errno;
    const bool closed = std::fclose(file) == 0;
    if (good && closed) return 0;
    return reason ? reason : EIO;
}

}  // namespace

std::optional<Error> write_whole(const fs::path& wanted, std::string_view text) {
    const fs::path path = behind_links(wanted);
    const fs::path beside = path.parent_path() / fmt::format(".{}.{}.new", path.filename().string(), process_number());
    std::error_code problem, none;
    if (!path.parent_path().empty()) fs::create_directories(path.parent_path(), problem);
    if (problem) return refused(wanted, problem.value());
    if (fs::is_directory(path, none)) return refused(wanted, EISDIR);
    if (fs::exists(path, none) && !fs::is_regular_file(path, none))
        return Error{"is no plain file and stays as it is; choose another name", wanted.string()};
    if (const int reason = write_through(beside, text)) {
        fs::remove(beside, none);
        return refused(wanted, reason);
    }
    if (const auto old = fs::status(path, none); fs::exists(old)) fs::permissions(beside, old.permissions(), none);
    fs::rename(beside, path, problem);
    if (problem) {
        fs::remove(beside, none);
        return refused(wanted, problem.value());
    }
    flush_folder_to_disk(path.parent_path());
    return std::nullopt;
}

}  // namespace braitenlab
