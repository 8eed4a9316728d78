// A vehicle that is small on the screen: seen from above, flat, of few corners.
layout(location = 0) in vec3 corner;
layout(location = 2) in float paint;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 size;   // length, width, height's scale, length on the screen in layout pixels
layout(location = 6) in vec4 base;   // w: 1 awake, 0 parked
layout(location = 7) in vec4 seen;   // by the left eyes, by the right ones

flat out vec3 v_colour;

void main() {
    int kind = int(paint + 0.5);
    vec3 rim = mix(mix(base.rgb, vec3(1.0), 0.55), mix(ink.rgb, base.rgb, 0.2), counts.y);
    float brightness = dot(base.rgb, vec3(0.30, 0.59, 0.11));
    vec3 arrow = mix(base.rgb, brightness > 0.55 ? ink.rgb : vec3(1.0), 0.25 + 0.65 * base.w);
    vec3 light = sqrt(sky_light.rgb + sun.y * sun_light.rgb);
    v_colour = base.rgb * light;
    if (kind == paint_inlay) v_colour = mix(base.rgb, rim, 0.6 * base.w);
    if (kind == paint_dark) v_colour = ink.rgb;
    if (kind == paint_mark) v_colour = arrow;
    if (kind == paint_light) v_colour = mix(ink.rgb, vec3(1.0), 0.25 + 0.75 * (corner.y > 0.0 ? seen.x : seen.y));
    vec2 own = corner.xy * size.xy;
    gl_Position = view_projection * vec4(to_gl(vec3(place.xy + turn(own, place.zw), corner.z * size.z)), 1.0);
}
