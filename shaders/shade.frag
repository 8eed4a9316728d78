// Contact shadows and pools of light. Separate from mark.frag because they cover much of the floor and a software
// renderer executes every branch.
in vec2 v_own;
flat in vec4 v_shape, v_base;
flat in float v_sharp;

out vec4 colour;

const int kind_shadow = 0;

float smooth_share(float t) { return t * t * (3.0 - 2.0 * t); }

float shadow() {
    // From 1.2 times the softness inside the edge to the softness outside it, along both axes.
    vec2 t = clamp((v_shape.xy + v_shape.z - abs(v_own)) * v_sharp, 0.0, 1.0);
    return smooth_share(smooth_share(t.x) * smooth_share(t.y));
}

float pool() {
    float t = max(0.0, 1.0 - dot(v_own, v_own) * v_sharp);
    return t * t * t;
}

void main() {
    bool is_shadow = v_shape.w < float(kind_shadow) + 0.5;
    float alpha = v_base.a * (is_shadow ? shadow() : pool());
    // Light is added on a dark floor and blended on a light one.
    float covers = is_shadow ? 1.0 : mix(0.35, 1.0, counts.y);
    colour = vec4(v_base.rgb * alpha, alpha * covers);
}
