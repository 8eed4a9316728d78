in vec2 v_own;
in vec4 v_base;
flat in float v_bulb;

out vec4 colour;

void main() {
    float d = dot(v_own, v_own), t = max(0.0, 1.0 - d);
    float glow = v_base.a * t * t * (0.35 + 0.65 * exp(-9.0 * d));
    // Brightest at the edge of the bulb, which it makes soft.
    glow += v_base.a * mix(0.4, 0.35, counts.y) * exp(-4.0 * max(d / v_bulb - 1.0, 0.0));
    // Around the bulb only, which it would darken in the light theme and burn out in the dark one; in the light theme as
    // bright as a screen shows the hue.
    glow *= smoothstep(mix(0.93, 0.84, counts.y) * v_bulb, mix(0.97, 1.0, counts.y) * v_bulb, d);
    vec3 bright = mix(v_base.rgb / max(max(v_base.r, v_base.g), max(v_base.b, 1e-3)), vec3(1.0), 0.15);
    colour = vec4(mix(v_base.rgb, bright, counts.y) * glow, glow * mix(0.25, 1.0, counts.y));
}
