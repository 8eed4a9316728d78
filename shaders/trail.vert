// One segment of a vehicle's trail.
layout(location = 0) in vec3 corner;   // along 0..1, side -1..1
layout(location = 4) in vec4 ends;     // from, to
layout(location = 5) in vec4 sides;    // unit normals at both ends
layout(location = 6) in vec4 base;     // w: width
layout(location = 7) in vec4 opacity;  // at both ends

out float v_side;
out vec4 v_colour;

void main() {
    vec2 at = mix(ends.xy, ends.zw, corner.x) + mix(sides.xy, sides.zw, corner.x) * corner.y * 0.5 * base.w;
    v_side = corner.y;
    v_colour = vec4(base.rgb, mix(opacity.x, opacity.y, corner.x));
    gl_Position = view_projection * vec4(to_gl(vec3(at, 0.006)), 1.0);
}
