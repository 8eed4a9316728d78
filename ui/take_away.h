// What a person takes away as a file: a picture of the present moment, or a clip of recorded time.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace braitenlab {

// wiring: the diagram of the selected vehicle's brain. paths: those of all vehicles since the start of the run.
enum class TakeKind { scene, window, wiring, paths, gif, mp4, webm };

struct TakeKindTraits {
    TakeKind value;
    std::string_view extension;  // of the file, with its dot
    bool is_clip, by_ffmpeg;
};
inline constexpr std::array<TakeKindTraits, 7> take_kinds{{
    {TakeKind::scene, ".png", false, false},
    {TakeKind::window, ".png", false, false},
    {TakeKind::wiring, ".svg", false, false},
    {TakeKind::paths, ".svg", false, false},
    {TakeKind::gif, ".gif", true, false},
    {TakeKind::mp4, ".mp4", true, true},
    {TakeKind::webm, ".webm", true, true},
}};
inline constexpr std::array pictures_to_take{TakeKind::scene, TakeKind::window, TakeKind::wiring, TakeKind::paths};
constexpr const TakeKindTraits& row_of(TakeKind kind) { return take_kinds[static_cast<std::size_t>(kind)]; }

struct TakeAway {
    TakeKind kind = TakeKind::scene;
    int width = 0, height = 0;       // px; 0: those of the window
    std::uint64_t from = 0, to = 0;  // ticks of the run, of a clip
    friend bool operator==(const TakeAway&, const TakeAway&) = default;
};

}  // namespace braitenlab
