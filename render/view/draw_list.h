// A snapshot turned into flat arrays, one a kind of thing: what a graphics library needs and nothing of one.
//
// Every instance is a few vectors of four floats, as the shaders read them. Places are metres of the world's plane;
// `place` holds x, y and the direction (cos, sin) that a thing faces. `detail` is 0 for a vehicle that is small on the
// screen, shown as a plain sign, and 1 for one that is large enough for all its parts; between them parts fade.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/maths/vec.h"
#include "render/view/deck.h"
#include "render/view/palette.h"
#include "render/view/picture.h"
#include "render/view/trails.h"

namespace braitenlab::sensing {
struct Intensity;
}

namespace braitenlab::render {

inline constexpr int role_count = 3;
inline constexpr int source_shape_count = 4;  // light (and whatever has no shape of its own), heat, smell, oxygen

struct HullInstance {
    maths::vec4 place;
    maths::vec4 size;    // length, width, height's scale, energy 0..1
    maths::vec4 colour;  // w: 0 parked .. 1 awake
    maths::vec4 look;    // x: detail
};
struct SignInstance {
    maths::vec4 place;
    maths::vec4 size;    // length, width, height's scale, length on the screen in layout pixels
    maths::vec4 colour;  // w: 0 parked .. 1 awake
    maths::vec4 seen;    // x: by the left eyes 0..1, y: by the right ones
};
struct WheelInstance {
    maths::vec4 place;
    maths::vec4 size;  // radius m, width m, angle turned rad, detail
};
struct EyeInstance {
    maths::vec4 place;
    maths::vec4 size;    // radius m, height m, what it sees 0..1, detail
    maths::vec4 colour;  // of what it looks for; w: 0 covered by a lid, 1 open
};
struct WireInstance {
    maths::vec4 ends;    // x, y where it begins and where it ends
    maths::vec4 shape;   // x, y of the point that bends it, height m, width m
    maths::vec4 colour;  // w: 1 excites, −1 inhibits
    maths::vec4 signal;  // x: its size now 0..1; y: 1 cut
};
struct NeuronInstance {
    maths::vec4 place;  // x, y, height, radius; m
    maths::vec4
        colour;  // w: the size of its value, 0..1; −1 crossed out: a dead neuron, or a wheel whose motor stopped
};
struct FieldInstance {
    maths::vec4 place;
    maths::vec4 shape;   // radius drawn m, half the field rad, d0 m (0: boolean), radius where the fill ends m
    maths::vec4 colour;  // w: how strong the fill is, 0..1
    maths::vec4 line;    // x: how strong the edge is 0..1; y: the arc's radius m, or the chord's distance, negative
};
// An upright prism with a chamfered top.
struct BlockInstance {
    maths::vec4 place;
    std::array<maths::vec4, 4> corners;  // two of up to eight corners each, anticlockwise, in its own frame; m
    maths::vec4 size;                    // height m, chamfer m, number of corners, 1 an arena's wall
    maths::vec4 colour;                  // w: 1 can be pushed
};
// What is different about a piece of floor. The shaders know the same numbers.
enum class Pattern { ice, carpet, sand, tape, recharge, wind, slope, pull, push };
struct ZoneInstance {
    maths::vec4 place;
    maths::vec4 shape;   // half the length, half the width, 1 round, Pattern
    maths::vec4 colour;  // w: opacity
    maths::vec4 flow;    // x, y: which way it pushes, in the zone's frame; z: how strongly 0..1
};
// What lies flat on the floor. The shaders know the same numbers.
enum class MarkKind { shadow, pool, ring, thin_ring, memory, arrow, whole_socket, dashed_socket, dotted_socket };
struct MarkInstance {
    maths::vec4 place;
    maths::vec4 shape;  // half the length, half the width, softness or width of its line (m), MarkKind
    maths::vec4 colour;
};
struct SourceInstance {
    maths::vec4 place;   // x, y, size, strength
    maths::vec4 colour;  // w: height of what it stands on, m
};
struct HaloInstance {
    maths::vec4 place;  // x, y, height, radius; m
    maths::vec4 colour;
};
struct TrailInstance {
    maths::vec4 ends;     // from, to
    maths::vec4 sides;    // unit normals at both ends
    maths::vec4 colour;   // rgb, w: width m
    maths::vec4 opacity;  // x: at the first end, y: at the second
};

// A lamp lights what is near it.
struct Lamp {
    maths::vec4 place;   // GL coordinates, strength
    maths::vec4 colour;  // rgb, reach m
};
inline constexpr std::size_t most_lamps = 8;

// The decks' plans, worked out once a brain and not once a picture.
class DeckPlans {
public:
    const DeckPlan& of(const std::shared_ptr<const BrainGraph>&, std::size_t kind, const Kind&);
    void forget_unused();  // since the last call

private:
    struct Entry {
        std::shared_ptr<const BrainGraph> brain;
        std::size_t kind;
        std::vector<Sensor> sensors;
        Body body;
        std::unique_ptr<DeckPlan> plan;  // stays where it is
        bool used;
    };
    std::vector<Entry> entries_;
};

// A word in the picture, upright and always of the same size on the screen.
struct Label {
    maths::vec2 place;
    float height = 0;      // m above the floor
    maths::vec2 offset{};  // layout pixels on the screen, y down
    std::string text;      // UTF-8
    Colour colour;
    int rank = 0;        // where two overlap, the lower rank stays
    maths::vec2 away{};  // unit vector on the screen: the words stand wholly on this side of their place; 0: centred
};

struct DrawList {
    std::array<std::vector<HullInstance>, role_count> hulls;
    std::array<std::vector<SignInstance>, role_count> signs;  // vehicles too small for a hull
    std::vector<WheelInstance> wheels;
    std::vector<EyeInstance> eyes;
    std::vector<WireInstance> wires;
    std::vector<NeuronInstance> neurons;
    std::vector<FieldInstance> fields;
    std::vector<BlockInstance> blocks;
    std::vector<ZoneInstance> zones;
    std::vector<MarkInstance> marks;  // shadows and pools, below the fields; nothing else
    std::vector<MarkInstance> rings;  // rings, remembered places, arrows and lamps' feet, above them
    std::array<std::vector<SourceInstance>, source_shape_count> sources;
    std::vector<HaloInstance> halos;
    std::vector<TrailInstance> trails;
    std::vector<Lamp> lamps;  // at most most_lamps
    std::vector<Label> labels;
    DeckPlans decks;

    void clear();
};

// Fills the list anew, keeping its memory.
void fill(DrawList&, const Snapshot&, const Picture&, const Trails&);

// Adds the numbers of some contours of an intensity field.
void add_level_labels(DrawList&, const sensing::Intensity&, const Arena&, Colour);

// Which of DrawList::sources shows a channel.
int source_shape_of(Channel);

}  // namespace braitenlab::render
