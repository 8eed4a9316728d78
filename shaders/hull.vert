// A vehicle's body: hull, deck, energy gauge and the arrowhead on the nose.
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in float paint;
layout(location = 4) in vec4 place;   // x, y, direction
layout(location = 5) in vec4 size;    // length, width, height's scale, energy
layout(location = 6) in vec4 base;    // w: 1 awake, 0 parked

out vec3 v_colour;
out vec3 v_empty;             // the gauge where there is no energy
out vec2 v_gauge;             // where across the gauge, -1..1; energy

void main() {
    vec3 at = to_gl(vec3(place.xy + turn(corner.xy * size.xy, place.zw), corner.z * size.z));
    // A body is stretched, so its normals shrink where it grew.
    vec3 stretched = normalize(normal / size.xyz);
    vec3 up = to_gl(vec3(turn(stretched.xy, place.zw), stretched.z));
    int kind = int(paint + 0.5);
    vec3 tone = base.rgb;
    if (kind == paint_deck) tone = mix(base.rgb * 0.46, ink.rgb, 0.35);
    if (kind == paint_gauge) tone = mix(paper.rgb, base.rgb, 0.15);
    if (kind == paint_mark) tone = mix(base.rgb, vec3(1.0), 0.25 + 0.55 * base.w);
    v_colour = lit(tone, up, at);
    v_empty = kind == paint_gauge ? lit(ink.rgb, up, at) : v_colour;
    v_gauge = vec2(-corner.y / 0.32, size.w * 2.0 - 1.0);
    gl_Position = view_projection * vec4(at, 1.0);
}
