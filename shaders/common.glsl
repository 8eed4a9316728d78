// Declarations of all shaders. The loader puts them before each file, after a #version line and a define: VERTEX_STAGE,
// GEOMETRY_STAGE or FRAGMENT_STAGE. Valid as GLSL 330 and as ESSL 300.

struct Lamp {
    vec4 place;   // GL coordinates, strength
    vec4 colour;  // rgb, reach in metres
};

layout(std140) uniform Frame {
    mat4 view_projection;
    vec4 eye;  // camera position, GL coordinates; w: pixels per metre where clip w is 1
    vec4 picture_right, picture_up;
    vec4 sun;  // unit vector to the sun
    vec4 sun_light, sky_light, ground_light;
    vec4 sky, floor_colour, grid_colour;
    vec4 ink, paper;
    vec4 shadow_colour;
    vec4 window;  // width, height of the picture, pixels; its lower left corner in the framebuffer
    vec4 arena;   // half the width, half the height, m; simulated seconds; display pixels per layout pixel
    vec4 counts;  // x: lamps; y: 1 in the light theme; z: share of fields beyond the arena; w: boundary
    vec4 form;    // x: 1 if the arena is an ellipse; y: scale of a small arena; z: m between the lines of the grid; w: their width, m
    vec4 law;     // 1/half distance^2, 1/range^2 of light; lamps that light the floor; quality 0 low, 1 medium, 2 high
    Lamp lamps[8];
};

// Values of counts.w, the arena's boundary (core/scene/enums.h).
const float edge_wall = 0.0, edge_open = 1.0, edge_torus = 2.0;

// Distance (m) from the edge of the arena, negative inside. For an ellipse to first order: exact at the edge and for
// circles. Beyond the corner of a rectangle it is the larger of the distances along x and y.
float from_edge(vec2 place) {
    vec2 over = abs(place) - arena.xy, part = place / arena.xy, slope = part / arena.xy;
    if (form.x < 0.5) return max(over.x, over.y);
    float far = length(part);
    return far < 0.001 ? -min(arena.x, arena.y) : (far - 1.0) * far / length(slope);
}

// Distance (m) from the arena; 0 inside.
float outside_arena(vec2 place) {
    return form.x < 0.5 ? length(max(abs(place) - arena.xy, 0.0)) : max(from_edge(place), 0.0);
}

// Values of a corner's paint (Paint in render/view/shapes.h).
const int paint_body = 0, paint_deck = 1, paint_dark = 2, paint_gauge = 3, paint_mark = 4, paint_light = 5,
          paint_inlay = 6;

// World (x, y, height) to GL (x, height, -y). It is a rotation, so it is also valid for normals.
vec3 to_gl(vec3 world) { return vec3(world.x, world.z, -world.y); }

vec2 turn(vec2 v, vec2 direction) {
    return vec2(v.x * direction.x - v.y * direction.y, v.x * direction.y + v.y * direction.x);
}

// Light of a lamp at a squared distance (m^2), relative to that at 0: the law of a graded sensor (LightLaw in
// render/view/draw_list.h).
float lamp_law(float squared) {
    float rest = max(1.0 - squared * law.y, 0.0);
    return rest * rest / (1.0 + squared * law.x);
}

// Linear light that lamp i adds to the floor at a place.
vec3 lamp_on_floor(int i, vec2 place) {
    vec2 towards = vec2(lamps[i].place.x, -lamps[i].place.z) - place;
    // Deeper than the lamp's own colour; on a light floor less so.
    vec3 tint = lamps[i].colour.rgb, deep = tint * tint, day = tint;
    deep -= 0.85 * min(deep.r, min(deep.g, deep.b));
    day -= 0.85 * min(day.r, min(day.g, day.b));
    return mix(deep * 0.29, day * 0.25, counts.y) * (lamps[i].place.w * lamp_law(dot(towards, towards)));
}

// Linear light as a screen colour: gamma 2 approximates sRGB. Above the knee the brightest channel approaches 1 and the
// others keep their ratio to it, so a bright surface keeps its hue and nothing becomes white.
vec3 on_screen(vec3 light) {
    float knee = mix(0.55, 0.86, counts.y), most = max(max(light.r, light.g), max(light.b, 1e-4));
    float held = most < knee ? most : knee + (1.0 - knee) * (1.0 - exp(-(most - knee) / (1.0 - knee)));
    return sqrt(light * (held / most));
}

// Brightness of a place on the screen, because the light of sun and sky falls off away from the sun, as in a room with
// one window: 1 in the middle of the arena, 24 % more or less at its corners at dusk, 7 % by day. Its square is the share
// of the linear light. open_room_light() is linear in the place, also beyond the arena.
float open_room_light(vec2 place) {
    vec2 to_sun = normalize(vec2(sun.x, -sun.z));
    return 1.0 + mix(0.24, 0.07, counts.y) * dot(place, to_sun) / dot(abs(to_sun), arena.xy);
}

float within_room(float light) { return clamp(light, 0.76, 1.24); }
float room_light(vec2 place) { return within_room(open_room_light(place)); }

