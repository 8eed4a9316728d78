// A vehicle's body: hull, deck with the inlay below the wires, energy gauge and arrowhead; or the rounded body.
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in float paint;
layout(location = 4) in vec4 place;   // x, y, direction
layout(location = 5) in vec4 size;    // length, width, height's scale, energy
layout(location = 6) in vec4 base;    // w: 1 awake, 0 parked
layout(location = 7) in vec4 look;    // x: detail; y: 1 for a rounded body; z: darkness

out vec3 v_colour;
out vec3 v_empty;             // colour of the empty part of the gauge
out vec2 v_gauge;             // position across the gauge, -1..1; energy

// At low detail the arrowhead fills the deck; at high detail it is on the nose and leaves the deck to the wires.
vec3 arrowhead(vec3 own, float detail) {
    vec3 on_deck = vec3(mix(-0.24, 0.15, own.x), own.y * 0.23, own.z + 0.03);
    vec3 on_nose = vec3(mix(0.375, 0.455, own.x), own.y * 0.12, own.z);
    return mix(on_deck, on_nose, detail);
}

void main() {
    int kind = int(paint + 0.5);
    float detail = look.x;
    vec3 own = kind == paint_mark ? arrowhead(corner, detail) : corner;
    vec3 at = to_gl(vec3(place.xy + turn(own.xy * size.xy, place.zw), own.z * size.z));
    // The body is stretched, so the normals are divided by the scale.
    vec3 stretched = normalize(normal / size.xyz);
    vec3 up = to_gl(vec3(turn(stretched.xy, place.zw), stretched.z));
    vec3 deck = base.rgb * mix(0.88, 0.72, detail);
    vec3 tone = base.rgb;
    if (kind == paint_deck) tone = deck;
    if (kind == paint_inlay) tone = mix(deck, mix(ink.rgb, base.rgb, 0.12), detail);
    if (kind == paint_gauge) tone = mix(deck, mix(paper.rgb, base.rgb, 0.15), detail);
    // The arrowhead contrasts with the body: white on dark colours, dark on bright ones.
    float brightness = dot(base.rgb, vec3(0.30, 0.59, 0.11));
    if (kind == paint_mark) tone = mix(base.rgb, brightness > 0.55 ? ink.rgb : vec3(1.0), 0.25 + 0.65 * base.w);
    if (look.y > 0.5) {
        // By day varnish mirrors a bright room, which makes colours paler.
        tone = mix(tone, vec3(0.78), 0.20 * counts.y);
        if (kind == paint_inlay) tone = mix(mix(vec3(0.20, 0.22, 0.26), vec3(0.29, 0.285, 0.285), counts.y), base.rgb, 0.10);
        if (kind == paint_light) tone = mix(vec3(0.82, 0.84, 0.88), base.rgb, 0.12);
        if (kind == paint_gauge) tone = vec3(0.55, 0.85, 0.40);
    }
    vec3 light = light_at(up, at, look.z);
    // The floor takes light from the lower part of a rounded body.
    if (look.y > 0.5) light *= mix(mix(0.50, 0.76, counts.y), 1.0, clamp(own.z / 0.23, 0.0, 1.0)) * from_above(up);
    // The filled part of the gauge shines.
    v_colour = lit(tone, kind == paint_gauge ? max(light, vec3(0.8)) : light);
    // The empty part of the gauge.
    v_empty = kind == paint_gauge ? lit(mix(tone, ink.rgb, max(detail, look.y)), light) : v_colour;
    if (look.y > 0.5 && kind != paint_inlay) {
        vec3 gloss = gloss_at(up, at);
        v_colour += gloss;
        v_empty += gloss;
    }
    // Half the width of the gauge, a share of the body's: as fine_hull_shape() and hull_shape() have it.
    v_gauge = vec2(-corner.y / (look.y > 0.5 ? 0.264 : 0.32), size.w * 2.0 - 1.0);
    gl_Position = view_projection * vec4(at, 1.0);
}
