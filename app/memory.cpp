#include "app/memory.h"

#include <tuple>
#include <utility>

#include "app/platform.h"

namespace braitenlab {

Memory recall(const Options& options, const std::string& native_language) {
    const bool picture = !options.screenshot.empty();
    Memory memory{.files = picture ? SettingsFiles({}, {}) : SettingsFiles(config_folder(), state_folder())};
    memory.stored.language = native_language;
    memory.complaints = memory.files.read(memory.stored, memory.remembered);
    memory.preferences = memory.stored;
    if (options.theme) memory.preferences.theme = *options.theme;
    if (!options.language.empty()) memory.preferences.language = options.language;
    memory.seen = memory.preferences;
    return memory;
}

std::optional<Error> keep(Memory& memory, const Preferences& now, std::pair<int, int> window_size) {
    const Preferences before = std::exchange(memory.seen, now);
    Preferences& stored = memory.stored;
    if (now.theme != before.theme) stored.theme = now.theme;
    if (now.language != before.language) stored.language = now.language;
    if (now.type_size != before.type_size) stored.type_size = now.type_size;
    if (now.reduce_motion != before.reduce_motion) stored.reduce_motion = now.reduce_motion;
    std::tie(memory.remembered.width, memory.remembered.height) = window_size;
    return memory.files.write(stored, memory.remembered);
}

std::pair<int, int> size_of(const Options& options, const Remembered& remembered) {
    if (options.size_given || remembered.width == 0) return {options.width, options.height};
    return {remembered.width, remembered.height};
}

}  // namespace braitenlab