// Linear light on a surface from sun, sky, floor and lamps. `darkness`: three bits a lamp, 0 all of its light .. 7 none
// (HullInstance in render/view/draw_list.h). `room`: room_light(), or 1 for even light of sun and sky.
vec3 light_at(vec3 normal, vec3 place, float darkness, float room) {
    vec3 light = mix(ground_light.rgb, sky_light.rgb, normal.y * 0.5 + 0.5);
    light = room * room * (light + max(dot(normal, sun.xyz), 0.0) * sun_light.rgb);
    for (int i = 0; i < int(counts.x); ++i) {
        float others = floor(darkness * 0.125), passes = 1.0 - (darkness - 8.0 * others) / 7.0;
        darkness = others;
        vec3 towards = lamps[i].place.xyz - place;
        float squared = dot(towards, towards);
        // Lamps are large and low: a surface that faces away from a lamp still gets part of its light.
        float facing = max(dot(normal, towards) * inversesqrt(squared + 1e-4) * 0.8 + 0.2, 0.0);
        // The floor reflects part of the lamp's light from below, a light floor more.
        facing += mix(0.35, 0.5, counts.y) * (0.5 - 0.5 * normal.y);
        float amount = 1.9 * lamps[i].place.w * facing * lamp_law(squared) * passes;
        light += lamps[i].colour.rgb * lamps[i].colour.rgb * amount;
    }
    return light;
}

vec3 light_at(vec3 normal, vec3 place, float darkness) {
    return light_at(normal, place, darkness, room_light(vec2(place.x, -place.z)));
}
vec3 light_at(vec3 normal, vec3 place) { return light_at(normal, place, 0.0); }

// Share of the light that a rounded body keeps: most light comes from above, so its sides are darker and it looks round.
float from_above(vec3 normal) {
    float side = mix(0.66, 0.91, counts.y);
    return side + (1.0 - side) * max(normal.y, 0.0);
}

// Sun and sky mirrored in varnish: a highlight with a wide edge, and the sky where one looks along the surface.
vec3 gloss_at(vec3 normal, vec3 place) {
    vec3 towards = normalize(eye.xyz - place), mirrored = reflect(-towards, normal);
    float sunny = max(dot(mirrored, sun.xyz), 0.0), along = 1.0 - max(dot(towards, normal), 0.0);
    float wide = sunny * sunny * sunny * sunny;
    return sun_light.rgb * (0.10 * wide + 0.34 * pow(sunny, 32.0)) + sky_light.rgb * (0.03 + 0.45 * along * along * along);
}

// The screen colour of a surface of this screen colour in linear light.
vec3 lit(vec3 tone, vec3 light) { return on_screen(tone * tone * light); }

// Corners of a polygon that contains a sensor's field: a triangle below 120 degrees, a kite up to 180, a square beyond;
// counter-clockwise from the apex. `shape`: drawn radius, half the opening angle, d0, radius where the fill ends.
const float sector_height = 0.008;  // m above the floor

int sector_corner_count(float half_field) { return half_field < 1.0471976 ? 3 : 4; }

