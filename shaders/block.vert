// Walls and obstacles: upright prisms of up to eight corners with a round upper edge, and the shadow around their feet. A
// corner of the mesh holds numbers only: edge of the prism, its first (0) or second (1) end, level.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;   // x, y, direction
layout(location = 5) in vec4 corners_01;  // of the prism, counter-clockwise
layout(location = 6) in vec4 corners_23;
layout(location = 7) in vec4 corners_45;
layout(location = 8) in vec4 corners_67;
layout(location = 9) in vec4 size;   // height, radius of the upper edge, number of corners, 1: a wall of the arena
layout(location = 10) in vec4 base;  // w: 1: movable

out vec3 v_colour;
out float v_far;  // across the shadow: 0 at the foot, 1 at its outer end

// The edge between the side and the top is a quarter of a circle in steps (prism() in render/gl/batch.h).
const int level_shadow_end = -2, level_shadow = -1, level_foot = 0, level_shoulder = 1, edge_steps = 4,
          level_inner = level_shoulder + edge_steps, level_top = level_inner + 1;
const float shadow_reach = 0.24;  // m, in an arena of usual size
const float shadow_share = 0.7;   // of the length of the shadow of the sun: its end is soft

vec2 prism_corner(int i) {
    vec4 two = i < 2 ? corners_01 : i < 4 ? corners_23 : i < 6 ? corners_45 : corners_67;
    return (i & 1) == 0 ? two.xy : two.zw;
}

vec2 right_of(vec2 along) { return vec2(along.y, -along.x); }

void main() {
    int count = int(size.z + 0.5), edge = int(corner.x + 0.5), level = int(floor(corner.z + 0.5));
    // Edges beyond the number of corners are moved out of view; their corners of the top face coincide with corner 0, because
    // the last triangle of the face joins corners of used and unused edges.
    bool empty = edge >= count;
    int own = empty ? 0 : corner.y < 0.5 ? edge : (edge + 1) % count;
    vec2 here = prism_corner(own), before = prism_corner((own + count - 1) % count), after = prism_corner((own + 1) % count);
    vec2 out_before = right_of(normalize(here - before)), out_after = right_of(normalize(after - here));
    vec2 between = normalize(out_before + out_after), outwards = between / max(dot(between, out_after), 0.4);
    vec2 face = corner.y < 0.5 ? out_after : out_before;

    bool wall = size.w > 0.5, shadow = level < level_foot;
    // Parts of the normal on the rounded edge: outwards and upwards.
    float lean = 1.5707963 * clamp(float(level - level_shoulder) / float(edge_steps), 0.0, 1.0);
    float flat_part = cos(lean), upright = sin(lean);
    vec2 at = here + outwards * (level == level_shadow_end ? shadow_reach * form.y : -size.y * (1.0 - flat_part));
    float height = shadow ? 0.004 : level == level_foot ? 0.0 : size.x - size.y * (1.0 - upright);
    // Vertical edges are shaded as if they were round: across a short face between two long ones, and at a corner of two
    // short faces.
    float short_face = 0.14 * form.y;  // m
    if (!wall && max(distance(here, before), distance(here, after)) < short_face)
        face = between;
    else if (!wall && distance(prism_corner(edge % count), prism_corner((edge + 1) % count)) < short_face)
        face = corner.y < 0.5 ? out_before : out_after;
    vec3 normal = vec3(face * flat_part, upright);

    vec3 world = to_gl(vec3(place.xy + turn(at, place.zw), height));
    // The shadow reaches farther on the side away from the sun.
    if (level == level_shadow_end) world.xz -= sun.xz / sun.y * (shadow_share * size.x);
    vec3 up = to_gl(normalize(vec3(turn(normal.xy, place.zw), normal.z)));
    // A lighter top and a darker foot make the edges visible.
    vec3 of_wall = mix(vec3(0.62, 0.85, 1.08), vec3(0.99, 1.05, 0.98), counts.y);      // foot, side, top
    vec3 of_obstacle = mix(vec3(0.50, 0.71, 1.08), vec3(0.92, 0.92, 0.98), counts.y);
    vec3 shades = wall ? of_wall : of_obstacle;
    bool on_side = level <= level_shoulder;
    float shade = level == level_foot ? shades.x : mix(shades.y, shades.z, upright);
    vec3 tone = base.rgb * (on_side || level == level_top || law.w > 0.5 ? shade : shade * 1.12);
    // The outer side of a wall has the tone of the ground outside, where the light does not fall off.
    float outside = wall && dot(turn(face, place.zw), place.xy) > 0.0 ? flat_part : 0.0;
    tone = mix(tone, sky.rgb, 0.45 * outside);
    v_colour = lit(tone, light_at(up, world, 0.0, mix(room_light(vec2(world.x, -world.z)), 1.0, outside)));
    v_far = level == level_shadow_end ? 1.0 : 0.0;
    gl_Position = view_projection * vec4(world, 1.0);
    if ((empty && level != level_top) || (shadow && wall)) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
