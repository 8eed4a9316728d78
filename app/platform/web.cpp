// A browser or node: one process, no other program, and a file system in memory or on the disk of node.
#include <cstdlib>
#include <ctime>

#include <emscripten/emscripten.h>

#include "app/platform/memory.h"
#include "app/platform/platform.h"

namespace braitenlab {

namespace {

constexpr const char* home = "/home/web_user";  // emscripten's home folder

// Functions of the page (packaging/web/files.js); node has none of them.
// clang-format off
EM_JS(void, take_over_on_page, (const char* folder), { if (Module.takeOver) Module.takeOver(UTF8ToString(folder)); });
EM_JS(void, keep_on_page, (), { if (Module.keepFiles) Module.keepFiles(); });
EM_JS(bool, open_on_page, (const char* path), { return !!Module.openPage && Module.openPage(UTF8ToString(path)); });
EM_JS(bool, is_framed_page, (), { return typeof window === "object" && window.top !== window; });
EM_JS(int, number_of_page, (), { return Module.pageNumber || 1; });
// clang-format on

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

// Pages of the lab share the browser's storage: what others have stored in the folder is read when the lock is taken,
// and what this page has written is stored when the lock is released. Nothing else runs in this page meanwhile, but a
// browser may run another page in these milliseconds.
std::optional<FileLock> lock_file(const std::filesystem::path& path) {
    take_over_on_page(path.parent_path().c_str());
    return FileLock(0);
}

FileLock::~FileLock() {
    if (handle_ >= 0) keep_on_page();
}

bool is_told_to_end() { return false; }

bool is_terminal(std::FILE*) { return false; }

void let_requests_interrupt(bool) {}

double thread_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }  // the only thread

void end_at_closed_pipe() {}

bool has_threads() { return false; }

std::filesystem::path find_program(const std::string&) { return {}; }

bool open_with_system(const std::filesystem::path& path) {
    return path.extension() == ".html" && open_on_page(path.c_str());
}

bool saves_by_download() { return true; }

bool may_refuse_downloads() { return is_framed_page(); }

struct ProgramPipe::Running {};
ProgramPipe::ProgramPipe(ProgramPipe&&) noexcept = default;
ProgramPipe::~ProgramPipe() = default;
std::optional<ProgramPipe> ProgramPipe::start(const std::filesystem::path&, const std::vector<std::string>&) {
    return std::nullopt;
}
bool ProgramPipe::write(std::string_view) { return false; }
std::optional<std::string> ProgramPipe::finish() { return std::string{}; }

long process_number() { return number_of_page(); }

std::string system_language() {
    const char* value = std::getenv("LANG");  // from the language of the browser
    const std::string language = value ? value : "";
    return language.size() >= 2 ? language.substr(0, 2) : std::string{};
}

}  // namespace braitenlab
