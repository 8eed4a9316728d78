// Wheels, rotated by the angle they have rolled.
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in float paint;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 size;   // radius, width, angle, detail

out vec3 v_colour;

// Rolling forwards moves the top (z) towards the front (x).
vec3 rolled(vec3 v) {
    float c = cos(size.z), s = sin(size.z);
    return vec3(v.x * c + v.z * s, v.y, v.z * c - v.x * s);
}

void main() {
    vec3 own = rolled(corner) * vec3(size.x, size.y, size.x) + vec3(0.0, 0.0, size.x);
    vec3 facing = rolled(normal);
    vec3 at = to_gl(vec3(place.xy + turn(own.xy, place.zw), own.z));
    vec3 up = to_gl(vec3(turn(facing.xy, place.zw), facing.z));
    int kind = int(paint + 0.5);
    vec3 rubber = mix(ink.rgb * mix(1.0, 0.6, counts.y), vec3(0.5), mix(0.12, 0.05, counts.y));
    vec3 tone = kind == paint_mark ? mix(rubber, mix(vec3(0.76, 0.77, 0.80), vec3(0.90), counts.y), size.w) : kind == paint_deck ? rubber * 1.5 : rubber;
    if (kind == paint_body) tone = vec3(0.55, 0.58, 0.62);
    v_colour = lit(tone, light_at(up, at));
    gl_Position = view_projection * vec4(at, 1.0);
}
