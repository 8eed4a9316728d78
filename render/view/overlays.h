// What a person may switch on and off in the scene.
#pragma once

#include <optional>

#include "core/scene/scene.h"

namespace braitenlab {

// What may be shown beyond the things themselves.
struct Overlays {
    bool trails = true;            // where vehicles came from
    bool surfaces = true;          // zones: ice, carpet, wind, …
    bool memory = true;            // the places that vehicles remember
    bool labels = true;            // names of things
    std::optional<Channel> field;  // how strongly this channel is felt everywhere, as contours
    friend bool operator==(const Overlays&, const Overlays&) = default;
};

}  // namespace braitenlab
