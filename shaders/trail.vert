// One piece of a vehicle's trail, or a round end of one (TrailInstance in render/view/draw_list.h).
layout(location = 0) in vec3 corner;   // along 0..1, side -1..1
layout(location = 4) in vec4 ends;     // from, to
layout(location = 5) in vec4 sides;    // unit normals at both ends
layout(location = 6) in vec4 base;     // w: width on the screen, layout pixels
layout(location = 7) in vec4 opacity;  // at both ends; z: 1 for a round end

out vec2 v_place;  // half widths: beyond the end, across
out vec4 v_colour;

void main() {
    // A cubic curve with the trail's direction at both ends: where a vehicle is fast, pieces are long.
    vec2 from = ends.xy, to = ends.zw, back_from = vec2(sides.y, -sides.x), back_to = vec2(sides.w, -sides.z);
    float t = corner.x, rest = 1.0 - t, far = distance(from, to);
    vec2 at = mix(from, to, t * t * (3.0 - 2.0 * t)) + far * t * rest * (rest * back_from - t * back_to);
    vec2 back = 6.0 * t * rest * (to - from) + far * (rest * (1.0 - 3.0 * t) * back_from - t * (2.0 - 3.0 * t) * back_to);
    back = dot(back, back) > 0.0 ? normalize(back) : back_from;
    vec4 middle = view_projection * vec4(to_gl(vec3(at, 0.006)), 1.0);
    vec4 beside = view_projection * vec4(to_gl(vec3(at - back * 0.05, 0.006)), 1.0);
    // Constant width on the screen: moved across the trail's direction in the picture.
    vec2 along = (beside.xy / beside.w - middle.xy / middle.w) * window.xy;
    along /= max(length(along), 1e-6);
    vec2 across = vec2(along.y, -along.x);
    float half_width = 0.5 * base.w * arena.w + 0.5;
    v_place = vec2(corner.x * opacity.z, corner.y);
    v_colour = vec4(base.rgb, mix(opacity.x, opacity.y, corner.x));
    gl_Position = middle;
    gl_Position.xy += (across * v_place.y - along * v_place.x) * (2.0 * half_width * middle.w) / window.xy;
}
