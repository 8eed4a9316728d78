// Eyes: balls whose lens lights up with what it sees.
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in float paint;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 size;   // radius, height, what it sees
layout(location = 6) in vec4 base;   // colour of what it looks for

out vec3 v_colour;

// The lens looks half upwards, so that it can be seen from above.
vec3 raised(vec3 v) { return vec3(v.x * 0.80 - v.z * 0.60, v.y, v.x * 0.60 + v.z * 0.80); }

void main() {
    vec3 own = raised(corner) * size.x, facing = raised(normal);
    vec3 at = to_gl(vec3(place.xy + turn(own.xy, place.zw), own.z + size.y));
    vec3 up = to_gl(vec3(turn(facing.xy, place.zw), facing.z));
    vec3 shell = lit(vec3(0.86, 0.88, 0.91), up, at);
    vec3 glass = lit(mix(ink.rgb, base.rgb, 0.16), up, at);
    vec3 glow = mix(base.rgb, vec3(1.0), 0.25);
    v_colour = int(paint + 0.5) == paint_lens ? mix(glass, glow, size.z) : shell;
    gl_Position = view_projection * vec4(at, 1.0);
}
