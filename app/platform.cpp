#include "app/platform.h"

#include <cstdlib>

namespace braitenlab {

std::filesystem::path program_file() {
    std::error_code none;
    return std::filesystem::read_symlink("/proc/self/exe", none);
}

std::filesystem::path config_folder() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::filesystem::path(value ? value : "");
    };
    if (const auto xdg = variable("XDG_CONFIG_HOME"); xdg.is_absolute()) return xdg / "braitenlab";
    if (const auto home = variable("HOME"); !home.empty()) return home / ".config" / "braitenlab";
    return {};
}

}  // namespace braitenlab
