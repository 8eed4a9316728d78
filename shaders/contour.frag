in vec2 v_sample;
in vec2 v_place;
flat in vec3 v_base;

uniform sampler2D sheet;  // 0..1

out vec4 colour;

const float levels = 10.0;

void main() {
    float felt = texture(sheet, v_sample).r;
    float height = felt * levels, slope = max(fwidth(height), 1e-5);
    // A line at every tenth, twice as wide at 0.5. Dividing by the slope makes the width independent of it.
    float away = abs(fract(height - 0.5) - 0.5) / slope;
    float level = floor(height + 0.5);
    float wide = arena.w * (abs(level - 5.0) < 0.5 ? 1.4 : 0.7);
    float line = 1.0 - smoothstep(wide - 0.5, wide + 0.5, away);
    line *= step(0.5, level) * step(level, levels - 0.5) * (1.0 - smoothstep(0.4, 0.9, slope));
    // A faint line where the intensity becomes 0.
    float rim = 1.0 - smoothstep(arena.w * 0.7 - 0.5, arena.w * 0.7 + 0.5, abs(height - 0.1) / slope);
    float band = floor(height) / levels;
    float alpha = max(max(line * 0.62, rim * 0.28), felt > 0.001 ? 0.04 + 0.34 * band : 0.0);
    alpha *= step(from_edge(v_place), 0.001);  // the texture is a rectangle, the arena may be round
    vec3 tone = mix(v_base, mix(vec3(1.0), v_base * 0.6, counts.y), line * 0.35);
    colour = vec4(tone * alpha, alpha * mix(0.6, 1.0, counts.y));
}
