// Part of the light of one lamp that a box takes away. The ray from the floor to the lamp is below the box's top up to
// `below` of its length; that part is compared with the box.
in vec2 v_place;
flat in vec4 v_box;
flat in vec4 v_shape;
flat in vec2 v_lamp;

out vec4 colour;

vec2 turn_back(vec2 v, vec2 direction) {
    return vec2(v.x * direction.x + v.y * direction.y, v.y * direction.x - v.x * direction.y);
}

void main() {
    vec2 ray = v_lamp - v_place;
    float whole = length(ray);
    vec2 ahead = turn_back(ray / max(whole, 1e-4), v_box.zw), middle = turn_back(v_box.xy - v_place, v_box.zw);
    // Across the ray, and the lengths of the ray at which it enters and leaves the box.
    float across = abs(middle.x * ahead.y - middle.y * ahead.x);
    float half_across = dot(abs(ahead.yx), v_shape.xy) * 0.94;
    vec2 slope = 1.0 / (abs(ahead) + 1e-3), centre = middle * sign(ahead);
    vec2 first = (centre - v_shape.xy) * slope, last = (centre + v_shape.xy) * slope;
    float enters = max(first.x, first.y), leaves = min(last.x, last.y);
    // The half-shadow widens with the distance to the box.
    float before = clamp(enters, 0.0, whole);
    float soft = 0.04 + 0.16 * before, end_soft = 0.08 + 0.25 * before;
    float side = smoothstep(soft, -soft, across - half_across);
    float end = smoothstep(end_soft, -end_soft, enters - whole * v_shape.z);
    float behind = smoothstep(-0.06, 0.06, leaves);

    const vec3 luminance = vec3(0.30, 0.59, 0.11);
    float all = dot(floor_colour.rgb * floor_colour.rgb, luminance), own = 0.0;
    for (int i = 0; i < int(law.z); ++i) {
        float part = dot(lamp_on_floor(i, v_place), luminance);
        all += part;
        if (i == int(v_shape.w + 0.5)) own = part;
    }
    // By day the shadow is stronger than the lamp's share of the light, which is small.
    float taken = side * end * behind * min(mix(0.92, 1.8, counts.y) * own / all, 0.9);
    colour = vec4(0.0, 0.0, 0.0, 1.0 - sqrt(max(1.0 - taken, 0.0)));
}
