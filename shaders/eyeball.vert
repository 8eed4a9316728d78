// Rounded eyes: a ball with a lid in the colour of the body, which looks along the sensor's direction and slightly up.
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in float paint;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 size;   // radius, height, reading, darkness
layout(location = 6) in vec4 base;   // colour of the channel; w: 0 covered, 1 open
layout(location = 7) in vec4 lid;

out vec3 v_own;      // unit vector from the middle of the ball; x: the direction of the gaze; zero on the collar
out vec3 v_light;
out vec3 v_gloss;
flat out vec4 v_base;
flat out vec4 v_lid;  // w: reading

const float pitch_cos = 0.788, pitch_sin = 0.616;  // 38 degrees: visible from above and from behind

vec3 raised(vec3 v) { return vec3(v.x * pitch_cos - v.z * pitch_sin, v.y, v.x * pitch_sin + v.z * pitch_cos); }

void main() {
    bool collar = int(paint + 0.5) == paint_dark;
    vec3 own = (collar ? corner : raised(corner)) * size.x, facing = collar ? normal : raised(normal);
    vec3 at = to_gl(vec3(place.xy + turn(own.xy, place.zw), own.z + size.y));
    vec3 up = to_gl(vec3(turn(facing.xy, place.zw), facing.z));
    v_own = collar ? vec3(0.0) : corner;
    v_light = light_at(up, at, size.w) * from_above(up);
    v_gloss = gloss_at(up, at);
    v_base = base;
    v_lid = vec4(lid.rgb, size.z);
    gl_Position = view_projection * vec4(at, 1.0);
}
