// Sensors: balls whose lens brightens with the reading.
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 size;   // radius, height, reading, detail
layout(location = 6) in vec4 base;   // colour of the channel; w: 0 covered, 1 open

out vec3 v_shell, v_glass;
out vec3 v_lens;
out float v_facing;  // 1 where the ball faces the camera
flat out vec3 v_glow;
out vec3 v_lid;  // across the lens, -1..1; 1 covered

// The lens is tilted upwards, so it is visible from above.
vec3 raised(vec3 v) { return vec3(v.x * 0.74 - v.z * 0.67, v.y, v.x * 0.67 + v.z * 0.74); }

void main() {
    vec3 own = raised(corner) * size.x, facing = raised(normal);
    vec3 at = to_gl(vec3(place.xy + turn(own.xy, place.zw), own.z + size.y));
    vec3 up = to_gl(vec3(turn(facing.xy, place.zw), facing.z));
    // The shell gets part of the colour, so that a high reading is also visible from behind.
    vec3 white = mix(vec3(0.80, 0.82, 0.85), base.rgb, 0.45 * size.z);
    vec3 light = light_at(up, at);
    v_shell = mix(lit(white, light), base.rgb, 0.25 * size.z);
    v_glass = lit(mix(ink.rgb, base.rgb, 0.10), light);
    v_glow = mix(base.rgb, vec3(1.0), 0.30);
    v_lid = vec3(corner.yz, 1.0 - base.w);
    v_lens = vec3(corner.x, size.z, size.w);
    v_facing = dot(up, normalize(eye.xyz - at));
    gl_Position = view_projection * vec4(at, 1.0);
}
