// The floor: a grid of metres that fades before it flickers, and ground that melts into the sky outside the arena. It is
// most of a picture's pixels, so what few arenas need is painted over it by brink.frag.
in vec2 v_place;
flat in float v_beyond;

out vec4 colour;

const float wall_width = 0.22;  // m, as render/view/drawing.h has it

// How much of this pixel a line every `spacing` metres covers, `width` metres wide but never thinner than a pixel, whose
// strength then falls instead. `many` is how many pixels make a metre.
float lines(vec2 place, vec2 pixel, vec2 many, float spacing, float width) {
    vec2 away = abs(fract(place * (1.0 / spacing) - 0.5) - 0.5) * spacing;
    vec2 cover = clamp((max(vec2(width), pixel) * 0.5 - away) * many + 0.5, 0.0, 1.0) * min(width * many, 1.0);
    cover *= clamp((0.5 - pixel * (1.0 / spacing)) * 3.0, 0.0, 1.0);
    return max(cover.x, cover.y);
}

void main() {
    vec2 pixel = fwidth(v_place) + 1e-5, many = 1.0 / pixel;
    vec2 over = abs(v_place) - arena.xy;  // the arena's edges
    float outside = length(max(over, 0.0));

    // A stage: a touch brighter amid the arena, the ground outside a step darker and soon gone.
    vec2 from_middle = v_place / arena.xy;
    float middle = max(0.0, 1.0 - 0.5 * dot(from_middle, from_middle)) * (1.0 - counts.y) * 0.35;
    float faint = max(middle, lines(v_place, pixel, many, 1.0, 0.022) * 0.9);
    float bright = lines(v_place, pixel, many, 5.0, 0.05);
    vec3 bright_line = mix(grid_colour.rgb, mix(paper.rgb, ink.rgb, counts.y), 0.10);
    vec3 ground = mix(mix(floor_colour.rgb, grid_colour.rgb, faint), bright_line, bright);

    // Walls stand on the floor: it is darker at their feet, on both sides.
    float to_wall = max(over.x, over.y);
    float foot = clamp(1.0 - max(-to_wall, to_wall - wall_width) / 0.4, 0.0, 1.0);
    ground *= 1.0 - foot * foot * (counts.w == edge_wall ? mix(0.5, 0.18, counts.y) : 0.0);

    float fade = max(smoothstep(0.0, v_beyond, outside), min(outside * 20.0, 1.0) * 0.35);
    colour = vec4(mix(ground, sky.rgb, fade), 1.0);
}
