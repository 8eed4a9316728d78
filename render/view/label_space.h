// Where the labels of one picture are, and the vehicles and bulbs that they leave free where a free place is near.
#pragma once

#include <vector>

#include "core/world/snapshot.h"
#include "render/view/camera.h"

namespace braitenlab {

// Rectangles are in the pixels of the camera view's window.
class LabelSpace {
public:
    // Vehicles and bulbs. In a crowd every place is covered, so it is left out.
    void keep_free(const Snapshot&, const CameraView&);
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
