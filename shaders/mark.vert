// What lies flat on the floor: contact shadows, pools of light, rings, remembered places, arrows.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 shape;  // half length, half width, softness or line width, kind
layout(location = 6) in vec4 base;

out vec2 v_own;
out vec4 v_shape, v_base;

void main() {
    v_own = corner.xy * (shape.xy + 2.0 * shape.z + 0.12);
    v_shape = shape;
    v_base = base;
    gl_Position = view_projection * vec4(to_gl(vec3(place.xy + turn(v_own, place.zw), 0.004)), 1.0);
}
