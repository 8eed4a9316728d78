// A sensor's field from its point: one triangle below 120 degrees, two up to 180, a square beyond. The arc is cut in
// field.frag, so that a field costs three or four vertices and not a fan of them.
layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

in vec4 g_place[1], g_shape[1], g_base[1], g_line[1];

out vec2 v_own;
out vec2 v_place;
flat out vec4 v_shape, v_base, v_line;

void main() {
    int count = sector_corner_count(g_shape[0].y);
    // A strip's corners in the order that makes two triangles of the same four.
    for (int k = 0; k < count; ++k) {
        int i = count == 4 && k > 1 ? 5 - k : k;
        v_own = sector_corner(i, g_shape[0]);
        v_place = g_place[0].xy + turn(v_own, g_place[0].zw);
        v_shape = sector_edges(g_shape[0]);
        v_base = g_base[0];
        v_line = g_line[0];
        gl_Position = view_projection * vec4(to_gl(vec3(v_place, sector_height)), 1.0);
        EmitVertex();
    }
    EndPrimitive();
}
