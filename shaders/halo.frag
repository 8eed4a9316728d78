in vec2 v_own;
in vec4 v_base;
flat in float v_bulb, v_ball;

out vec4 colour;

void main() {
    float d = dot(v_own, v_own), t = max(0.0, 1.0 - d);
    float glow = v_base.a * mix(0.7, 0.25, counts.y) * t * t * (0.16 + 0.50 * exp(-8.0 * d));
    // Brightest at the edge of a ball, which it makes soft.
    if (v_ball > 0.5) glow += v_base.a * mix(0.14, 0.05, counts.y) * exp(-4.0 * max(d / v_bulb - 1.0, 0.0));
    // It leaves free what it surrounds, which it would darken in the light theme and burn out in the dark one.
    vec2 edge = v_ball > 0.5 ? mix(vec2(0.93, 0.97), vec2(0.84, 1.0), counts.y) : vec2(0.0, 2.2);
    if (v_bulb > 0.0) glow *= smoothstep(edge.x * v_bulb, edge.y * v_bulb, d);
    // In the light theme as bright as a screen shows the hue.
    vec3 bright = mix(v_base.rgb / max(max(v_base.r, v_base.g), max(v_base.b, 1e-3)), vec3(1.0), 0.15);
    colour = vec4(mix(v_base.rgb, bright, counts.y) * glow, glow * mix(0.25, 1.0, counts.y));
}
