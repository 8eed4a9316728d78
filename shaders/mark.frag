in vec2 v_own;
in vec4 v_shape, v_base;

out vec4 colour;

const int kind_shadow = 0, kind_pool = 1, kind_ring = 2, kind_thin_ring = 3;

float shadow() {
    float soft = v_shape.z;
    vec2 q = abs(v_own) - v_shape.xy + soft;
    float outside = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - soft;
    float t = 1.0 - smoothstep(-soft * 1.2, soft, outside);
    return t * t * (3.0 - 2.0 * t);
}

float pool() {
    float t = max(0.0, 1.0 - dot(v_own, v_own) / (v_shape.x * v_shape.x));
    return t * t * t;
}

void main() {
    int kind = int(v_shape.w + 0.5);
    if (kind == kind_shadow || kind == kind_pool) {
        float alpha = v_base.a * (kind == kind_shadow ? shadow() : pool());
        // Light on a dark floor adds; on a light floor it can only tint.
        float covers = kind == kind_pool ? mix(0.35, 1.0, counts.y) : 1.0;
        colour = vec4(v_base.rgb * alpha, alpha * covers);
        return;
    }
    float d = length(v_own), pixel = fwidth(d);
    float half_width = max(v_shape.z, (kind == kind_ring ? 1.1 : 0.7) * pixel * arena.w);
    float away = abs(d - v_shape.x);
    float line = 1.0 - smoothstep(half_width - pixel * 0.5, half_width + pixel * 0.5, away);
    // The dark edge keeps yellow visible on a white floor.
    float rim_width = half_width + max(0.012, 0.8 * pixel * arena.w);
    float rim = kind == kind_ring ? 1.0 - smoothstep(rim_width - pixel * 0.5, rim_width + pixel * 0.5, away) : 0.0;
    float alpha = max(line, rim * 0.6) * v_base.a;
    colour = vec4(mix(ink.rgb, v_base.rgb, line) * alpha, alpha);
}
