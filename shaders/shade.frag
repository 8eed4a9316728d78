// Contact shadows and pools of light. Separate from mark.frag because they cover much of the floor and a software
// renderer executes every branch.
in vec2 v_own;
in vec4 v_shape, v_base;

out vec4 colour;

const int kind_shadow = 0;

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
    bool is_shadow = v_shape.w < float(kind_shadow) + 0.5;
    float alpha = v_base.a * (is_shadow ? shadow() : pool());
    // Light is added on a dark floor and blended on a light one.
    float covers = is_shadow ? 1.0 : mix(0.35, 1.0, counts.y);
    colour = vec4(v_base.rgb * alpha, alpha * covers);
}
