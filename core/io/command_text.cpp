#include "core/io/command_text.h"

#include "core/io/json.h"

namespace braitenlab::io {

std::string write_commands(const std::vector<Command>& commands) { return json_text(Json(commands)); }

std::optional<std::vector<Command>> read_commands(std::string_view text) {
    try {
        return Json::parse(text).get<std::vector<Command>>();
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace braitenlab::io
