// Where the labels of one picture are, and what they leave free where a free place is near: vehicles, bulbs, lines.
#pragma once

#include <span>
#include <vector>

#include "core/world/snapshot.h"
#include "render/view/camera.h"

namespace braitenlab {

// Rectangles are in the pixels of the camera view's window.
class LabelSpace {
public:
    // Vehicles and bulbs. In a crowd every place is covered, so it is left out.
    void keep_free(const Snapshot&, const CameraView&);
    // Obstacles, a long one in pieces, because the rectangle around a slanted wall would be mostly floor.
    void keep_obstacles_free(const Snapshot&, const CameraView&);
    // A line of this width through points of the window.
    void keep_line_free(std::span<const maths::vec2> points, float width);
    // Something else to leave free.
    void keep_free(Rect thing) { things_.push_back(thing); }
    // A label or a card.
    void take(Rect label) { labels_.push_back(label); }

    bool is_free(const Rect&) const;
    // px² of labels and of things below; a label counts more, because two texts in one place cannot be read.
    float cost(const Rect&) const;

    const std::vector<Rect>& things() const { return things_; }
    const std::vector<Rect>& labels() const { return labels_; }

private:
    std::vector<Rect> things_, labels_;
};

inline constexpr float vehicle_middle = 0.2f;  // m above the floor, of the standard vehicle

// Around a vehicle and around the bulb of a source in the picture; width 0 behind the camera.
Rect picture_of(const Snapshot&, const CameraView&, const VehicleView&);
Rect picture_of(const Snapshot&, const CameraView&, const SourceView&);

}  // namespace braitenlab
