// Zones of the floor.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 shape;  // half length, half width, 1: ellipse, pattern
layout(location = 6) in vec4 base;   // w: opacity
layout(location = 7) in vec4 flow;   // direction in the zone's frame, strength

out vec2 v_own;
flat out vec4 v_shape, v_base, v_flow;

void main() {
    v_own = corner.xy * (shape.xy + 0.05);
    v_shape = shape;
    v_base = base;
    v_flow = flow;
    gl_Position = view_projection * vec4(to_gl(vec3(place.xy + turn(v_own, place.zw), 0.002)), 1.0);
}
