// A clip of a part of a run: the run is repeated beside the lab's own and drawn off the screen, a little in each call.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/pictures/clip_file.h"
#include "core/session/recorded_run.h"
#include "render/gl/renderer.h"

namespace braitenlab {

inline constexpr int longest_clip = 120;  // s

// What is drawn: the scene without cards.
struct SceneLook {
    Picture picture;                 // its camera view is made for each picture from the camera of its settings
    std::optional<FloorBox> framed;  // the part of the floor that zoom 1 shows; nullopt: the action of the whole clip
};

// The camera view of a look in a picture of this size. `framed` in place of the look's if that has none.
CameraView view_of_look(const SceneLook&, const Snapshot&, int width, int height, const FloorBox& framed);

struct ClipPlan {
    std::filesystem::path file;
    ClipFormat format = ClipFormat::gif;
    std::uint64_t from = 0, to = 600;  // ticks
    int width = 640, height = 400;     // px
};

class Clip {
public:
    // Fails with a plan that has no time or too much of it, with a size that the driver does not draw, or if a shader
    // does not load. Precondition until destruction: a current GL context. Later fails as ClipFile does.
    static Result<Clip> begin(Recording, SceneLook, ClipPlan, const std::filesystem::path& shader_folder,
                              render::Lettering of_labels);
    Clip(Clip&&) noexcept;
    ~Clip();  // before the end, nothing is written

    // Works for at least one picture and about `budget`. True once the clip is written or has failed.
    bool work(std::chrono::milliseconds budget);

    float progress() const;  // 0..1
    const std::optional<Error>& error() const;
    const ClipPlan& plan() const;

private:
    struct Parts;
    explicit Clip(std::unique_ptr<Parts>);
    std::unique_ptr<Parts> parts_;
};

}  // namespace braitenlab
