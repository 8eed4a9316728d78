// The floor: one rectangle.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 half_size;

out vec2 v_place;
out float v_far;  // depth in the picture, 1 in its middle
out float v_room;  // open_room_light()
flat out float v_beyond;  // m, ground beyond the arena

void main() {
    v_place = corner.xy * half_size.xy;
    v_room = open_room_light(v_place);
    v_beyond = half_size.z;
    gl_Position = view_projection * vec4(to_gl(vec3(v_place, 0.0)), 1.0);
    float down = cross(picture_right.xyz, picture_up.xyz).y;  // sine of the camera's elevation
    v_far = gl_Position.w * max(down, 0.05) / eye.y;
}
