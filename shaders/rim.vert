// A thin outline that separates a vehicle of low detail from the floor. At high detail the shading separates them.
layout(location = 0) in vec3 corner;  // z: factor on the outline's distance at this corner
layout(location = 1) in vec3 normal;  // outwards
layout(location = 2) in float paint;  // 0: inner side of the line, 1: outer side, 2: end of its fade, 3: area inside
layout(location = 4) in vec4 place;   // x, y, direction
layout(location = 5) in vec4 size;    // length, width, height's scale, energy
layout(location = 6) in vec4 base;    // w: 1 awake, 0 parked
layout(location = 7) in vec4 look;    // x: detail

out vec4 v_rim;

void main() {
    vec3 outwards = to_gl(vec3(turn(normalize(normal.xy / size.xy), place.zw), 0.0));
    vec2 on_screen = vec2(dot(outwards, picture_right.xyz), dot(outwards, picture_up.xyz));
    // The silhouette is the body's upper edge on the far side and the lower edge on the near side.
    float height = mix(0.06, 0.26, smoothstep(-0.2, 0.2, on_screen.y)) * size.z;
    vec3 at = to_gl(vec3(place.xy + turn(corner.xy * size.xy, place.zw), height));
    float pixel = (view_projection * vec4(at, 1.0)).w / eye.w;
    int edge = int(paint + 0.5);
    float width = mix(1.2, 0.8, counts.y) * arena.w;
    float step_out = edge == 0 || edge == 3 ? 0.0 : edge == 1 ? width : width + 0.9;
    vec2 off = normalize(on_screen + vec2(1e-5)) * step_out * corner.z * pixel;
    at += picture_right.xyz * off.x + picture_up.xyz * off.y;

    vec3 line = mix(mix(base.rgb, vec3(1.0), 0.72), mix(ink.rgb, base.rgb, 0.2), counts.y);
    float strength = (edge == 2 ? 0.0 : 0.9 * (1.0 - look.x)) * mix(0.6, 1.0, base.w);
    v_rim = edge == 3 ? vec4(mix(ink.rgb, base.rgb, 0.25), 1.0 - look.x) : vec4(line, strength);
    gl_Position = view_projection * vec4(at, 1.0);
    // The line is behind all solid objects, including the body of the vehicle. The floor writes no depth and does not
    // cut the line.
    gl_Position.z = gl_Position.w * 0.9999;
    if (look.x >= 1.0) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);  // invisible: out of the picture
}
