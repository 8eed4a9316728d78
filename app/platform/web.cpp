// A browser or node: one process, no other program, and a file system in memory or on the disk of node.
#include <cstdlib>

#include "app/platform/memory.h"
#include "app/platform/platform.h"

namespace braitenlab {

namespace {

constexpr const char* home = "/home/web_user";  // emscripten's home folder

}  // namespace

void use_utf8(int&, char**&) {}

void keep_freed_memory() {}  // a page cannot give memory back

std::filesystem::path program_file() { return {}; }

UserFolders user_folders() {
    const std::filesystem::path folder = home;
    return {.home = folder,
            .config = folder / "config",
            .state = folder / "state",
            .pictures = folder,
            .documents = folder};
}

std::FILE* open_for_writing(const std::filesystem::path& path) { return std::fopen(path.c_str(), "wb"); }

bool flush_to_disk(std::FILE*) { return true; }

void flush_folder_to_disk(const std::filesystem::path&) {}

FileLock::~FileLock() = default;

std::optional<FileLock> lock_file(const std::filesystem::path&) { return FileLock(0); }  // there is no other process

bool is_told_to_end() { return false; }

void end_at_closed_pipe() {}

bool has_threads() { return false; }

std::filesystem::path find_program(const std::string&) { return {}; }

bool open_with_system(const std::filesystem::path&) { return false; }

struct ProgramPipe::Running {};
ProgramPipe::ProgramPipe(ProgramPipe&&) noexcept = default;
ProgramPipe::~ProgramPipe() = default;
std::optional<ProgramPipe> ProgramPipe::start(const std::filesystem::path&, const std::vector<std::string>&) {
    return std::nullopt;
}
bool ProgramPipe::write(std::string_view) { return false; }
std::optional<std::string> ProgramPipe::finish() { return std::string{}; }

long process_number() { return 1; }

std::string system_language() {
    const char* value = std::getenv("LANG");  // from the language of the browser
    const std::string language = value ? value : "";
    return language.size() >= 2 ? language.substr(0, 2) : std::string{};
}

}  // namespace braitenlab
