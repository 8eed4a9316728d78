// The shadow around the feet of the prisms of block.vert.
in float v_far;

out vec4 colour;

void main() {
    float t = clamp(1.0 - v_far, 0.0, 1.0);
    float share = t * t * (3.0 - 2.0 * t) * mix(1.0, 0.8, counts.y);
    colour = vec4(shadow_colour.rgb, 1.0) * (shadow_colour.a * share);
}
