in vec3 v_shell, v_glass;
in vec2 v_lens;  // how far towards the lens's middle, -1..1; what it sees 0..1
flat in vec3 v_glow;

out vec4 colour;

void main() {
    float soft = fwidth(v_lens.x);
    float lens = smoothstep(0.42 - soft, 0.42 + soft, v_lens.x);
    float rim = smoothstep(0.22 - soft, 0.22 + soft, v_lens.x);
    vec3 shell = mix(v_shell, v_glass, rim * 0.55);
    colour = vec4(mix(shell, mix(v_glass, v_glow, v_lens.y), lens), 1.0);
}
