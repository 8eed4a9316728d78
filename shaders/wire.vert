// Wires on the deck: ribbons along a quadratic Bézier curve, with an arrowhead where they excite and a disc where they
// inhibit.
layout(location = 0) in vec3 corner;  // along 0..1, side -1..1
layout(location = 4) in vec4 ends;    // from, to
layout(location = 5) in vec4 shape;   // control point, height, width
layout(location = 6) in vec4 base;    // w: 1 excites, -1 inhibits, 0 plain
layout(location = 7) in vec4 signal;  // x: 0..1; y: 1 cut; z: rise of its middle, m

out float v_side;
out float v_along;   // metres
flat out vec4 v_base;
flat out float v_signal;
out float v_part;    // share of the length, 0..1
flat out float v_cut;
flat out float v_round;  // 1 for a cable

void main() {
    float t = corner.x;
    vec2 a = ends.xy, b = ends.zw, c = shape.xy;
    vec2 on = mix(mix(a, c, t), mix(c, b, t), t);
    vec2 ahead = normalize(mix(c - a, b - c, t));
    float half_width = 0.5 * shape.w;
    float tip = smoothstep(0.70, 0.75, t);
    if (base.w > 0.0)
        half_width *= mix(1.0, (signal.z > 0.0 ? 1.75 : 2.6) * clamp((1.0 - t) * 4.0, signal.z > 0.0 ? 0.2 : 0.0, 1.0), tip);
    else if (base.w < 0.0)
        half_width *= mix(1.0, 2.1 * sqrt(max(0.0, 1.0 - pow((t - 0.87) / 0.13, 2.0))) + 0.15, tip);
    vec2 at = on + vec2(-ahead.y, ahead.x) * corner.y * half_width;
    v_side = corner.y;
    v_along = t * distance(a, b);
    v_base = base;
    v_signal = signal.x;
    v_part = t;
    v_cut = signal.y;
    v_round = signal.z > 0.0 ? 1.0 : 0.0;
    float height = shape.z + signal.z * 4.0 * t * (1.0 - t);
    gl_Position = view_projection * vec4(to_gl(vec3(at, height)), 1.0);
}
