// Sources: lamp, brazier, blossom, bubbles.
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in float paint;
layout(location = 4) in vec4 place;  // x, y, size, strength
layout(location = 5) in vec4 base;   // w: height of its foot

out vec3 v_core, v_rim;
out vec3 v_normal, v_towards;
out vec4 v_edge;  // of a bulb; a: opacity

void main() {
    vec3 at = to_gl(vec3(place.xy, base.w) + corner * place.z);
    vec3 up = to_gl(normal);
    int kind = int(paint + 0.5);
    // Its own light would make the foot as bright as the floor.
    vec3 light = light_at(up, at);
    vec3 solid = kind == paint_deck ? lit(vec3(0.62), light) : lit(mix(vec3(0.06, 0.065, 0.09), vec3(0.16), counts.y), min(light, vec3(0.9)));
    solid += 0.5 * gloss_at(up, at);
    // White in the centre, coloured towards the rim. In the light theme, whose colours are dark, a lamp that is lit is as
    // bright as a screen shows its hue, also a dim one, and only yellow light is nearly white in the centre: another
    // colour would be as pale as the floor.
    float most = max(max(base.r, base.g), max(base.b, 1e-3)), shines = smoothstep(0.0, 0.05, place.w);
    vec3 hue = base.rgb / most, deep = mix(hue, hue * hue, 0.6);
    float yellow = clamp(1.3 * (min(hue.r, hue.g) - hue.b), 0.0, 1.0), white = mix(0.19, 0.85, yellow) * sqrt(place.w);
    vec3 day_core = mix(base.rgb, mix(hue, vec3(1.0), white), shines);
    vec3 day_rim = mix(base.rgb, mix(mix(deep, hue, place.w), vec3(1.0), 0.45 * max(2.0 * yellow - 1.0, 0.0) * place.w), shines);
    vec3 core = mix(mix(base.rgb, vec3(1.0), 0.70 * place.w), day_core, counts.y);
    vec3 rim = mix(mix(base.rgb, vec3(1.0), 0.35 * yellow * place.w), day_rim, counts.y);
    // A bright lamp of white light has nearly one tone up to its edge.
    rim = mix(rim, core, mix(0.9, 0.8, counts.y) * smoothstep(0.28, 0.40, yellow) * smoothstep(0.5, 1.0, place.w));
    v_core = kind == paint_light ? core : kind == paint_mark ? vec3(0.98, 0.93, 0.75) : solid;
    v_rim = kind == paint_light ? rim : kind == paint_mark ? base.rgb : solid;
    // On the light floor the bulb is darker towards its outline, which separates it from its light.
    v_edge = vec4(0.7 * base.rgb, kind == paint_light ? counts.y : 0.0);
    v_normal = up;
    v_towards = eye.xyz - at;
    gl_Position = view_projection * vec4(at, 1.0);
}
