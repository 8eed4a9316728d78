// Functions of the operating system. Each system has one source file for this header; no other file of the program
// calls the system. A narrow string of a path is UTF-8 on every system.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace braitenlab {

// Replaces the arguments of main by their UTF-8 texts, and lets standard output take UTF-8 and bytes as they are. Call
// it once, first. The pointers are valid until the program ends.
void use_utf8(int& count, char**& arguments);

// The path of the running program; empty if the system does not provide it.
std::filesystem::path program_file();

// The user's folders. They may not exist; all are empty if there is no home folder.
struct UserFolders {
    std::filesystem::path home;
    std::filesystem::path config;    // for settings: $XDG_CONFIG_HOME/braitenlab or its default
    std::filesystem::path state;     // for what the program stores by itself: $XDG_STATE_HOME/braitenlab or its default
    std::filesystem::path cache;     // for what can be made again: $XDG_CACHE_HOME/braitenlab or its default
    std::filesystem::path pictures;  // as the desktop configures it, else Pictures in the home folder
    std::filesystem::path documents;  // as the desktop configures it, else Documents in the home folder
};
UserFolders user_folders();

// Opens a file for writing binary data; null on failure, with the reason in errno.
std::FILE* open_for_writing(const std::filesystem::path&);

// True if a person reads what is written to the stream.
bool is_terminal(std::FILE*);

// Returns once the content of the file is on the disk. False on failure, with the reason in errno.
bool flush_to_disk(std::FILE*);

// Returns once the names in the folder are on the disk, on file systems that support it.
void flush_folder_to_disk(const std::filesystem::path&);

// A lock on a file, from construction to destruction. The system releases it if the program crashes. In a browser it
// keeps pages of the lab apart: a lock brings what they have written to the file's folder, and its end shows them this
// page's files.
class FileLock {
public:
    explicit FileLock(int handle) : handle_(handle) {}
    FileLock(FileLock&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
    FileLock& operator=(FileLock&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~FileLock();

private:
    int handle_;
};

// Locks a file. Creates the file if it does not exist. nullopt if another process has the lock.
std::optional<FileLock> lock_file(const std::filesystem::path&);

// True once the system has asked the program to end (end of the desktop session, Ctrl+C in the terminal). The first
// call installs the handlers; before it, and after the first such request, the system ends the program at once.
bool is_told_to_end();

// While on, a request to end is also obeyed without is_told_to_end(): 100 ms after it the program ends at once, as by a
// second request. For work of unknown length that writes no file. On Windows, where the system ends a program that does
// not answer, and in a browser it does nothing.
void let_requests_interrupt(bool on);

// Processor time that this thread has used, s: what other threads and programs do does not count.
double thread_time();

// From now on the system ends the program, without a message, once it writes to a pipe without a reader, also where
// the program was started with that signal ignored. Does nothing on systems without such a signal.
void end_at_closed_pipe();

// False in a browser: std::async would wait for its thread without end.
bool has_threads();

// The file of a program that the system finds by its name, as a command line does; empty if there is none.
std::filesystem::path find_program(const std::string& name);

// Opens a file with the program that the system has for its type, without waiting for its end. False if there is none.
// A browser shows an HTML file in a window of its own, which follows the file; false for other files, and if it refuses
// the window.
bool open_with_system(const std::filesystem::path&);

// True in a browser: it downloads what the user saves, and the user does not see the program's folders.
bool saves_by_download();

// True where a page contains that of the program: it may refuse downloads without a word. The program's page then
// offers the text of each file.
bool may_refuse_downloads();

// A running program that reads what is written to it. It is started without a shell: each argument is passed as it is.
class ProgramPipe {
public:
    // nullopt if the program cannot be started. Its output is discarded; its errors are kept for finish().
    static std::optional<ProgramPipe> start(const std::filesystem::path& program,
                                            const std::vector<std::string>& arguments);
    ProgramPipe(ProgramPipe&&) noexcept;
    ProgramPipe& operator=(ProgramPipe&&) = delete;
    ~ProgramPipe();  // ends the program if finish() was not called

    // Waits until the program has taken the bytes. False if it has ended or closed its input.
    bool write(std::string_view bytes);

    // Closes its input and waits for its end. nullopt if it has succeeded, else the last line of its errors.
    std::optional<std::string> finish();

private:
    struct Running;
    explicit ProgramPipe(std::unique_ptr<Running>);
    std::unique_ptr<Running> running_;
};

// The number of this process, unique among all running processes; in a browser among the pages of the lab.
long process_number();

// The system's language by its two letters ("de" of LANG=de_AT.UTF-8); empty if none is set.
std::string system_language();

}  // namespace braitenlab
