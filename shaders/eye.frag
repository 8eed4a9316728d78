in vec3 v_shell, v_glass;
in vec3 v_lens;  // how far towards the lens's middle, -1..1; what it sees 0..1; detail
in float v_facing;
flat in vec3 v_glow;

out vec4 colour;

void main() {
    float soft = fwidth(v_lens.x);
    float lens = smoothstep(0.42 - soft, 0.42 + soft, v_lens.x);
    float rim = smoothstep(0.22 - soft, 0.22 + soft, v_lens.x);
    vec3 shell = mix(v_shell, v_glass, rim * 0.55);
    vec3 near = mix(shell, mix(v_glass, v_glow, v_lens.y), lens);
    // Small on the screen a plain dot with a dark edge: it must be seen that there are eyes, and what they see.
    vec3 dot_colour = mix(vec3(0.97), v_glow, v_lens.y);
    vec3 far = mix(ink.rgb, dot_colour, smoothstep(0.35, 0.65, v_facing));
    colour = vec4(mix(far, near, v_lens.z), 1.0);
}
