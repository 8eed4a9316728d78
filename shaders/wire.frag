in float v_side;
in float v_along;
flat in vec4 v_base;
flat in float v_signal;
in float v_part;
flat in float v_cut;
flat in float v_round;

out vec4 colour;

void main() {
    // A cut wire has a gap with pale ends.
    float from_gap = v_cut > 0.5 ? abs(v_part - 0.42) - 0.13 : 1.0;
    if (from_gap < 0.0) discard;
    // Beads move along the wire with simulated time and stop in a pause. Their brightness is the size of the signal.
    float bead = 0.5 + 0.5 * cos(6.2831853 * (v_along / 0.16 - arena.z * 2.0));
    float glow = v_signal * (0.55 + 0.45 * bead);
    vec3 idle = v_base.rgb * mix(0.78, 0.95, v_round);
    vec3 bright = mix(v_base.rgb, vec3(1.0), 0.45);
    float rim = smoothstep(0.62, 0.9, abs(v_side));
    vec3 tone = mix(mix(idle, bright, glow), vec3(0.95), 1.0 - smoothstep(0.05, 0.06, from_gap));
    // A cable is shaded as a tube: bright along its ridge, dark at its sides.
    float ridge = sqrt(max(1.0 - v_side * v_side, 0.0)), gleam = max(1.0 - 6.0 * abs(v_side + 0.3), 0.0);
    gleam *= step(v_part, 0.70);  // not on the arrowhead, which is flat
    tone = mix(tone, vec3(0.85), 0.14 * counts.y * v_round);  // by day paler, like the body
    vec3 tube = tone * (0.56 + 0.52 * ridge) + 0.18 * gleam;
    colour = vec4(mix(mix(tone, ink.rgb, rim * 0.75), tube, v_round), 1.0);
}
