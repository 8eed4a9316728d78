// The command line of the window.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/lecture.h"
#include "core/result.h"
#include "core/scene/scene_file.h"
#include "render/gl/renderer.h"
#include "render/view/camera.h"
#include "render/view/palette.h"
#include "render/view/picture.h"

namespace braitenlab {

struct GraphicsOptions {
    render::SectorPath sectors = render::SectorPath::automatic;
    bool has_quality = false;                 // false: as in the settings
    std::optional<Quality> quality;           // with has_quality; nullopt: chosen by measured frame time
    Quality first_quality = Quality::medium;  // of the measured ones
    bool watch = false;                       // reports errors of OpenGL
    int frame_rate = 0;                       // most pictures per second; 0: those of the display
};

struct ClipOptions {
    std::filesystem::path file;  // written at once; then the program ends. Empty: none
    double from = 0, to = 10;    // simulated s
};

struct Options {
    std::string file;                // empty: the last file, else the first exercise
    int width = 1280, height = 800;  // window pixels
    bool size_given = false;
    std::optional<float> scale;  // window pixels per layout pixel; unset: the display's
    std::optional<std::uint64_t> seed;
    std::vector<Setting> settings;
    bool play = false, full_screen = false;
    bool title = false;                    // begins with the title page, as the first start does
    bool lecture = false;                  // large type and few controls from the start
    int page = 1, revealed = 0;            // of a lecture file: the page, and how many of its steps are shown
    std::shared_ptr<const Lecture> pages;  // set if FILE is a lecture
    std::optional<Theme> theme;            // unset: as in the settings
    std::optional<CameraMode> camera;      // unset: as stored
    std::optional<Channel> field;          // its intensity is shown on the floor at the start
    std::string language;                  // its code, as "de"; empty: as in the settings
    std::filesystem::path screenshot;      // written after `after`; then the program ends
    double after = 1;                      // s: simulated with play, wall time without
    ClipOptions clip;
    GraphicsOptions graphics;
    std::filesystem::path anchors, state;  // updated while the program runs

    // True if the program draws off the screen, writes a picture or a clip and ends.
    bool only_draws() const { return !screenshot.empty() || !clip.file.empty(); }
};

// The options; or an exit code, if --help or --version has been answered or an error has been printed.
struct CommandLine {
    Options options;
    std::optional<int> exit_code;
};
CommandLine read_command_line(int argc, char** argv);

// The error when a file that the program writes is the one that it opens, another output, a scene, a run or an archive.
std::optional<Error> fault_of_outputs(const Options&);

}  // namespace braitenlab
