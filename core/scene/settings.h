// Settings: values of a scene by their paths, as --set and exercises give them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace braitenlab {

// One value of a scene by its path: "kind.prey.brain.LL=0.5". The value is read as TOML, else taken as text.
struct Setting {
    std::string path, value;
    std::string file = "--set";  // file and line of the setting, for messages
    int line = 0;
};

// Splits at the first '='. Error without one or without a path.
Result<Setting> parse_setting(std::string_view text);

// One value for several paths: "LR=RL=0.8" gives both dials of a brain the value 0.8. Only paths of dials can be
// joined; of another text all after the first '=' is the value.
struct JoinedSetting {
    std::vector<std::string> paths;  // at least one
    std::string value;
};
Result<JoinedSetting> parse_joined_setting(std::string_view text);

// One setting for each path of each text, in their order.
Result<std::vector<Setting>> parse_settings(const std::vector<std::string>& texts);

}  // namespace braitenlab
