in vec2 v_own;
in vec4 v_base;

out vec4 colour;

void main() {
    float d = dot(v_own, v_own), t = max(0.0, 1.0 - d);
    float glow = v_base.a * t * t * (0.35 + 0.65 * exp(-9.0 * d));
        // In the light theme a pale glow, because nothing is brighter than the floor.
    colour = vec4(mix(v_base.rgb, mix(v_base.rgb, vec3(1.0), 0.55), counts.y) * glow, glow * mix(0.25, 1.0, counts.y));
}
