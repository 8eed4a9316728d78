in vec3 v_own;
in vec3 v_light;
in vec3 v_gloss;
flat in vec4 v_base;
flat in vec4 v_lid;

out vec4 colour;

// 1 where `value` is above `edge`, antialiased.
float above(float edge, float value) {
    float soft = max(fwidth(value), 1e-4);
    return clamp((value - edge) / soft + 0.5, 0.0, 1.0);
}

void main() {
    vec3 own = v_own;
    float reading = v_lid.w;
    // Angles from the gaze: the iris ends at 43 degrees, the pupil at 24.
    float iris = above(0.73, own.x), ring = above(0.80, own.x), pupil = above(0.915, own.x);
    float lid = above(0.12, dot(own, vec3(-0.72, 0.0, 0.69)));
    float highlight = above(0.975, dot(own, vec3(0.88, 0.27, 0.39)));

    // The channel's colour with little white: a pale iris is hardly different from the ball.
    vec3 pure = v_base.rgb - 0.7 * min(min(v_base.r, v_base.g), v_base.b);
    pure *= max(max(v_base.r, v_base.g), v_base.b) / max(max(max(pure.r, pure.g), pure.b), 1e-3);
    vec3 glass = mix(pure * pure * 0.55, pure, 0.70 + 0.30 * reading);
    vec3 bright = mix(lit(glass * 0.95, v_light), mix(pure, vec3(1.0), 0.25 * reading), 0.40 + 0.60 * reading);
    vec3 seen = mix(lit(vec3(0.93, 0.94, 0.96), v_light), bright * 0.72, iris);
    seen = mix(seen, bright, ring);
    seen = mix(seen, ink.rgb * 0.6, pupil);
    seen = mix(seen, vec3(1.0), highlight);
    vec3 skin = lit(mix(v_lid.rgb, v_base.rgb, 0.25 * reading), v_light) + v_gloss;
    seen = mix(seen, skin, lid);
    if (v_base.w < 0.5) {
        // Covered: a closed lid with a cross.
        float thin = max(fwidth(own.y), 1e-4) * 1.2;
        float arms = abs(abs(own.y) - abs(own.z));
        float cross = (1.0 - smoothstep(0.09, 0.09 + thin, arms)) * step(0.62, own.x);
        seen = mix(mix(skin, lit(ink.rgb, v_light), iris), vec3(0.95), cross);
    }
    if (dot(own, own) < 0.01) seen = lit(mix(ink.rgb, vec3(0.3), 0.2), v_light);
    colour = vec4(seen, 1.0);
}
