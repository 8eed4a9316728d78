in vec2 v_own;
in vec4 v_base;

out vec4 colour;

void main() {
    float d = length(v_own), pixel = fwidth(d);
    if (d > 1.0 + pixel * 0.5) discard;
    if (v_base.a < 0.0) {
        vec2 slanted = abs(vec2(v_own.x + v_own.y, v_own.x - v_own.y)) * 0.70711;
        float away = min(slanted.x, slanted.y);
        float arms = (1.0 - smoothstep(0.17 - pixel * 0.5, 0.17 + pixel * 0.5, away)) * step(d, 0.66);
        colour = vec4(mix(ink.rgb, vec3(0.95), max(arms, smoothstep(0.78 - pixel, 0.78 + pixel, d))), 1.0);
        return;
    }
    // Dark at 0, coloured at 1, brightest in the centre.
    vec3 rest = mix(ink.rgb, v_base.rgb, 0.30), awake = mix(v_base.rgb, vec3(1.0), 0.45 * (1.0 - d * d));
    vec3 fill = mix(rest, awake, v_base.a);
    float rim = smoothstep(0.72 - pixel, 0.72 + pixel, d);
    colour = vec4(mix(fill, mix(v_base.rgb, vec3(1.0), 0.25), rim), 1.0);
}
