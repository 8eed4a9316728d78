// The picture of the ground, as far away as depth reaches.
layout(location = 0) in vec3 corner;

void main() { gl_Position = vec4(corner.xy, 1.0, 1.0); }
