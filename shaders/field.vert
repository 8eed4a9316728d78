// A sensor field without geometry shaders (else sector.vert, sector.geom): four corners per instance. For a narrow
// field, which has three corners, the fourth is at the apex.
layout(location = 0) in vec3 corner;  // x: number of the corner, 0..3
layout(location = 4) in vec4 place;   // x, y, direction
layout(location = 5) in vec4 shape;   // drawn radius, half the opening angle, d0, radius where the fill ends
layout(location = 6) in vec4 base;    // w: strength of the fill
layout(location = 7) in vec4 line;    // x: strength of the outline; y: radius of the arc, or minus the chord's distance

out vec2 v_own;    // metres, the sensor's axis along x
out vec2 v_part;  // of the arena's half sides
flat out vec4 v_shape, v_base, v_line;

void main() {
    int i = int(corner.x + 0.5);
    v_own = sector_corner(i < sector_corner_count(shape.y) ? i : 0, shape);
    vec2 at = place.xy + turn(v_own, place.zw);
    v_part = at / arena.xy;
    v_shape = sector_edges(shape);
    v_base = base;
    v_line = line;
    gl_Position = view_projection * vec4(to_gl(vec3(at, sector_height)), 1.0);
}
