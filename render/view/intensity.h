// How strongly a channel would be felt everywhere on the floor: what the picture of its contours is made of.
#pragma once

#include <memory>
#include <vector>

#include "core/maths/vec.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// Samples across the arena, rows from its lower edge up, from one corner to the opposite one.
struct Intensity {
    int columns = 0, rows = 0;
    std::vector<float> values;  // 0..1

    static constexpr int most_columns = 160, most_rows = 160;
};

// Keeps a grid of one channel up to date.
class IntensityMap {
public:
    // Works the grid out anew if anything that it depends on has changed; true when it has. The values are what the
    // eye of `asking` for that channel would read there if it faced each source squarely: its range and half distance
    // count, or a standard eye's where the vehicle (or no_vehicle) has none. `asking` does not sense itself; memory is
    // its own. Obstacles hide what they hide from eyes. Finer where there is little to sense, so that a call costs
    // about a million sums at most.
    bool update(const Snapshot&, Channel, VehicleId asking);

    const Intensity& grid() const { return grid_; }

private:
    struct Stimulus {
        maths::vec2 place;
        float strength = 0;
        friend bool operator==(const Stimulus&, const Stimulus&) = default;
    };
    // All that the grid follows from.
    struct Cause {
        Channel channel = Channel::light;
        Sensor eye;
        std::vector<Stimulus> stimuli;
        std::vector<Pose> obstacles;         // where they are now
        std::shared_ptr<const Scene> scene;  // null: nothing to feel
        friend bool operator==(const Cause&, const Cause&) = default;
    };
    static Cause cause_of(const Snapshot&, Channel, VehicleId asking);

    Cause cause_;
    Intensity grid_;
};

// Whether the channel has a picture: what is felt by touch or within has none.
bool has_field(Channel);

// The channels of which there is anything to feel in this moment's scene, in the order of Channel.
std::vector<Channel> channels_with_field(const Snapshot&);

}  // namespace braitenlab
