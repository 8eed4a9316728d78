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
