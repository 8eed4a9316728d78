in vec2 v_own;
in vec2 v_place;
flat in vec4 v_shape;  // sine and cosine of half the field; 1/d0^2, negative for a boolean eye; 1/reach^2
flat in vec4 v_base, v_line;

out vec4 colour;

void main() {
    float squared = dot(v_own, v_own), d = sqrt(squared);
    // Metres inside the nearer arm; the arms mirror each other, so one is enough.
    float beside = v_own.x * v_shape.x - abs(v_own.y) * v_shape.y;

    // Keen nearby and weaker farther on, as the eye itself is; edges soften with distance like those of a light cone.
    float rest = max(1.0 - squared * v_shape.w, 0.0);
    float answer = v_shape.z > 0.0 ? rest * rest / (1.0 + squared * v_shape.z) : 0.4 * min(rest * 8.0, 1.0);
    float alpha = v_base.w * answer * clamp(beside / (0.02 + 0.06 * d), 0.0, 1.0);

    if (v_line.y < 0.0 || v_line.x > 0.0) {
        float far = v_line.y < 0.0 ? -v_line.y - v_own.x : v_line.y - d;
        float within = min(far, beside), pixel = fwidth(within) * arena.w;
        float edge = 1.0 - smoothstep(pixel * 0.4, pixel * 1.2, abs(within - pixel));
        alpha = max(alpha * step(0.0, far), v_line.x * edge);
    }
    // Walls end what can be seen; without walls the field goes on.
    vec2 inside = step(abs(v_place), arena.xy + counts.z);
    alpha *= inside.x * inside.y;
    // On a dark floor fields add to each other as light does: covering each other, two colours make mud.
    colour = vec4(v_base.rgb * alpha, alpha * mix(0.45, 1.0, counts.y));
}
