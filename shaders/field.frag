in vec2 v_own;
in vec4 v_shape, v_base, v_line;

out vec4 colour;

void main() {
    float d = length(v_own);
    float half_field = v_shape.y, reach = v_shape.w;
    // Metres inside the nearer arm; both arms lie mirrored, so one side is enough.
    float beside = half_field >= 3.1415 ? 1e3 : v_own.x * sin(half_field) - abs(v_own.y) * cos(half_field);
    if (half_field > 1.5707964 && v_own.x > 0.0) beside = max(beside, d);

    // Keen nearby and weaker farther on, as the eye itself is; edges soften with distance like those of a light cone.
    float ratio = min(d / reach, 1.0), rest = 1.0 - ratio * ratio;
    float answer = v_shape.z > 0.0 ? rest * rest / (1.0 + d * d / (v_shape.z * v_shape.z) * 0.6) : 0.45 * smoothstep(0.0, 0.1, rest);
    float fill = v_base.w * answer * smoothstep(0.0, 0.03 + 0.07 * d, beside);

    float edge = 0.0;
    if (v_line.x > 0.0) {
        float far = v_line.y < 0.0 ? -v_line.y - v_own.x : v_line.y - d;
        float pixel = fwidth(d) * arena.w;
        float inside = min(far, beside);
        edge = v_line.x * (1.0 - smoothstep(pixel * 0.6, pixel * 1.6, abs(inside - pixel)));
        fill *= step(0.0, far);
    } else if (v_line.y < 0.0) {
        fill *= step(v_own.x, -v_line.y);
    }
    float alpha = max(fill, edge);
    colour = vec4(v_base.rgb * alpha, alpha);
}
