// The floor: a grid of metres that fades before it flickers, and ground that melts into the sky outside the arena.
in vec2 v_place;
flat in float v_beyond;

out vec4 colour;

const float wall_width = 0.22;  // m, as render/view/draw_list.cpp builds them

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

    // A stage: a touch brighter amid the arena, the ground outside a step darker and soon gone.
    vec2 from_middle = v_place / arena.xy;
    float middle = max(0.0, 1.0 - 0.5 * dot(from_middle, from_middle));
    vec3 ground = mix(floor_colour.rgb, grid_colour.rgb, (1.0 - counts.y) * 0.35 * middle);
    vec3 bright_line = mix(grid_colour.rgb, mix(paper.rgb, ink.rgb, counts.y), 0.10);
    ground = mix(ground, grid_colour.rgb, lines(v_place, pixel, 1.0, 0.022) * 0.9);
    ground = mix(ground, bright_line, lines(v_place, pixel, 5.0, 0.05));

    // Walls stand on the floor: it is darker at their feet, on both sides.
    float to_wall = max(abs(v_place.x) - arena.x, abs(v_place.y) - arena.y);
    float foot = clamp(1.0 - max(-to_wall, to_wall - wall_width) / 0.4, 0.0, 1.0);
    if (counts.z == 0.0) ground *= 1.0 - foot * foot * mix(0.5, 0.18, counts.y);

    float fade = smoothstep(0.0, v_beyond, outside);
    float step_down = clamp(outside * 20.0, 0.0, 1.0) * 0.35;
    colour = vec4(mix(ground, sky.rgb, max(fade, step_down)), 1.0);
}
