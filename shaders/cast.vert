// The shadow of an upright box away from a lamp: a trapezoid on the floor that contains it.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 shape;  // half length, half width, height, number of the lamp
layout(location = 6) in vec4 lamp;   // x, y, height, strength

out vec2 v_place;
flat out vec4 v_box;    // x, y, direction
flat out vec4 v_shape;  // half length, half width, share of the ray below the box's top, number of the lamp
flat out vec2 v_lamp;

void main() {
    float below = min(shape.z / lamp.z, 0.85);  // share of the ray from the floor to the lamp below the box's top
    vec2 away = place.xy - lamp.xy;
    float far = length(away), round = length(shape.xy);
    away /= max(far, 1e-4);
    float from = max(far - round, 0.0), to = (far + round) / (1.0 - below) + 0.3;
    float s = mix(from, to, corner.x * 0.5 + 0.5);
    float wide = round * s / max(sqrt(max(far * far - round * round, 0.0)), 0.25) + 0.30;
    v_place = lamp.xy + away * s + vec2(-away.y, away.x) * corner.y * wide;
    v_box = place;
    v_shape = vec4(shape.xy, below, shape.w);
    v_lamp = lamp.xy;
    gl_Position = view_projection * vec4(to_gl(vec3(v_place, 0.004)), 1.0);
    if (far < round) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);  // the lamp is above the box
}
