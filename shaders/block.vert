// Walls and obstacles: boxes with a chamfered top. Corners hold signs; the instance gives the size.
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
layout(location = 2) in float paint;
layout(location = 4) in vec4 place;   // x, y, direction
layout(location = 5) in vec4 size;    // half length, half width, height, chamfer
layout(location = 6) in vec4 base;    // w: 1 an arena's wall

out vec3 v_colour;

void main() {
    float level = corner.z;
    vec2 half_size = size.xy - (level > 1.5 ? size.w : 0.0);
    float height = level < 0.5 ? 0.0 : level < 1.5 ? size.z - size.w : size.z;
    vec3 at = to_gl(vec3(place.xy + turn(corner.xy * half_size, place.zw), height));
    vec3 up = to_gl(vec3(turn(normal.xy, place.zw), normal.z));
    int kind = int(paint + 0.5);
    // The top lighter, the foot darker: the eye finds the edge at once.
    float foot = mix(0.62, 0.88, counts.y), side = mix(0.85, 0.97, counts.y), top = mix(1.42, 0.98, counts.y);
    vec3 tone = base.rgb * (kind == paint_body ? (level < 0.5 ? foot : side) : kind == paint_light ? top * 1.12 : top);
    // A wall's outside belongs to the ground out there.
    bool outside = base.w > 0.5 && kind == paint_body && dot(turn(normal.xy, place.zw), place.xy) > 0.0;
    if (outside) tone = mix(tone, sky.rgb, 0.45);
    v_colour = tone * light_at(up, at);
    gl_Position = view_projection * vec4(at, 1.0);
}
