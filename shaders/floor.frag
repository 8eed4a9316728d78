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
    if (counts.w == edge_wall) ground *= 1.0 - foot * foot * mix(0.5, 0.18, counts.y);

    float fade = smoothstep(0.0, v_beyond, outside);
    float step_down = clamp(outside * 20.0, 0.0, 1.0) * 0.35;
    if (counts.w == edge_open) {
        // A table's edge: its side falls away, and below there is nothing.
        float side = 1.0 - smoothstep(0.12, 0.5, outside);
        ground = mix(ground, mix(sky.rgb * 0.55, ground * 0.8, side * side), clamp(outside / max(pixel.x, pixel.y), 0.0, 1.0));
        fade = smoothstep(0.1, 0.9, outside);
    }
    if (counts.w != edge_wall) {
        // A line for what is no wall: whole where one falls, dashed where one comes back on the other side.
        float away = max(to_wall, -to_wall), width = max(0.07, 1.5 * max(pixel.x, pixel.y));
        float along = abs(v_place.x) - arena.x > abs(v_place.y) - arena.y ? v_place.y : v_place.x;
        float dash = counts.w == edge_torus ? smoothstep(0.45, 0.55, abs(fract(along / 0.8) - 0.5) * 2.0) : 1.0;
        float line = clamp((width * 0.5 - away) / max(pixel.x, pixel.y) + 0.5, 0.0, 1.0) * dash;
        ground = mix(ground, mix(paper.rgb, ink.rgb, counts.y), line * 0.55);
    }
    colour = vec4(mix(ground, sky.rgb, max(fade, step_down)), 1.0);
}
