#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "app/platform/platform.h"

namespace braitenlab {

void use_utf8(int&, char**&) {}  // the terminal's encoding

std::filesystem::path program_file() {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none);
}

namespace {

std::filesystem::path environment_path(const char* variable) {
    const char* value = std::getenv(variable);
    return value ? value : "";
}

std::filesystem::path own_folder(const char* variable, const std::filesystem::path& fallback) {
    if (const auto folder = environment_path(variable); folder.is_absolute()) return folder / "braitenlab";
    return fallback.empty() ? fallback : fallback / "braitenlab";
}

// The folder that the desktop configures under this name, like PICTURES; else `otherwise` in the home folder.
std::filesystem::path desktop_folder(const std::filesystem::path& home, const std::string& name,
                                     const char* otherwise) {
    const auto config = environment_path("XDG_CONFIG_HOME");
    std::ifstream dirs((config.empty() ? home / ".config" : config) / "user-dirs.dirs");
    for (std::string line; std::getline(dirs, line);) {
        const std::string key = "XDG_" + name + "_DIR=\"";
        constexpr std::string_view from_home = "$HOME/";
        if (!line.starts_with(key) || line.back() != '"') continue;
        const std::string value = line.substr(key.size(), line.size() - key.size() - 1);
        if (value.starts_with(from_home)) return home / value.substr(from_home.size());
        if (value.starts_with("/")) return value;
    }
    return home.empty() ? home : home / otherwise;
}

}  // namespace

UserFolders user_folders() {
    UserFolders folders;
    folders.home = environment_path("HOME");
    const bool has_home = !folders.home.empty();
    folders.config = own_folder("XDG_CONFIG_HOME", has_home ? folders.home / ".config" : folders.home);
    folders.state = own_folder("XDG_STATE_HOME", has_home ? folders.home / ".local/state" : folders.home);
    folders.cache = own_folder("XDG_CACHE_HOME", has_home ? folders.home / ".cache" : folders.home);
    folders.pictures = desktop_folder(folders.home, "PICTURES", "Pictures");
    folders.documents = desktop_folder(folders.home, "DOCUMENTS", "Documents");
    return folders;
}

std::FILE* open_for_writing(const std::filesystem::path& path) { return std::fopen(path.c_str(), "wb"); }

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

namespace {

volatile std::sig_atomic_t told_to_end = 0;  // set by the signal handler

void note_end_request(int signal) {
    told_to_end = 1;
    std::signal(signal, SIG_DFL);
}

}  // namespace

bool is_told_to_end() {
    static const bool installed = [] {
        for (const int signal : {SIGTERM, SIGINT, SIGHUP})
            if (std::signal(signal, note_end_request) == SIG_IGN) std::signal(signal, SIG_IGN);  // as under nohup
        return true;
    }();
    return installed && told_to_end;
}

bool has_threads() { return true; }

long process_number() { return getpid(); }

std::string system_language() {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = std::getenv(name);
        if (!value || !*value) continue;
        const std::string_view locale = value;
        const std::string_view code = locale.substr(0, locale.find_first_of("_.@"));
        return code.size() == 2 ? std::string(code) : std::string{};  // not for "C" and "POSIX"
    }
    return {};
}

}  // namespace braitenlab
