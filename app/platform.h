// The few questions that only the operating system answers. The one place that may differ between systems.
#pragma once

#include <filesystem>
#include <string>

namespace braitenlab {

// The running program's own file; empty where the system does not tell.
std::filesystem::path program_file();

// Where a person's own settings go ($XDG_CONFIG_HOME/braitenlab or its default); not made until written to. Empty when
// there is no home.
std::filesystem::path config_folder();

// The system's language by its two letters ("de" of LANG=de_AT.UTF-8); empty where it names none.
std::string system_language();

}  // namespace braitenlab
