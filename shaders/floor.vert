// The floor: one large square.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 half_size;

out vec2 v_place;

void main() {
    v_place = corner.xy * half_size.xy;
    gl_Position = view_projection * vec4(to_gl(vec3(v_place, 0.0)), 1.0);
}
