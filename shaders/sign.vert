// A vehicle that is small on the screen: its outline from above; sign.frag draws wheels, sensors and arrowhead onto it.
layout(location = 0) in vec3 corner;
layout(location = 2) in float inside;  // distance inside the outline
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 size;   // length, width, height's scale, length on the screen in layout pixels
layout(location = 6) in vec4 base;   // w: 1 awake, 0 parked
layout(location = 7) in vec4 seen;   // largest reading of the left sensors, of the right ones

out vec3 v_own;  // along and across the body, -0.5..0.5; inside
flat out vec4 v_base;
flat out vec2 v_seen;

void main() {
    v_own = vec3(corner.xy, inside);
    v_base = vec4(base.rgb * room_light(place.xy), base.w);
    v_seen = seen.xy;
    vec2 own = corner.xy * size.xy;
    gl_Position = view_projection * vec4(to_gl(vec3(place.xy + turn(own, place.zw), corner.z * size.z)), 1.0);
}
