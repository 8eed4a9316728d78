// The floor: a grid of metres that fades before it aliases, light from lamps, and ground outside the arena that fades
// into the sky. Most
// pixels of a picture are floor, so this shader is short. brink.frag draws the boundary of arenas without walls.
in vec2 v_place;
flat in float v_beyond;

out vec4 colour;

const float wall_width = 0.22;  // m, as in render/view/drawing.h

// Coverage of this pixel by lines every `spacing` metres, `width` metres wide. Lines narrower than a pixel are drawn
// one pixel wide and fainter. `many`: pixels per metre.
float lines(vec2 place, vec2 pixel, vec2 many, float spacing, float width) {
    vec2 away = abs(fract(place * (1.0 / spacing) - 0.5) - 0.5) * spacing;
    vec2 cover = clamp((max(vec2(width), pixel) * 0.5 - away) * many + 0.5, 0.0, 1.0) * min(width * many, 1.0);
    cover *= clamp((0.5 - pixel * (1.0 / spacing)) * 3.0, 0.0, 1.0);
    return max(cover.x, cover.y);
}

void main() {
    vec2 pixel = fwidth(v_place) + 1e-5, many = 1.0 / pixel;
    float outside = outside_arena(v_place);

    // Slightly brighter at the centre of the arena. Outside walls the ground is a plain table.
    vec2 from_middle = v_place / arena.xy;
    float middle = max(0.0, 1.0 - 0.5 * dot(from_middle, from_middle)) * (1.0 - counts.y) * 0.25;
    float inside = counts.w == edge_wall ? 1.0 - clamp(outside * 20.0, 0.0, 1.0) : 1.0;
    float faint = max(middle, lines(v_place, pixel, many, 1.0, 0.016) * 0.75) * inside;
    float bright = lines(v_place, pixel, many, 5.0, 0.032) * inside;
    vec3 bright_line = mix(grid_colour.rgb, mix(paper.rgb, ink.rgb, counts.y), 0.10);
    vec3 ground = mix(mix(floor_colour.rgb, grid_colour.rgb, faint), bright_line, bright);

    // Light from lamps, also reflected by the lines of the grid. Walls keep it inside.
    if (law.z > 0.5) {
        vec3 light = ground * ground, glow = vec3(0.0);
        for (int i = 0; i < int(law.z); ++i) glow += lamp_on_floor(i, v_place);
        float reflects = dot(light, vec3(1.0)) / dot(floor_colour.rgb * floor_colour.rgb, vec3(1.0));
        float passes = mix(mix(0.12, 1.0, inside), 1.0, float(counts.w != edge_wall));
        ground = on_screen(light + glow * (min(0.75 + 0.25 * reflects, 1.4) * passes));
    }

    // The floor is darker at the foot of walls, on both sides.
    float to_wall = from_edge(v_place);
    float foot = clamp(1.0 - max(-to_wall, to_wall - wall_width) / 0.4, 0.0, 1.0);
    ground *= 1.0 - foot * foot * (counts.w == edge_wall ? mix(0.5, 0.18, counts.y) : 0.0);

    float fade = max(smoothstep(0.0, 0.8 * v_beyond, outside), min(outside * 20.0, 1.0) * (counts.w == edge_wall ? 0.72 : 0.35));
    colour = vec4(mix(ground, sky.rgb, fade), 1.0);
}
