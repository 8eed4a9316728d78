in vec2 v_own;
in vec2 v_part;  // 1: at the edge of the arena, along x and y
flat in vec4 v_shape;  // from sector_edges()
flat in vec4 v_base, v_line;

out vec4 colour;

void main() {
    float squared = dot(v_own, v_own), d = sqrt(squared);
    // Distance inside the nearer side, m; the sides are mirror images.
    float beside = v_own.x * v_shape.x - abs(v_own.y) * v_shape.y;

    // The fill follows the sensor's response to distance; its sides get softer with distance.
    float rest = max(1.0 - squared * v_shape.w, 0.0);
    float answer = v_shape.z > 0.0 ? rest * rest / (1.0 + squared * v_shape.z) : 0.4 * min(rest * 8.0, 1.0);
    float alpha = v_base.w * answer * clamp(beside / (0.02 + 0.06 * d), 0.0, 1.0);

    if (v_line.y < 0.0 || v_line.x > 0.0) {
        float far = v_line.y < 0.0 ? -v_line.y - v_own.x : v_line.y - d;
        float within = min(far, beside), pixel = fwidth(within) * arena.w;
        float edge = 1.0 - smoothstep(pixel * 0.4, pixel * 1.2, abs(within - pixel));
        alpha = max(alpha * step(0.0, far), v_line.x * edge);
    }
    // The field ends at the walls.
    float out_there = form.x < 0.5 ? max(abs(v_part.x), abs(v_part.y)) : dot(v_part, v_part);
    alpha *= step(out_there, 1.0 + counts.z);
    // On a dark floor the colours of overlapping fields are added, because blended colours become grey.
    // In the light theme faint and warm, like light on paper.
    alpha *= mix(0.85, 0.55, counts.y);
    colour = vec4(v_base.rgb * alpha, alpha * mix(0.45, 1.0, counts.y));
}
