// The part of the floor that the camera frames by default: the action of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "render/view/camera.h"

namespace braitenlab {

// The smallest box around all vehicles, sources, lines of tape and the obstacles near them, inside the arena with its
// walls; the whole arena without sources and tape. m.
FloorBox action_of(const Snapshot&);

// What the framed box depends on besides the snapshot.
struct FramingInput {
    Camera camera;
    VehicleId selected = no_vehicle;
    Rect window, free_area;
    float least_share = 0.05f;  // of the free area's width: least length of the selected vehicle, with few vehicles
    std::optional<FloorBox> beside{};    // what else stays in the picture: another run, the ring of a goal
    float seconds = 0;                   // since the last frame; 0: no glide, the box changes at once
    bool held = false;                   // the user holds something: the box stays
    bool paused = false;                 // the box stays as long as vehicles and sources stay in it
    std::optional<FloorBox> close_up{};  // framed in place of the action
};

// The share of the free area that the arena's floor should cover.
inline constexpr float wanted_cover = 0.75f;

// The share of the free area that the arena with its walls covers; 0 where a corner is behind the camera.
float floor_cover(const CameraView&, const Arena&, Rect free_area);

// Follows the action of a run: the box rests as long as all vehicles are in the free area. Once one leaves it, a new
// box with room in front of the vehicles is chosen, to which the shown one moves without a jump of its speed, except
// with a selected vehicle that enters a torus at the opposite edge. It is around the action since the start of the run,
// or, where the vehicle would be too small or the floor would not cover enough, a part of that, in which the present
// vehicles and the sources near them are; the paths behind them may then leave the picture. While the user has zoomed
// or moved the camera, the box stays. A camera that the user has not turned is lower over a box that is deep for the
// free area and higher over one that is wide for it. In an area that is narrow for its height, as between two cards of
// a small window, the box is never a part of the action: what the vehicle drives to stays in the picture.
class Framing {
public:
    // The box of this frame.
    FloorBox follow(const Snapshot&, const FramingInput&);

    // A camera with the elevation of this frame, unless it is turned or has another one than the default.
    Camera raised(Camera) const;

    // Fits the box to the present action at the next call.
    void start_over() { shown_.reset(), grown_.reset(), place_.reset(), rests_ = false; }

private:
    enum class Sources { all, nearest, none };  // that stay in the picture
    // What is chosen anew when the reason has changed or something has left the picture, and else rests. A present
    // elevation and the sources in the picture stay unless others are clearly better; an elevation stays for 25 s.
    struct Choice {
        float elevation = Camera{}.elevation;
        float part = 1;  // of the sides of the box around the action
        Sources sources = Sources::all;
        bool fills = false;  // the part is widened to the aspect ratio of the free area
    };
    struct Reason {
        Rect free_area;
        float elevation = 0;  // of the user's camera
        CameraMode mode = CameraMode::overview;
        float least_share = 0;
        bool close_up = false;
        friend bool operator==(const Reason&, const Reason&) = default;
    };
    Choice choose(const Snapshot&, const FramingInput&, bool is_level) const;  // is_level: with the present elevation
    bool is_in_sight(const Snapshot&, const FramingInput&) const;
    FloorBox needed_now(const Snapshot&, const FramingInput&, const Choice&) const;
    FloorBox wanted(const Snapshot&, FramingInput, const Choice&) const;
    std::optional<int> nearest_source(const Snapshot&, maths::vec2 place) const;

    std::optional<FloorBox> shown_, grown_;  // displayed box; box around the action since the start
    std::optional<FloorBox> driven_;         // where vehicles and sources have been
    std::optional<maths::vec2> place_;       // of the selected vehicle in the last frame, in scenes of few vehicles
    FloorBox goal_;                          // to which the displayed box glides
    bool gives_room_ = false;                // in front of vehicles that have left the picture
    Choice choice_;
    bool rests_ = false;   // the present choice stays unless another one is clearly better
    bool glides_ = false;  // in a pause: to a box that is wanted for a new reason
    Reason reason_;
    float elevation_ = Camera{}.elevation;  // displayed
    FloorBox speed_{};                      // of the displayed box, m/s
    float turning_ = 0;                     // of the displayed elevation, rad/s
    std::optional<int> nearest_;            // the source that stays in the picture
    std::uint64_t seed_ = 0, tick_ = 0;
    std::optional<std::uint64_t> raised_at_;  // tick of the last change of the elevation
    int generation_ = 0;
    std::string scene_;
};

inline constexpr std::size_t few_vehicles = 5;  // up to this number the selected one has a least size

}  // namespace braitenlab
