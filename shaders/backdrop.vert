// The stored picture of the ground, at the far end of the depth range.
layout(location = 0) in vec3 corner;

void main() { gl_Position = vec4(corner.xy, 1.0, 1.0); }
