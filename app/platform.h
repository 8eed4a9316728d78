// The few questions that only the operating system answers. The one place that may differ between systems.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>

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

// Different for any two programs that run at the same time.
long process_number();

// The system's language by its two letters ("de" of LANG=de_AT.UTF-8); empty where it names none.
std::string system_language();

}  // namespace braitenlab
