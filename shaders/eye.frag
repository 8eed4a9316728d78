in vec3 v_shell, v_glass;
in vec3 v_lens;  // towards the centre of the lens, -1..1; reading 0..1; detail
in float v_facing;
flat in vec3 v_glow;
in vec3 v_lid;

out vec4 colour;

void main() {
    float soft = fwidth(v_lens.x), thin = fwidth(v_lid.x) + 1e-3;
    float lens = smoothstep(0.42 - soft, 0.42 + soft, v_lens.x);
    float rim = smoothstep(0.22 - soft, 0.22 + soft, v_lens.x);
    vec3 shell = mix(v_shell, v_glass, rim * 0.55);
    vec3 near = mix(shell, mix(v_glass, v_glow, v_lens.y), lens);
    // Small on the screen: a dot with a dark edge, which keeps sensors and their readings visible.
    vec3 dot_colour = mix(vec3(0.97), v_glow, v_lens.y);
    vec3 far = mix(ink.rgb, dot_colour, smoothstep(0.35, 0.65, v_facing));
    vec3 seen = mix(far, near, v_lens.z);
    if (v_lid.z > 0.5) {
        // Covered: a dark cap with a pale rim and a cross.
        float arms = abs(abs(v_lid.x) - abs(v_lid.y));
        float cross = (1.0 - smoothstep(0.14, 0.14 + thin, arms)) * step(0.45, v_lens.x);
        float edge = smoothstep(0.12 - soft, 0.12 + soft, v_lens.x) * (1.0 - smoothstep(0.42 - soft, 0.42 + soft, v_lens.x));
        vec3 cap = mix(ink.rgb, vec3(0.95), max(cross, edge));
        seen = mix(mix(vec3(0.95), ink.rgb, smoothstep(0.35, 0.65, v_facing)), cap, v_lens.z);
    }
    colour = vec4(seen, 1.0);
}
