// The few questions that only the operating system answers. The one place that may differ between systems.
#pragma once

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace braitenlab {

// The running program's own file; empty where the system does not tell.
std::filesystem::path program_file();

// Where a person's own settings go ($XDG_CONFIG_HOME/braitenlab or its default), and where the lab keeps what it
// remembers by itself ($XDG_STATE_HOME/braitenlab); not made until written to. Empty when there is no home.
std::filesystem::path config_folder();
std::filesystem::path state_folder();

// A person's home; empty when there is none.
std::filesystem::path home_folder();

// Returns when what was written to the file is on the disk; false, with errno, when it is not.
bool flush_to_disk(std::FILE*);
// The same for the names in a folder. Not every file system can: then it is left to chance.
void flush_folder_to_disk(const std::filesystem::path&);

// Held for as long as it lives, and by nobody else meanwhile; the system lets it go when its holder crashes.
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
// The lock of a file, which is made where it is missing; nothing where another holds it.
std::optional<FileLock> lock_file(const std::filesystem::path&);

// Where a person keeps pictures: as their desktop says, else a folder Pictures at home. Empty when there is no home.
std::filesystem::path pictures_folder();

// From the first call on, the system's wish that the program end (logging out, Ctrl+C in its terminal) is noted instead
// of obeyed at once; a second one ends it.
bool is_told_to_end();

// Different for any two programs that run at the same time.
long process_number();

// The system's language by its two letters ("de" of LANG=de_AT.UTF-8); empty where it names none.
std::string system_language();

}  // namespace braitenlab
