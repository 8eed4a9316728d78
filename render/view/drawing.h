// Declarations shared by draw_list.cpp and the other draw_….cpp; not for other files.
#pragma once

#include "core/maths/angle.h"
#include "render/view/draw_list.h"
#include "render/view/palette.h"

namespace braitenlab::render {

// The input of one picture.
struct Drawing {
    DrawList& list;
    const Snapshot& now;
    const Picture& picture;
    Palette colours;
    maths::mat4 to_clip;  // projection · view
    float crowd;          // 1 for up to 8 vehicles, falls with the square root of their number
    // Length of a vehicle on the screen by which all choose between plain and rounded meshes, layout pixels; 0: each by
    // its own, where near and far vehicles differ much.
    float common_pixels = 0;
    float scale = 1;                   // of sources and marks in a small arena; see scale_of()
    std::vector<StrikeView> struck{};  // strikes that shake their vehicles now
    std::size_t obstacle_casts = 0;    // first of DrawList::casts, those of obstacles
};

constexpr float deck_height = 0.27f;  // m, of the standard vehicle

// Layout pixels: cables and eyes of a shorter vehicle cast no shadows, and its wheels only where they touch the floor.
constexpr float least_part_shadow = 70;

// Heights of parts of this body, as a factor of those of the standard vehicle.
inline float height_scale_of(const Body& body) { return std::min(body.length, body.width / 0.7f); }

inline bool is_light(const Drawing& drawing) { return drawing.picture.theme == Theme::light; }

// One vehicle with its kind and brain.
struct Subject {
    const VehicleView& view;
    const Kind& kind;
    const BrainGraph* brain;
    maths::vec2 place, ahead;
    float height_scale;
    float pixels;  // length on the screen, layout pixels
    float detail;  // 0 small on the screen .. 1 all parts
    bool sign;     // drawn as a flat sign
    bool fine;     // drawn with rounded meshes
    bool selected, hovered, driven;
    const DeckPlan* plan = nullptr;  // of its brain; null unless the brain drives it

    maths::vec2 to_world(maths::vec2 own) const { return place + maths::rotate(own, ahead); }
};

// The scale of what is drawn around a vehicle: 1, in a small arena that of the body.
inline float around(const Drawing& drawing, const Subject& s) { return drawing.scale < 1 ? s.height_scale : 1; }

inline maths::vec4 rgb_with(Colour c, float w) { return {c.r, c.g, c.b, w}; }

// For trails and sensor fields on the light floor, where the colours of the palette have little contrast.
constexpr Colour darker(Colour c) { return mix(c, Colour{0, 0, 0, c.a}, 0.2f); }

// True when a lesion silences the sensor.
bool is_covered(const Subject&, std::size_t sensor);

// The reading of a sensor, 0..1; 0 for a silenced one.
float sensed(const Drawing&, const Subject&, std::size_t sensor);

// The side of the vehicle: 1 left, −1 right, 0 in the middle.
int side_of(const Sensor&);

// False if nothing within `radius` metres of the position is in the picture. Conservative: true for some points just
// outside it.
bool in_sight(const Drawing&, maths::vec2 place, float radius);

// Adds walls, obstacles, zones, sources and memory marks.
void add_world(Drawing&);
// Adds a source and its light. `foot`: height of the source's foot, m.
void add_source(Drawing&, Channel, maths::vec2 place, float foot, float strength, float size);

// Adds the shadows of an upright box on the floor, away from each lamp that lights it. `half`: half its length and half
// its width.
void add_casts(Drawing&, maths::vec2 place, maths::vec2 ahead, maths::vec2 half, float height);

// Adds the shadows of the body and the wheels of a vehicle on the floor: contact shadows and those away from the sun
// and from lamps.
void add_shadows(Drawing&, const Subject&);
// Adds the shadows of an eye on the deck and on the floor; none of a vehicle shorter than least_part_shadow. `radius`:
// of the ball on the standard vehicle, m; `height`: of its centre, m.
void add_eye_shadows(Drawing&, const Subject&, const Sensor&, float radius, float height);

// Darkens the bodies and eyes that are behind obstacles. Vehicles hide no light from each other's sensors (see
// ChannelTraits::is_hidden), so they darken none. Precondition: the shadows of obstacles were added by add_world().
void add_darkness(Drawing&);

// Adds all vehicles.
void add_vehicles(Drawing&, const Trails&);
// Adds the sensor fields of a vehicle.
void add_fields(Drawing&, const Subject&);
// Adds the wires and neurons of a vehicle, and crosses over silenced neurons.
void add_wires(Drawing&, const Subject&);
// Adds the sign of the vehicle's driver to its deck; none for Driver::brain, which shows its wires.
void add_driver_sign(Drawing&, const Subject&);
// Adds crosses over the wheels whose motor is silenced.
void add_stopped_wheels(Drawing&, const Subject&);
// The deck plan of the vehicle's brain; null unless the brain drives the vehicle.
const DeckPlan* plan_of(Drawing&, const Subject&);
// Adds arrows for the wheel speeds of the selected vehicle.
void add_wheel_arrows(Drawing&, const Subject&);
void add_trail(Drawing&, const Subject&, const Trail&);

// Adds names of sources and zones, numbers of vehicles, and metres along the arena's boundary.
void add_labels(Drawing&);

}  // namespace braitenlab::render
