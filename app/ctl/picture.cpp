// braitenctl picture: the wiring of a brain and the paths of a run as SVG files.
#include <cmath>
#include <string>

#include "app/ctl/ctl.h"
#include "app/files/safe_file.h"
#include "app/reports/brain_drawing.h"
#include "app/reports/paths_file.h"
#include "core/lesson/exercise_file.h"
#include "core/session/session.h"

namespace braitenlab {

namespace {

std::optional<Error> write_wiring(const PictureOptions& options, const Strings& strings) {
    const auto found = brain_of_file(options.file, options.choice);
    if (!found) return found.error();
    const std::string heading = found->owner.empty() ? options.file : options.file + ": " + found->owner;
    return write_whole(options.wiring, brain_file(found->brain, found->sensors, heading, strings));
}

std::optional<Error> write_paths(const PictureOptions& options) {
    const auto scene = read_scene_with(options.file, options.settings, "picture --paths", "a scene");
    if (!scene) return scene.error();
    const auto strings = strings_with(options.language, texts_of(*scene));
    if (!strings) return strings.error();
    const auto session = Session::open(*scene, options.seed);
    if (!session) return session.error();
    const auto to = static_cast<std::uint64_t>(std::llround(options.seconds * 60));
    return write_whole(options.paths,
                       paths_file(session->recording(), 0, to, strings->find(scene->title, scene->title), *strings));
}

}  // namespace

int picture(const PictureOptions& options) {
    if (options.wiring.empty() && options.paths.empty())
        return complain({"nothing to draw; give --wiring FILE, --paths FILE, or both", "picture"});
    if (const auto error = ending_fault("--wiring", options.wiring, ".svg")) return complain(*error);
    if (const auto error = ending_fault("--paths", options.paths, ".svg")) return complain(*error);
    const auto strings = strings_of(options.language);
    if (!strings) return complain(strings.error());
    if (!options.wiring.empty())
        if (const auto error = write_wiring(options, *strings)) return complain(*error);
    if (!options.paths.empty())
        if (const auto error = write_paths(options)) return complain(*error);
    return exit_code::done;
}

}  // namespace braitenlab
