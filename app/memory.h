// What this start took over from earlier ones and from the command line, and what of it is kept for the next.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/options.h"
#include "app/settings.h"

namespace braitenlab {

struct Memory {
    SettingsFiles files;
    Preferences stored;       // as the file has them
    Preferences preferences;  // as this session began: the command line comes first
    Preferences seen;         // when something was kept last
    Remembered remembered;
    std::vector<Error> complaints;  // about files that could not be read
};

// A picture asked for by --screenshot depends on its command line alone: nothing is read then.
Memory recall(const Options&, const std::string& native_language);

// Writes what has changed. What only the command line said is not taken for a choice.
std::optional<Error> keep(Memory&, const Preferences& now, std::pair<int, int> window_size);

// Width and height of the window: as asked for, else as it was last, else as usual.
std::pair<int, int> size_of(const Options&, const Remembered&);

}  // namespace braitenlab
