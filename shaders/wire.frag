in float v_side;
in float v_along;
in vec4 v_base;
in float v_signal;
in float v_gap;

out vec4 colour;

void main() {
    if (v_gap < 0.0) discard;
    // What is carried runs along the wire in soft beads; time is the simulation's, so a pause stills them.
    float bead = 0.5 + 0.5 * cos(6.2831853 * (v_along / 0.16 - arena.z * 2.0));
    float glow = v_signal * (0.55 + 0.45 * bead);
    vec3 idle = v_base.rgb * 0.78;
    vec3 bright = mix(v_base.rgb, vec3(1.0), 0.45);
    float rim = smoothstep(0.62, 0.9, abs(v_side));
    colour = vec4(mix(mix(idle, bright, glow), ink.rgb, rim * 0.75), 1.0);
}
