// Sensors: balls whose lens brightens with the reading, as squares that face the camera.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 size;   // radius, height, reading, detail
layout(location = 6) in vec4 base;   // colour of the channel; w: 0 covered, 1 open

out vec2 v_own;  // 1: at the edge of the ball
flat out vec3 v_middle, v_towards;  // GL coordinates; v_towards: to the camera
flat out vec2 v_direction;
flat out vec4 v_base;
flat out vec2 v_state;  // reading 0..1; detail

void main() {
    v_middle = to_gl(vec3(place.xy, size.y));
    v_towards = normalize(eye.xyz - v_middle);
    v_own = corner.xy;
    v_direction = place.zw;
    v_base = base;
    v_state = size.zw;
    // Nearer than its middle, so that the deck hides no more of it than of a ball.
    vec3 at = v_middle + (picture_right.xyz * corner.x + picture_up.xyz * corner.y + 0.6 * v_towards) * size.x;
    gl_Position = view_projection * vec4(at, 1.0);
}
