// Intensity of a channel as a rectangle on the arena's floor.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // half the arena's size; samples along x and y
layout(location = 5) in vec4 base;   // w: side of the texture, samples

out vec2 v_sample;
flat out vec3 v_base;

void main() {
    vec2 across = corner.xy * 0.5 + 0.5;
    v_sample = (across * (place.zw - 1.0) + 0.5) / base.w;
    v_base = base.rgb;
    gl_Position = view_projection * vec4(to_gl(vec3(corner.xy * place.xy, 0.003)), 1.0);
}
