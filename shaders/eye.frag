in vec2 v_own;
flat in vec3 v_middle, v_towards;
flat in vec2 v_direction;
flat in vec4 v_base;
flat in vec2 v_state;

out vec4 colour;

// A vector of the world in the frame of the lens, which is tilted upwards, so that it is visible from above.
vec3 from_lens(vec3 world) {
    vec2 flat_part = turn(world.xy, vec2(v_direction.x, -v_direction.y));
    return vec3(flat_part.x * 0.74 + world.z * 0.67, flat_part.y, world.z * 0.74 - flat_part.x * 0.67);
}

void main() {
    float squared = dot(v_own, v_own), facing = sqrt(max(1.0 - squared, 0.0));
    vec3 up = picture_right.xyz * v_own.x + picture_up.xyz * v_own.y + v_towards * facing;
    vec3 lens_at = from_lens(vec3(up.x, -up.z, up.y));
    float reading = v_state.x, detail = v_state.y;
    float soft = fwidth(lens_at.x), thin = fwidth(lens_at.y) + 1e-3;
    if (squared > 1.0) discard;

    // The shell gets part of the colour, so that a high reading is also visible from behind.
    vec3 white = mix(vec3(0.80, 0.82, 0.85), v_base.rgb, 0.45 * reading), light = light_at(up, v_middle);
    vec3 shell = mix(lit(white, light), v_base.rgb, 0.25 * reading);
    vec3 glass = lit(mix(ink.rgb, v_base.rgb, 0.10), light), glow = mix(v_base.rgb, vec3(1.0), 0.30);
    float lens = smoothstep(0.42 - soft, 0.42 + soft, lens_at.x);
    float rim = smoothstep(0.22 - soft, 0.22 + soft, lens_at.x);
    vec3 near = mix(mix(shell, glass, rim * 0.55), mix(glass, glow, reading), lens);
    // Small on the screen: a dot with a dark edge, which keeps sensors and their readings visible.
    float inside = smoothstep(0.35, 0.65, facing);
    vec3 seen = mix(mix(ink.rgb, mix(vec3(0.97), glow, reading), inside), near, detail);
    if (v_base.w < 0.5) {
        // Covered: a dark cap with a pale rim and a cross.
        float arms = abs(abs(lens_at.y) - abs(lens_at.z));
        float cross = (1.0 - smoothstep(0.14, 0.14 + thin, arms)) * step(0.45, lens_at.x);
        float edge = smoothstep(0.12 - soft, 0.12 + soft, lens_at.x) * (1.0 - lens);
        vec3 cap = mix(ink.rgb, vec3(0.95), max(cross, edge));
        seen = mix(mix(vec3(0.95), ink.rgb, inside), cap, detail);
    }
    colour = vec4(seen, 1.0);
}
