#include "app/options.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/files/data.h"
#include "app/files/outputs.h"
#include "app/terminal.h"
#include "core/plain_letters.h"
#include "core/scene/enums.h"
#include "core/scene/settings.h"

namespace braitenlab {

namespace {

std::string read_size(const std::string& text, Options& options) {
    int used = 0;
    if (std::sscanf(text.c_str(), "%dx%d%n", &options.width, &options.height, &used) != 2 ||
        used != static_cast<int>(text.size()) || std::min(options.width, options.height) < 100 ||
        std::max(options.width, options.height) > 16384)
        return fmt::format("'{}' is not a size; write it as 1280x800", text);
    options.size_given = true;
    return {};
}

// What only several options together can have wrong.
std::string what_is_wrong(const Options& options) {
    if (options.clip.file.empty() && (options.width < 640 || options.height < 480))
        return fmt::format("--size: {}x{} is too small for a window; the least is 640x480", options.width,
                           options.height);
    if (!options.clip.file.empty() && !options.screenshot.empty()) return "--clip and --screenshot exclude each other";
    return {};
}

std::vector<std::string> camera_modes() {
    std::vector<std::string> modes;
    for (const std::string_view word : camera_mode_words) modes.push_back(with_dashes(word));
    return modes;
}

}  // namespace

std::optional<Error> fault_of_outputs(const Options& options) {
    std::vector<std::filesystem::path> read;
    if (!options.file.empty()) add_with_named_files(options.file, read);
    std::vector<Output> outputs{{"--screenshot", options.screenshot},
                                {"--clip", options.clip.file},
                                {"--anchors", options.anchors, Written::report},
                                {"--state", options.state, Written::report}};
    std::erase_if(outputs, [](const Output& output) { return output.path.empty(); });
    return output_fault(read, outputs);
}

CommandLine read_command_line(int argc, char** argv) {
    CommandLine line;
    Options& o = line.options;
    CLI::App app{"Braitenlab: a lab for Braitenberg vehicles.\nDrag a weight and see character change."};
    app.failure_message([](const CLI::App*, const CLI::Error& error) { return usage_fault(error.what()); });
    app.allow_windows_style_options(false);  // "/" begins a path, on every system
    app.set_version_flag("--version", fmt::format("braitenlab {}", version_text()));
    app.add_option("FILE", o.file,
                   "a scene, an exercise or a lecture: a path, the bare name of a shipped one, or a link in quotes");
    app.add_option_function<std::string>(
           "--size",
           [&](const std::string& text) {
               if (const std::string wrong = read_size(text, o); !wrong.empty())
                   throw CLI::ValidationError("--size", wrong);
           },
           "size in pixels of the window, of --screenshot or of --clip")
        ->type_name("WxH");
    app.add_option("--scale", o.scale,
                   "scale of the window's content; 1 on an ordinary display; less where bars and cards would not fit")
        ->check(CLI::Range(0.5f, 4.0f));
    app.add_option("--seed", o.seed, "seed of the random numbers; the same seed gives the same run")
        ->check(CLI::NonNegativeNumber);
    app.add_option_function<std::vector<std::string>>(
           "--set",
           [&](const std::vector<std::string>& texts) {
               auto settings = parse_settings(texts);
               if (!settings) throw CLI::ValidationError("--set", settings.error().text());
               o.settings.insert(o.settings.end(), settings->begin(), settings->end());
           },
           "one value of the scene, e.g. kind.prey.brain.LL=0.5")
        ->type_name("PATH=VALUE")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--lang", o.language, "language: de, en, es; default: as in the settings, else the system's")
        ->type_name("CODE");
    app.add_flag("--play", o.play, "start playing");
    app.add_flag("--title", o.title, "begin with the title page, as the first start does");
    app.add_flag("--fullscreen", o.full_screen, "fill the screen");
    app.add_flag("--lecture", o.lecture, "large type and few controls, as F9; a lecture file has them anyway");
    app.add_option("--page", o.page, "the page of a lecture to begin with")->type_name("N")->check(CLI::Range(1, 100));
    app.add_option("--revealed", o.revealed, "how many steps of this page are shown already")
        ->type_name("N")
        ->check(CLI::Range(0, 16));
    app.add_flag_callback(
        "--projector", [&] { o.theme = Theme::light; }, "light colours for a projector");
    app.add_option_function<std::string>(
           "--camera",
           [&](const std::string& mode) {
               for (std::size_t i = 0; i < camera_mode_words.size(); ++i)
                   if (mode == with_dashes(camera_mode_words[i])) o.camera = static_cast<CameraMode>(i);
           },
           "camera mode at the start")
        ->type_name("MODE")
        ->check(CLI::IsMember(camera_modes()));
    app.add_option_function<std::string>(
           "--sectors",
           [&](const std::string& way) {
               o.graphics.sectors = way == "geometry"    ? render::SectorPath::geometry
                                    : way == "instanced" ? render::SectorPath::instanced
                                                         : render::SectorPath::automatic;
           },
           "how sensor fields are drawn: by geometry shaders or by instances")
        ->type_name("WAY")
        ->check(CLI::IsMember({"automatic", "geometry", "instanced"}));
    app.add_option_function<std::string>(
           "--quality",
           [&](const std::string& level) {
               o.graphics.has_quality = level != "auto-low";
               for (std::size_t i = 0; i < quality_words.size(); ++i)
                   if (level == quality_words[i]) o.graphics.quality = static_cast<Quality>(i);
               if (level == "auto-low") o.graphics.first_quality = Quality::low;
           },
           "how much work a picture may be; auto: by measured frame time, auto-low: the same, beginning with low "
           "and half the pixels each way; "
           "default: as in the settings, high with --screenshot and --clip")
        ->type_name("LEVEL")
        ->check(CLI::IsMember({"low", "medium", "high", "auto", "auto-low"}));
    app.add_option_function<std::string>(
           "--field",
           [&](const std::string& word) {
               for (const ChannelTraits& channel : channel_table)
                   if (channel.word == word && channel.is_mapped) o.field = channel.value;
               if (!o.field)
                   throw CLI::ValidationError("--field", "'" + word + "' is no channel with a field; try light");
           },
           "show the intensity of this channel on the floor")
        ->type_name("CHANNEL");
    app.add_option("--frame-rate", o.graphics.frame_rate, "most pictures per second, for a slow or remote display")
        ->type_name("N")
        ->check(CLI::Range(5, 1000));
    app.add_flag("--watch-graphics", o.graphics.watch,
                 "let the graphics driver check every call; errors go to the terminal and into --state");
    app.add_option("--screenshot", o.screenshot, "write a picture (PNG) and exit")->type_name("FILE");
    app.add_option("--after", o.after,
                   "when to take it: simulated seconds with --play (one tick a frame), else seconds since the start")
        ->check(CLI::Range(0.0, 3600.0));
    app.add_option("--clip", o.clip.file,
                   "write a clip of the scene and exit; the name ends with .gif or, where ffmpeg is, .mp4 or .webm")
        ->type_name("FILE");
    app.add_option("--from", o.clip.from, "simulated second at which the clip begins")->check(CLI::Range(0.0, 3600.0));
    app.add_option("--to", o.clip.to, "simulated second at which it ends; default: 10 after its beginning")
        ->check(CLI::Range(0.0, 3600.0));
    app.add_option("--anchors", o.anchors, "write the rectangles of the widgets to this file (JSON) while running")
        ->type_name("FILE");
    app.add_option("--state", o.state, "write the state of the lab to this file (JSON) while running")
        ->type_name("FILE");
    try {
        app.parse(argc, argv);
        if (const std::string wrong = what_is_wrong(o); !wrong.empty()) throw CLI::ValidationError(wrong);
        if (app.count("--to") == 0) o.clip.to = o.clip.from + 10;
        if (!o.clip.file.empty() && !o.size_given) o.width = 640, o.height = 400;
    } catch (const CLI::ExtrasError& error) {
        std::cerr << usage_fault(error.what() + nearest_option_of(app, argc, argv));
        line.exit_code = 2;
    } catch (const CLI::ParseError& error) {
        // Help and version answer 0; everything else is bad input.
        line.exit_code = app.exit(error) == 0 ? 0 : 2;
    }
    if (!o.graphics.has_quality && o.only_draws()) o.graphics.has_quality = true, o.graphics.quality = Quality::high;
    return line;
}

}  // namespace braitenlab
