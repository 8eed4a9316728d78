#include "core/scene/settings.h"

#include <utility>

#include "core/brain/four_neurons.h"
#include "core/scene/nearest.h"
#include "core/text_parts.h"

namespace braitenlab {

namespace {

bool is_dial_path(std::string_view path) {
    return dial_named(path.substr(path.rfind('.') + 1)).has_value();  // without a point: the whole path
}

}  // namespace

Result<Setting> parse_setting(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0)
        return Error{in_quotes(text) + " is no setting; write PATH=VALUE, like kind.prey.brain.LL=0.5", "--set"};
    return Setting{std::string(trimmed(text.substr(0, equals))), std::string(trimmed(text.substr(equals + 1)))};
}

Result<JoinedSetting> parse_joined_setting(std::string_view text) {
    auto setting = parse_setting(text);
    if (!setting) return setting.error();
    JoinedSetting joined{{std::move(setting->path)}, std::move(setting->value)};
    while (is_dial_path(joined.paths.back())) {
        auto next = parse_setting(joined.value);
        if (!next || !is_dial_path(next->path)) break;
        joined.paths.push_back(std::move(next->path));
        joined.value = std::move(next->value);
    }
    return joined;
}

Result<std::vector<Setting>> parse_settings(const std::vector<std::string>& texts) {
    std::vector<Setting> settings;
    for (const std::string& text : texts) {
        auto joined = parse_joined_setting(text);
        if (!joined) return joined.error();
        for (std::string& path : joined->paths) settings.push_back({std::move(path), joined->value});
    }
    return settings;
}

}  // namespace braitenlab
