// Settings as they are typed: "kind.prey.brain.LL=0.5".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

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
