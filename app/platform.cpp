#include "app/platform.h"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace braitenlab {

std::filesystem::path program_file() {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none);
}

namespace {

std::filesystem::path folder_of(const char* variable, const char* below_home) {
    const char* value = std::getenv(variable);
    if (const std::filesystem::path xdg(value ? value : ""); xdg.is_absolute()) return xdg / "braitenlab";
    if (const auto home = home_folder(); !home.empty()) return home / below_home / "braitenlab";
    return {};
}

}  // namespace

std::filesystem::path home_folder() {
    const char* home = std::getenv("HOME");
    return home ? home : "";
}

std::filesystem::path config_folder() { return folder_of("XDG_CONFIG_HOME", ".config"); }
std::filesystem::path state_folder() { return folder_of("XDG_STATE_HOME", ".local/state"); }

bool flush_to_disk(std::FILE* file) { return fsync(fileno(file)) == 0; }

void flush_folder_to_disk(const std::filesystem::path& folder) {
    const int opened = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
    if (opened < 0) return;
    fsync(opened);
    close(opened);
}

FileLock::~FileLock() {
    if (handle_ >= 0) close(handle_);
}

std::optional<FileLock> lock_file(const std::filesystem::path& path) {
    const int handle = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (handle < 0) return std::nullopt;
    FileLock lock(handle);
    if (flock(handle, LOCK_EX | LOCK_NB) != 0) return std::nullopt;
    return lock;
}

std::filesystem::path pictures_folder() {
    const auto home = home_folder();
    const char* config = std::getenv("XDG_CONFIG_HOME");
    std::ifstream dirs((config && *config ? std::filesystem::path(config) : home / ".config") / "user-dirs.dirs");
    for (std::string line; std::getline(dirs, line);) {
        constexpr std::string_view key = "XDG_PICTURES_DIR=\"", from_home = "$HOME/";
        if (!line.starts_with(key) || line.back() != '"') continue;
        const std::string value = line.substr(key.size(), line.size() - key.size() - 1);
        if (value.starts_with(from_home)) return home / value.substr(from_home.size());
        if (value.starts_with("/")) return value;
    }
    return home.empty() ? home : home / "Pictures";
}

namespace {

volatile std::sig_atomic_t told_to_end = 0;  // all that a signal's handler may touch

void note_the_end(int signal) {
    told_to_end = 1;
    std::signal(signal, SIG_DFL);
}

}  // namespace

bool is_told_to_end() {
    static const bool listens = [] {
        for (const int signal : {SIGTERM, SIGINT, SIGHUP})
            if (std::signal(signal, note_the_end) == SIG_IGN) std::signal(signal, SIG_IGN);  // nohup stays
        return true;
    }();
    return listens && told_to_end;
}

long process_number() { return getpid(); }

std::string system_language() {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = std::getenv(name);
        if (!value || !*value) continue;
        const std::string_view locale = value;
        const std::string_view code = locale.substr(0, locale.find_first_of("_.@"));
        return code.size() == 2 ? std::string(code) : std::string{};  // "C" and "POSIX" name none
    }
    return {};
}

}  // namespace braitenlab
