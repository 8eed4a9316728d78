#include "core/io/run_file.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "core/io/json.h"
#include "core/io/state_json.h"
#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "core/scene/scene_file.h"
#include "core/scene/sealed.h"

namespace braitenlab {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LoggedCommand, tick, command)

namespace io {

namespace {

constexpr int version = 1;
constexpr std::size_t most_commands = 100000;
constexpr int deepest = 32;       // nesting depth of arrays and objects
constexpr double largest = 1e30;  // absolute value of a number; fits in a float

Error refused(const Message& what, const std::string& file) { return error_of(message_of("no_run") + what, file); }

// Parser callback that rejects numbers and nesting depths beyond the limits.
struct Guard {
    Message objection;
    bool operator()(int depth, Json::parse_event_t, const Json& value) {
        if (depth > deepest) objection = message_of("run_too_deep");
        if (value.is_number_float() && !(std::fabs(value.get<double>()) <= largest))
            objection = message_of("run_large_number");
        return objection.text.empty();
    }
};

std::optional<Error> check_log(const Checkpoint& log, const std::string& file) {
    if (log.tick < log.keyframe_tick || log.tick > log.keyframe_tick + keyframe_ticks)
        return refused(message_of("run_moment"), file);
    if (log.commands.size() > most_commands) return refused(message_of("run_many_commands"), file);
    std::uint64_t before = log.keyframe_tick;
    for (const LoggedCommand& c : log.commands) {
        if (c.tick < before || c.tick > log.tick) return refused(message_of("run_command_order"), file);
        before = c.tick;
    }
    return std::nullopt;
}

bool has_hidden_kind(const Scene& scene) {
    return std::any_of(scene.kinds.begin(), scene.kinds.end(), [](const Kind& kind) { return kind.hidden; });
}

bool hides_a_brain(const SavedRun& run) {
    const auto hides = [](const LoggedCommand& logged) {
        const auto* edit = std::get_if<EditKind>(&logged.command);
        return edit && edit->to.hidden;
    };
    const auto& commands = run.checkpoint.commands;
    return has_hidden_kind(run.opened) || has_hidden_kind(*run.checkpoint.keyframe->scene) ||
           std::any_of(commands.begin(), commands.end(), hides);
}

Result<SavedRun> from(const Json& json, const std::string& file) {
    if (!json.is_object() || !json.contains("braitenlab_run")) return refused(message_of("run_other_file"), file);
    if (json.at("braitenlab_run") != version)
        return refused(message_of("run_version", json_text(json.at("braitenlab_run")), version), file);
    SavedRun run;
    json.at("opened").get_to(run.opened);
    if (const auto error = check_scene(run.opened)) return refused(message_of(*error), file);
    auto state = read_state(json.at("keyframe"));
    if (!state) return refused(message_of(state.error()), file);
    run.checkpoint.keyframe_tick = state->tick;
    run.checkpoint.keyframe = std::make_shared<const world::State>(std::move(*state));
    json.at("commands").get_to(run.checkpoint.commands);
    json.at("tick").get_to(run.checkpoint.tick);
    if (auto error = check_log(run.checkpoint, file)) return *error;
    return run;
}

}  // namespace

std::string write_run(const SavedRun& run, Seals seals) {
    const Json json{{"braitenlab_run", version},
                    {"opened", run.opened},
                    {"keyframe", state_json(*run.checkpoint.keyframe)},
                    {"commands", run.checkpoint.commands},
                    {"tick", run.checkpoint.tick}};
    if (seals == Seals::hidden_kinds && !hides_a_brain(run)) return json_text(json) + "\n";
    return json_text(Json{{"braitenlab_run", version}, {"sealed", seal_text(json_text(json))}}) + "\n";
}

void hide_brains(Scene& scene, const std::vector<std::string>& kinds) {
    for (Kind& kind : scene.kinds) kind.hidden |= std::find(kinds.begin(), kinds.end(), kind.name) != kinds.end();
}

void hide_brains(SavedRun& run, const std::vector<std::string>& kinds) {
    if (kinds.empty()) return;
    hide_brains(run.opened, kinds);
    world::State keyframe = *run.checkpoint.keyframe;
    Scene scene = *keyframe.scene;
    hide_brains(scene, kinds);
    keyframe.scene = std::make_shared<const Scene>(std::move(scene));
    run.checkpoint.keyframe = std::make_shared<const world::State>(std::move(keyframe));
    for (LoggedCommand& logged : run.checkpoint.commands)
        if (auto* edit = std::get_if<EditKind>(&logged.command))
            edit->to.hidden |= std::find(kinds.begin(), kinds.end(), edit->to.name) != kinds.end();
}

Result<SavedRun> read_run(std::string_view text, std::string file) {
    if (text.size() > most_run_bytes) return refused(message_of("run_too_large", most_run_bytes >> 20U), file);
    if (const std::string_view format = foreign_format(text); !format.empty() && format != "JSON")
        return refused(message_of("other_file", format), file);
    Guard guard;
    try {
        const Json json = Json::parse(text, std::ref(guard));
        if (!guard.objection.text.empty()) return refused(guard.objection, file);
        if (!json.is_object() || !json.contains("sealed")) return from(json, file);
        const auto unsealed_text = unseal_text(json.at("sealed").get<std::string>());
        if (!unsealed_text) return refused(message_of("sealed_damaged"), file);
        const Json unsealed = Json::parse(*unsealed_text, std::ref(guard));
        if (!guard.objection.text.empty()) return refused(guard.objection, file);
        return from(unsealed, file);
    } catch (const Json::exception& problem) {
        return refused(Message(problem.what()), file);
    }
}

Result<SavedRun> load_run(const std::filesystem::path& path) {
    const auto text = read_text(path, most_run_bytes, "run_too_large");
    return text ? read_run(*text, path.string()) : text.error();
}

}  // namespace io
}  // namespace braitenlab
