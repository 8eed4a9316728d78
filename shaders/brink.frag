// The boundary of an arena without walls, drawn over the floor: the drop of an open arena, or the dashed line of a
// torus.
in vec2 v_place;
flat in float v_beyond;

out vec4 colour;

// Blends a colour over `colour` with the weight `share`.
void cover(vec3 with, float share) { colour = vec4(with * share, share) + colour * (1.0 - share); }

void main() {
    vec2 pixel = fwidth(v_place) + 1e-5, over = abs(v_place) - arena.xy;
    float outside = outside_arena(v_place), to_edge = from_edge(v_place), wide = max(pixel.x, pixel.y);
    colour = vec4(0.0);
    if (counts.w == edge_open) {
        // The drop: a dark side face, then the colour of the sky.
        float side = 1.0 - smoothstep(0.12, 0.5, outside);
        cover(sky.rgb * 0.55, (1.0 - side * side) * clamp(outside / wide, 0.0, 1.0));
        cover(sky.rgb, smoothstep(0.1, 0.9, outside));
    }
    // Solid line for an open arena, dashed for a torus.
    float along = over.x > over.y ? v_place.y : v_place.x;
    float dash = counts.w == edge_torus ? smoothstep(0.45, 0.55, abs(fract(along / 0.8) - 0.5) * 2.0) : 1.0;
    float line = clamp((max(0.07, 1.5 * wide) * 0.5 - abs(to_edge)) / wide + 0.5, 0.0, 1.0) * dash;
    cover(mix(paper.rgb, ink.rgb, counts.y), line * 0.55);
}
