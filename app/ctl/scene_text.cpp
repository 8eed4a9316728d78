// The text of a scene's file for the commands that run scenes.
#include <algorithm>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/files/data.h"
#include "core/io/run_file.h"
#include "core/scene/file_kind.h"
#include "core/scene/scene_file.h"
#include "core/scene/settings.h"

namespace braitenlab {

Result<std::string> read_scene_text(const std::filesystem::path& path, std::string_view command,
                                    std::string_view takes) {
    auto text = read_text(path);
    if (!text) return text;
    const auto other = [&](std::string_view kind, std::string_view advice) {
        return Error{fmt::format("this is {}, and '{}' takes {}; {}", kind, command, takes, advice), path.string()};
    };
    switch (detect_kind(path, *text)) {
        case FileKind::exercise:
            return other("an exercise",
                         "use 'check' to test the exercise, 'grade' for a brain or hand-ins, 'show' to print it");
        case FileKind::lecture:
            return other("a lecture", "use 'check' to test the lecture");
        case FileKind::study:
            return other("a study", "use 'study' to run it");
        case FileKind::breeding:
            return other("a breeding", "use 'breed' to run it");
        case FileKind::brain:
            return other("a brain alone", "use 'grade EXERCISE FILE'");
        default:
            return text;
    }
}

Result<Scene> read_scene_with(const std::string& file, const std::vector<std::string>& arguments,
                              std::string_view command, std::string_view takes) {
    if (file.ends_with(io::run_ending))
        return Error{fmt::format("this is a saved run, and '{}' takes {}", command, takes), file};
    const auto path = find_shipped(file);
    if (!path) return path.error();
    const auto text = read_scene_text(*path, command, takes);
    if (!text) return text.error();
    const auto settings = parse_settings(arguments);
    if (!settings) return settings.error();
    return parse_scene(*text, path->string(), *settings);
}

Result<VehicleId> vehicle_at_start(const Snapshot& start, const std::string& name, const std::string& file) {
    if (start.vehicles.empty()) return Error{"the scene has no vehicle", file};
    if (name.empty()) return start.vehicles.front().id;
    const std::vector<std::string_view> names = known_names(start.scene->starts);
    const auto found = std::find(names.begin(), names.end(), name);
    const auto with_start = std::find_if(start.vehicles.begin(), start.vehicles.end(), [&](const VehicleView& each) {
        return found != names.end() && each.start == found - names.begin();
    });
    if (with_start == start.vehicles.end())
        return Error{"the scene has no vehicle " + in_quotes(name) + name_nearest(name, names), "--vehicle"};
    return with_start->id;
}

}  // namespace braitenlab
