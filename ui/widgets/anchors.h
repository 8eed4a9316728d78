// Where every widget stands in the window, by a stable id: "slider.LL", "exercise.step.2", "pin.SL.out".
//
// Tutorial highlights, keyboard help and tests that drive the real window all read it.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "render/view/camera.h"

namespace braitenlab {

class Anchors {
public:
    // Forgets last frame's rectangles; those recorded until the next begin() are this frame's.
    void begin() { rectangles_.clear(); }
    void record(std::string_view id, Rect window_pixels) {
        rectangles_.insert_or_assign(std::string(id), window_pixels);
    }

    const Rect* find(std::string_view id) const {
        const auto found = rectangles_.find(id);
        return found == rectangles_.end() ? nullptr : &found->second;
    }
    const std::map<std::string, Rect, std::less<>>& all() const { return rectangles_; }

private:
    std::map<std::string, Rect, std::less<>> rectangles_;
};

}  // namespace braitenlab
