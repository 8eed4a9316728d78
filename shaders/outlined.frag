// A sensor field with an outline at its sides and its arc or chord.
in vec2 v_own;
in vec2 v_part;  // 1: at the edge of the arena, along x and y
flat in vec4 v_shape;  // from sector_edges()
flat in vec4 v_base, v_line;

out vec4 colour;

void main() {
    float beside = beside_field(v_own, v_shape), alpha = v_base.w * field_fill(v_own, beside, v_shape);
    if (v_line.y < 0.0 || v_line.x > 0.0) {
        float far = v_line.y < 0.0 ? -v_line.y - v_own.x : v_line.y - length(v_own);
        float within = min(far, beside), pixel = fwidth(within) * arena.w;
        float edge = 1.0 - smoothstep(pixel * 0.4, pixel * 1.2, abs(within - pixel));
        alpha = max(alpha * step(0.0, far), v_line.x * edge);
    }
    colour = field_colour(v_base.rgb, alpha, v_part);
}
