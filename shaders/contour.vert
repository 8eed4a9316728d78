// Intensity of a channel on the arena's floor.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // half the arena's size; samples along x and y
layout(location = 5) in vec4 base;   // w: side of the texture, samples

out vec2 v_sample;
out vec2 v_place;
flat out vec3 v_base;

void main() {
    vec2 across = corner.xy * 0.5 + 0.5;
    v_sample = (across * (place.zw - 1.0) + 0.5) / base.w;
    v_base = base.rgb;
    v_place = corner.xy * place.xy;
    gl_Position = view_projection * vec4(to_gl(vec3(v_place, 0.003)), 1.0);
}
