// Zones of the floor.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 shape;  // half length, half width, 0: rectangle, 1: ellipse, else number of corners, pattern
layout(location = 6) in vec4 base;   // w: opacity
layout(location = 7) in vec4 flow;   // direction in the zone's frame, strength
layout(location = 8) in vec4 corners_01;  // of a polygon, counter-clockwise
layout(location = 9) in vec4 corners_23;
layout(location = 10) in vec4 corners_45;
layout(location = 11) in vec4 corners_67;

out vec2 v_own;
out float v_room;  // room_light()
flat out vec4 v_shape, v_base, v_flow, v_corners_01, v_corners_23, v_corners_45, v_corners_67;

void main() {
    v_own = corner.xy * (shape.xy + 0.05);
    v_shape = shape;
    v_base = base;
    v_flow = flow;
    v_corners_01 = corners_01, v_corners_23 = corners_23, v_corners_45 = corners_45, v_corners_67 = corners_67;
    vec2 world = place.xy + turn(v_own, place.zw);
    v_room = room_light(world);
    gl_Position = view_projection * vec4(to_gl(vec3(world, 0.002)), 1.0);
}
