// A picture with fewer pixels than the viewport, enlarged to it.
layout(location = 0) in vec3 corner;

out vec2 v_at;  // of the picture, 0 to 1

void main() {
    v_at = corner.xy * 0.5 + 0.5;
    gl_Position = vec4(corner.xy, 0.0, 1.0);
}