vec2 sector_corner(int i, vec4 shape) {
    float c = cos(shape.y), s = sin(shape.y);
    if (shape.y < 1.0471976) return i == 0 ? vec2(0.0) : shape.x * vec2(1.0, (i == 1 ? -s : s) / c);
    if (shape.y <= 1.5707964) {
        float arm = shape.x / cos(shape.y * 0.5);
        return i == 0 ? vec2(0.0) : i == 2 ? vec2(arm, 0.0) : arm * vec2(c, i == 1 ? -s : s);
    }
    return shape.x * vec2(i == 0 || i == 3 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
}

// Sine and cosine of half the opening angle; 1/d0^2, negative for a boolean sensor; 1/reach^2. A full circle has no
// straight sides: its sine is 0 and its cosine -1.
vec4 sector_edges(vec4 shape) {
    bool whole = shape.y >= 3.1415;
    return vec4(whole ? 0.0 : sin(shape.y), whole ? -1.0 : cos(shape.y),
                shape.z > 0.0 ? 1.0 / (shape.z * shape.z) : -1.0, 1.0 / (shape.w * shape.w));
}

#ifdef FRAGMENT_STAGE

// The fill of a sensor field at `own` (m, the sensor's axis along x): it follows the sensor's response to distance.
// `beside`: distance inside the nearer side, m; the fill fades within 2 degrees of a side, where the reading ends.
// `edges`: from sector_edges().
float field_fill(vec2 own, float beside, vec4 edges) {
    float squared = dot(own, own), rest = max(1.0 - squared * edges.w, 0.0);
    float answer = edges.z > 0.0 ? rest * rest : 0.4 * min(rest * 8.0, 1.0);
    // About the distance from the sensor; a root costs a software renderer more.
    float away = abs(own.x) + 0.4 * abs(own.y), soft = 0.02 + 0.03 * away;
    return answer * clamp(beside, 0.0, soft) / ((1.0 + squared * max(edges.z, 0.0)) * soft);
}

// Distance inside the nearer side of a field, m; the sides are mirror images.
float beside_field(vec2 own, vec4 edges) { return own.x * edges.x - abs(own.y) * edges.y; }

// A field in this colour. `part`: 1 at the edge of the arena, along x and y; the field ends at the walls.
vec4 field_colour(vec3 tone, float alpha, vec2 part) {
    float out_there = form.x < 0.5 ? max(abs(part.x), abs(part.y)) : dot(part, part);
    // On a dark floor the colours of overlapping fields are partly added, because blended colours become grey. In the
    // light theme they are blended, like glass on paper.
    alpha *= step(out_there, 1.0 + counts.z) * mix(1.1, 0.75, counts.y);
    // Colour and opacity are each rounded to one of 255 levels when they are blended; noise of two levels hides the
    // bands. A lattice of the plastic number (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences",
    // 2018), cheaper than dither(), and shifted so that fields which overlap have different noise.
    float noise = fract(dot(gl_FragCoord.xy, vec2(0.75487767, 0.56984029)) + 61.8 * alpha) - 0.5;
    noise *= min(alpha, 1.0 / 255.0) * 2.0;
    return vec4(tone * alpha + noise, alpha * mix(0.75, 1.0, counts.y));
}

// Coverage of this pixel by lines every `spacing` metres, `width` metres wide. Lines narrower than a pixel are drawn
// one pixel wide and fainter. `many`: pixels per metre.
float lines(vec2 place, vec2 pixel, vec2 many, float spacing, float width) {
    vec2 away = abs(fract(place * (1.0 / spacing) - 0.5) - 0.5) * spacing;
    vec2 cover = clamp((max(vec2(width), pixel) * 0.5 - away) * many + 0.5, 0.0, 1.0) * min(width * many, 1.0);
    cover *= clamp((0.5 - pixel * (1.0 / spacing)) * 3.0, 0.0, 1.0);
    return max(cover.x, cover.y);
}

// Slight differences of tone, so that the floor looks like a material: of each tile of the grid, and of places that are
// worn; less where a tile is a few pixels only. `many`: pixels per metre.
float worn(vec2 place, vec2 many) {
    vec2 tile = floor(place / form.z), at = place * 2.1 / form.z;
    float each = fract(dot(tile, vec2(0.75487767, 0.56984029))) - 0.5;
    float spots = sin(at.x + 1.9 * sin(0.7 * at.y)) * sin(1.3 * at.y + 1.7 * sin(0.6 * at.x));
    return 1.0 + (0.010 * each + 0.010 * spots) * clamp(0.05 * min(many.x, many.y) * form.z - 0.5, 0.0, 1.0);
}

// The floor without lamps, for floor.frag and lamplit.frag. `inside`: 1 in the arena, or everywhere where it has no walls;
// `room`: room_light().
vec3 floor_at(vec2 place, float inside, float room) {
    vec2 pixel = fwidth(place) + 1e-5, many = 1.0 / pixel;
    // Slightly brighter at the centre of the arena. Outside walls the ground is a plain table.
    vec2 from_middle = place / arena.xy;
    float middle = max(0.0, 1.0 - 0.5 * dot(from_middle, from_middle)) * (1.0 - counts.y) * 0.25;
    float faint = max(middle, lines(place, pixel, many, form.z, form.w) * 0.75) * inside;
    float bright = lines(place, pixel, many, 5.0 * form.z, 1.4 * form.w) * inside;
    vec3 bright_line = mix(grid_colour.rgb, mix(paper.rgb, ink.rgb, counts.y), 0.06);
    return mix(mix(floor_colour.rgb, grid_colour.rgb, faint), bright_line, bright) * mix(1.0, worn(place, many) * room, inside);
}

// Noise of one of 255 levels, so that a slow gradient shows no bands. Interleaved gradient noise: J. Jimenez, "Next
// Generation Post Processing in Call of Duty: Advanced Warfare", SIGGRAPH 2014.
float dither() { return (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0; }

// The sky mirrored in the floor: stronger where one looks along it. `far`: depth in the picture, 1 in its middle.
float sheen(float far) { return 1.0 + mix(0.35, 0.12, counts.y) * clamp(far - 1.0, -0.4, 0.5); }

const float floor_wall_width = 0.22;  // m, as in render/view/drawing.h

// The floor is darker at the foot of walls, on both sides, and fades into the sky outside the arena within `beyond` m.
vec3 faded_floor(vec3 ground, vec2 place, float outside, float beyond) {
    float to_wall = from_edge(place);
    float foot = clamp(1.0 - max(-to_wall, to_wall - floor_wall_width * form.y) / (0.4 * form.y), 0.0, 1.0);
    ground *= 1.0 - foot * foot * (counts.w == edge_wall ? mix(0.5, 0.18, counts.y) : 0.0);

    float fade = max(smoothstep(0.0, 0.8 * beyond, outside), min(outside * 20.0, 1.0) * (counts.w == edge_wall ? 0.72 : 0.35));
    return mix(ground, sky.rgb, fade) + dither();
}

#endif
