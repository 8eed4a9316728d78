// The draw list: a snapshot as flat arrays of instances, one per type of object, without a graphics library.
//
// An instance is a few vec4 in the order in which the shaders read them. Unless stated otherwise `place` holds x, y (m)
// and the direction (cos, sin) of the object. `detail`: 0 for a vehicle that is small on the screen, 1 for one that
// shows all its parts; parts fade in between.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/maths/vec.h"
#include "render/view/deck.h"
#include "render/view/label_space.h"
#include "render/view/palette.h"
#include "render/view/picture.h"
#include "render/view/trails.h"

namespace braitenlab::sensing {
struct Intensity;
}

namespace braitenlab::render {

inline constexpr int role_count = 3;
inline constexpr int source_shape_count = 4;  // light and all others, heat, smell, oxygen

// The direction to the sun in the world: from above, left and behind the scene for the default camera, so that shadows
// lie before the objects, where they are visible. Not normalised.
inline constexpr maths::vec3 sun_direction{-0.56f, 0.30f, 0.72f};

// From an object to the shadow of its point `height` m above the floor, m.
constexpr maths::vec2 away_from_sun(float height) {
    return maths::vec2{-sun_direction.x, -sun_direction.y} * (height / sun_direction.z);
}

// Darkness: how much of each lamp's light boxes keep from a body, three bits a lamp: the sum of 8^i · d, d = 0..7 for
// lamp i of DrawList::lamps.
struct HullInstance {
    maths::vec4 place;
    maths::vec4 size;    // length, width, height's scale, energy 0..1
    maths::vec4 colour;  // w: 0 parked, 1 not parked
    maths::vec4 look;    // x: detail; y: 1 for a rounded body; z: darkness
};
struct SignInstance {
    maths::vec4 place;
    maths::vec4 size;    // length, width, height's scale, length on the screen in layout pixels
    maths::vec4 colour;  // w: 0 parked, 1 not parked
    maths::vec4 seen;    // largest reading 0..1, x: of the left sensors, y: of the right ones
};
struct WheelInstance {
    maths::vec4 place;
    maths::vec4 size;  // radius m, width m, angle turned rad, detail
};
struct EyeInstance {
    maths::vec4 place;
    maths::vec4 size;    // radius m, height m, reading 0..1, detail
    maths::vec4 colour;  // of its channel; w: 0 covered, 1 open
};
// A rounded eye with its lid.
struct EyeballInstance {
    maths::vec4 place;   // direction: that of the sensor
    maths::vec4 size;    // radius m, height m, reading 0..1, darkness as of a HullInstance
    maths::vec4 colour;  // of its channel; w: 0 covered, 1 open
    maths::vec4 lid;     // rgb
};
struct WireInstance {
    maths::vec4 ends;    // x, y of its start and of its end
    maths::vec4 shape;   // x, y of the control point, height m, width m
    maths::vec4 colour;  // w: 1 excites, −1 inhibits, 0: a stroke of a sign, or the shadow of a cable
    maths::vec4 signal;  // x: size 0..1; y: 1: cut; z: rise of its middle, m: above 0 for a round cable
};
struct NeuronInstance {
    maths::vec4 place;   // x, y, height, radius; m
    maths::vec4 colour;  // w: size of the value, 0..1; 0 also for the disc below a driver's sign; −1: crossed out
                         // (silenced neuron or motor)
};
// A soft dark disc on the deck of a vehicle, below an eye.
struct DeckShadeInstance {
    maths::vec4 place;   // x, y, height, radius; m
    maths::vec4 colour;  // w: opacity in the middle
};
inline constexpr float deck_shade_core = 0.8f;  // of its radius: beyond, it is hardly visible
struct FieldInstance {
    maths::vec4 place;
    maths::vec4 shape;   // drawn radius m, half the opening angle rad, d0 m (0: boolean), radius where the fill ends m
    maths::vec4 colour;  // w: strength of the fill, 0..1
    maths::vec4 line;    // x: strength of the outline 0..1; y: radius of the arc m, or minus the distance of the chord
};
// A wall or an obstacle: an upright prism with a round upper edge.
struct BlockInstance {
    maths::vec4 place;
    std::array<maths::vec4, 4> corners;  // two corners each, up to eight, counter-clockwise, in its own frame; m
    maths::vec4 size;    // height m, radius of the upper edge m, number of corners, 1: a wall of the arena
    maths::vec4 colour;  // w: 1: movable
};
// The pattern of a zone. Same numbers in shaders/zone.frag.
enum class Pattern { ice, carpet, sand, tape, recharge, wind, slope, pull, push };
// Its shape.z is 0 for a rectangle, 1 for an ellipse, else the number of corners.
struct ZoneInstance {
    maths::vec4 place;
    maths::vec4 shape;                   // half the length, half the width, ellipse or number of corners, Pattern
    maths::vec4 colour;                  // w: opacity
    maths::vec4 flow;                    // x, y: direction of the force in the zone's frame; z: strength 0..1
    std::array<maths::vec4, 4> corners;  // of a polygon: two each, up to eight, counter-clockwise, in its own frame; m
};
// Marks on the floor. Same numbers in shaders/mark.frag and shade.frag.
enum class MarkKind { shadow, pool, ring, thin_ring, memory, arrow, whole_socket, dashed_socket, dotted_socket };
struct MarkInstance {
    maths::vec4 place;
    maths::vec4 shape;  // half the length, half the width, softness or width of its line (m), MarkKind
    maths::vec4 colour;
};
// The shadow that an upright box casts on the floor, away from one lamp.
struct CastInstance {
    maths::vec4 place;
    maths::vec4 shape;  // half the length, half the width, height m, number of the lamp in DrawList::lamps
    maths::vec4 lamp;   // x, y, height m, strength
};
struct SourceInstance {
    maths::vec4 place;   // x, y, size, strength
    maths::vec4 colour;  // w: height of its foot, m
};
struct HaloInstance {
    maths::vec4 place;  // x, y, height, radius; m
    maths::vec4 colour;
    maths::vec4 around;  // x: radius of what it surrounds, which it leaves free, as a share of its own; y: 1: that is a
                         // ball, at whose edge it is brightest
};
struct TrailInstance {
    maths::vec4 ends;    // from, to; of a round end both are the same point
    maths::vec4 sides;   // unit normals at both ends, to which a piece is perpendicular: it may be a curve; a round end
                         // extends to their right
    maths::vec4 colour;  // rgb, w: width on the screen, layout pixels
    maths::vec4 opacity;  // x: at the first end, y: at the second; z: 1 for a round end, 0 for a piece
};

// A light for shading.
struct Lamp {
    maths::vec4 place;   // GL coordinates, strength
    maths::vec4 colour;  // rgb, reach m
};
inline constexpr std::size_t most_lamps = 8;

// How light weakens with distance d: (1 − (d/range)²)² / (1 + (d/half_distance)²), the law of a graded sensor, with the
// values of the scene's sensors.
struct LightLaw {
    float half_distance = 3, range = 12;  // m
};
LightLaw light_law(const Scene&);

// Cache of deck plans, one per brain and kind.
class DeckPlans {
public:
    // The reference is valid until forget_unused(). `kind`: index of the kind.
    const DeckPlan& of(const std::shared_ptr<const BrainGraph>&, std::size_t kind, const Kind&);
    void forget_unused();  // removes plans not used since the last call

private:
    struct Entry {
        std::vector<Sensor> sensors;  // sensors and body that the plan was computed for
        Body body;
        DeckPlan plan;
        bool planned = false;
        bool used = false;  // since the last forget_unused()
    };
    std::map<std::pair<std::shared_ptr<const BrainGraph>, std::size_t>, Entry> entries_;  // by brain and kind
};

// Where a text is relative to its place.
struct LabelSpot {
    float height = 0;      // m above the floor
    maths::vec2 offset{};  // layout pixels on the screen, y down
    maths::vec2 away{};    // unit vector on the screen: the text is on this side of its position; 0: centred
};

// A text in the picture, upright and with a constant size on the screen.
struct Label {
    maths::vec2 place;
    float height = 0;      // m above the floor
    maths::vec2 offset{};  // layout pixels on the screen, y down
    std::string text;      // UTF-8
    Colour colour;
    int rank = 0;        // of overlapping labels the lowest rank is kept
    maths::vec2 away{};  // unit vector on the screen: the text is on this side of its position; 0: centred
    std::vector<LabelSpot> elsewhere{};  // where it is if something is in its place, in this order
};

struct DrawList {
    std::array<std::vector<HullInstance>, role_count> hulls;
    std::array<std::vector<SignInstance>, role_count> signs;  // vehicles of low detail
    std::vector<WheelInstance> wheels;
    std::vector<EyeInstance> eyes;
    bool coarse = true;                                        // hulls, wheels and wires need coarse meshes only
    std::array<std::vector<HullInstance>, role_count> bodies;  // rounded, for vehicles that are large on the screen
    std::vector<WheelInstance> tyres;                          // of the rounded bodies
    std::vector<EyeballInstance> eyeballs;
    std::vector<WireInstance> wires;
    std::vector<NeuronInstance> neurons;
    std::vector<DeckShadeInstance> deck_shades;
    std::vector<FieldInstance> fields;
    std::vector<BlockInstance> blocks;
    std::vector<ZoneInstance> zones;
    std::vector<MarkInstance> marks;  // shadows and pools only; below the fields
    std::vector<MarkInstance> rings;  // all other marks; above the fields
    std::array<std::vector<SourceInstance>, source_shape_count> sources;
    std::vector<HaloInstance> halos;
    std::vector<TrailInstance> trails;
    std::vector<CastInstance> casts;  // shadows away from lamps, below the marks
    std::vector<Lamp> lamps;          // at most most_lamps
    int floor_lamps = 0;              // the first of them light the floor by its shader; others by a pool
    LightLaw law;
    std::vector<Label> labels;
    LabelSpace label_space;  // vehicles and bulbs
    DeckPlans decks;

    void clear();
};

// Replaces the content of the list. The memory of the list is reused.
void fill(DrawList&, const Snapshot&, const Picture&, const Trails&);

// Adds the labels of the contours of an intensity map.
void add_level_labels(DrawList&, const sensing::Intensity&, const Arena&, Colour, char decimal_mark = '.');

// Index in DrawList::sources for a channel.
int source_shape_of(Channel);

}  // namespace braitenlab::render
