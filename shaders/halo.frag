in vec2 v_own;
in vec4 v_base;

out vec4 colour;

void main() {
    float d = dot(v_own, v_own), t = max(0.0, 1.0 - d);
    float glow = v_base.a * t * t * (0.35 + 0.65 * exp(-9.0 * d));
    colour = vec4(v_base.rgb * glow, glow * mix(0.15, 1.0, counts.y));
}
