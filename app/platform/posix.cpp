#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string_view>

#include <fcntl.h>
#include <spawn.h>
#include <sys/file.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>
#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include "app/platform/memory.h"
#include "app/platform/platform.h"

namespace braitenlab {

void use_utf8(int&, char**&) {}  // the terminal's encoding

void keep_freed_memory() {
#ifdef M_TRIM_THRESHOLD                                           // glibc
    constexpr int most_kept = 32 << 20, largest_block = 4 << 20;  // bytes
    mallopt(M_TRIM_THRESHOLD, most_kept);
    mallopt(M_MMAP_THRESHOLD, largest_block);  // the first call ends its adjustment to what the program frees
#endif
}

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

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) != 0; }

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

volatile std::sig_atomic_t told_to_end = 0;  // the signal, set by its handler
volatile std::sig_atomic_t may_interrupt = 0;

void end_unanswered(int) {
    if (may_interrupt) raise(told_to_end);  // its action is the default one
}

void start_alarm(int milliseconds) {
    constexpr int again = 10;  // ms; the work may begin later
    const itimerval timer{{0, again * 1000}, {0, milliseconds * 1000}};
    setitimer(ITIMER_REAL, &timer, nullptr);
}

void note_end_request(int signal) {
    constexpr int patience = 100;  // ms
    told_to_end = signal;
    std::signal(signal, SIG_DFL);
    std::signal(SIGALRM, end_unanswered);
    start_alarm(patience);
}

}  // namespace

bool is_told_to_end() {
    static const bool installed = [] {
        for (const int signal : {SIGTERM, SIGINT, SIGHUP})
            if (std::signal(signal, note_end_request) == SIG_IGN) std::signal(signal, SIG_IGN);  // as under nohup
        return true;
    }();
    if (told_to_end) start_alarm(0);  // none
    return installed && told_to_end;
}

void let_requests_interrupt(bool on) { may_interrupt = on; }

double thread_time() {
    timespec used{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + static_cast<double>(used.tv_nsec) * 1e-9;
}

void end_at_closed_pipe() { std::signal(SIGPIPE, SIG_DFL); }

bool has_threads() { return true; }

bool saves_by_download() { return false; }

bool may_refuse_downloads() { return false; }

std::filesystem::path find_program(const std::string& name) {
    const std::string folders = environment_path("PATH").string();
    for (std::size_t from = 0; from <= folders.size();) {
        const std::size_t end = std::min(folders.find(':', from), folders.size());
        std::filesystem::path file = std::filesystem::path(folders.substr(from, end - from)) / name;
        std::error_code none;
        if (std::filesystem::is_regular_file(file, none) && access(file.c_str(), X_OK) == 0) return file;
        from = end + 1;
    }
    return {};
}

bool open_with_system(const std::filesystem::path& file) {
    const std::filesystem::path opener = find_program("xdg-open");
    if (opener.empty()) return false;
    // A child starts the program and ends soon, so that the program has no parent that must wait for it. An opener that
    // finds no program fails within this time; one that still runs shows the file.
    constexpr int looks = 50;
    constexpr timespec between_looks{0, 20'000'000};  // 20 ms
    std::string program = opener.string(), argument = file.string();
    std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
    const pid_t child = fork();
    if (child < 0) return false;
    if (child == 0) {
        setsid();
        pid_t opened = -1;
        if (posix_spawn(&opened, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0) _exit(1);
        int status = 0;
        pid_t ended = 0;
        for (int i = 0; i < looks && ended == 0; ++i) {
            nanosleep(&between_looks, nullptr);
            ended = waitpid(opened, &status, WNOHANG);
        }
        _exit(ended == opened && status != 0 ? 1 : 0);
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

struct ProgramPipe::Running {
    pid_t process = -1;  // −1: has ended
    int input = -1;      // −1: closed
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> errors{std::tmpfile(), std::fclose};

    void close_input() {
        if (input >= 0) close(input);
        input = -1;
    }
    // The status as waitpid() returns it.
    int wait_for_end() {
        int status = 0;
        while (process > 0 && waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
        process = -1;
        return status;
    }
    std::string last_line() const {
        if (!errors) return {};
        std::rewind(errors.get());
        std::string line, last;
        for (int c = 0; (c = std::fgetc(errors.get())) != EOF;) {
            if (c != '\n')
                line += static_cast<char>(c);
            else if (!line.empty())
                last = std::exchange(line, {});
        }
        return line.empty() ? last : line;
    }
};

ProgramPipe::ProgramPipe(std::unique_ptr<Running> running) : running_(std::move(running)) {}
ProgramPipe::ProgramPipe(ProgramPipe&&) noexcept = default;

std::optional<ProgramPipe> ProgramPipe::start(const std::filesystem::path& program,
                                              const std::vector<std::string>& arguments) {
    auto running = std::make_unique<Running>();
    std::array<int, 2> pipe_ends{};
    if (!running->errors || pipe2(pipe_ends.data(), O_CLOEXEC) != 0) return std::nullopt;
    running->input = pipe_ends[1];
    std::vector<std::string> texts{program.string()};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe_ends[0], STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, fileno(running->errors.get()), STDERR_FILENO);
    const int problem = posix_spawn(&running->process, program.c_str(), &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(pipe_ends[0]);
    if (problem != 0) {
        running->process = -1;
        running->close_input();
        return std::nullopt;
    }
    std::signal(SIGPIPE, SIG_IGN);  // write() returns an error instead
    return ProgramPipe(std::move(running));
}

ProgramPipe::~ProgramPipe() {
    if (!running_) return;
    running_->close_input();
    if (running_->process > 0) kill(running_->process, SIGKILL);
    running_->wait_for_end();
}

bool ProgramPipe::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t taken = ::write(running_->input, bytes.data(), bytes.size());
        if (taken < 0 && errno == EINTR) continue;
        if (taken <= 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(taken));
    }
    return true;
}

std::optional<std::string> ProgramPipe::finish() {
    running_->close_input();
    const int status = running_->wait_for_end();
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return std::nullopt;
    return running_->last_line();
}

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
