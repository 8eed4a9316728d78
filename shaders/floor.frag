// The floor: a grid of metres that fades before it flickers, and ground that melts into the sky outside the arena.
in vec2 v_place;

out vec4 colour;

// How much of this pixel a line every `spacing` metres covers, `width` metres wide but never thinner than a pixel, whose
// strength then falls instead.
float lines(vec2 place, vec2 pixel, float spacing, float width) {
    vec2 drawn = max(vec2(width), pixel);
    vec2 away = abs(fract(place / spacing - 0.5) - 0.5) * spacing;
    vec2 cover = clamp((drawn * 0.5 - away) / pixel + 0.5, 0.0, 1.0) * (width / drawn);
    cover *= 1.0 - smoothstep(0.15, 0.5, pixel / spacing);
    return max(cover.x, cover.y);
}

void main() {
    vec2 pixel = fwidth(v_place) + 1e-5;
    vec2 beyond = max(abs(v_place) - arena.xy, 0.0);
    float outside = length(beyond);
    float size = max(arena.x, arena.y);

    // A stage: a touch brighter amid the arena, the ground outside a step darker, gone after half an arena.
    float middle = 1.0 - smoothstep(0.0, 1.3, length(v_place / arena.xy) * 0.8);
    vec3 inside_colour = mix(floor_colour.rgb, grid_colour.rgb, (1.0 - counts.y) * 0.22 * middle);
    float minor = lines(v_place, pixel, 1.0, 0.022), major = lines(v_place, pixel, 5.0, 0.05);
    vec3 line_colour = mix(grid_colour.rgb, ink.rgb, counts.y * 0.06);
    vec3 bright_line = mix(grid_colour.rgb, mix(paper.rgb, ink.rgb, counts.y), 0.10);
    vec3 ground = mix(inside_colour, line_colour, minor * 0.85);
    ground = mix(ground, bright_line, major);

    float fade = smoothstep(0.0, 0.55 * size, outside);
    float step_down = smoothstep(0.0, 0.05, outside) * 0.35;
    float distance_fade = smoothstep(25.0, 160.0, distance(eye.xyz, to_gl(vec3(v_place, 0.0))) - length(arena.xy) * 2.0);
    colour = vec4(mix(ground, sky.rgb, max(max(fade, step_down), distance_fade)), 1.0);
}
