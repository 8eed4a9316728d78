// Anchors: the rectangles of all widgets of the current frame, by a stable id ("slider.LL", "exercise.step.2",
// "pin.SL.out"). Used by highlights, the keyboard focus and tests that control the real window.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "render/view/camera.h"

namespace braitenlab::ui {

class Anchors {
public:
    // Starts a frame: find() and all() no longer return rectangles of earlier frames. Ids stay in memory, so that a
    // frame with the same widgets allocates no memory.
    void begin() { ++frame_; }
    void record(std::string_view id, Rect window_pixels) {
        auto found = known_.find(id);
        if (found == known_.end()) found = known_.emplace(std::string(id), Known{}).first;
        found->second = {window_pixels, frame_};
    }

    const Rect* find(std::string_view id) const {
        const auto found = known_.find(id);
        return found == known_.end() || found->second.frame != frame_ ? nullptr : &found->second.rect;
    }
    std::map<std::string, Rect, std::less<>> all() const {
        std::map<std::string, Rect, std::less<>> now;
        for (const auto& [id, known] : known_)
            if (known.frame == frame_) now.emplace(id, known.rect);
        return now;
    }

private:
    struct Known {
        Rect rect;
        std::uint64_t frame = 0;
    };
    std::map<std::string, Known, std::less<>> known_;
    std::uint64_t frame_ = 0;
};

}  // namespace braitenlab::ui
