// Sources: lamp, brazier, blossom, bubbles.
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in float paint;
layout(location = 4) in vec4 place;  // x, y, size, strength
layout(location = 5) in vec4 base;   // w: height of its foot

out vec3 v_core, v_rim;
out vec3 v_normal, v_towards;

void main() {
    vec3 at = to_gl(vec3(place.xy, base.w) + corner * place.z);
    vec3 up = to_gl(normal);
    int kind = int(paint + 0.5);
    vec3 solid = lit(kind == paint_deck ? vec3(0.62) : mix(ink.rgb, vec3(0.55), 0.18), light_at(up, at));
    // White in the centre, coloured towards the rim. In the light theme, whose colours are dark, the rim is as bright as
    // a screen shows its hue.
    float most = max(max(base.r, base.g), max(base.b, 1e-3));
    vec3 glass = mix(base.rgb, base.rgb / mix(1.0, most, place.w), counts.y);
    vec3 core = mix(glass, vec3(1.0), mix(0.70, 0.93, counts.y) * place.w);
    vec3 rim = mix(glass, vec3(1.0), mix(0.0, 0.35, counts.y) * place.w);
    v_core = kind == paint_light ? core : kind == paint_mark ? vec3(0.98, 0.93, 0.75) : solid;
    v_rim = kind == paint_light ? rim : kind == paint_mark ? base.rgb : solid;
    v_normal = up;
    v_towards = eye.xyz - at;
    gl_Position = view_projection * vec4(at, 1.0);
}
