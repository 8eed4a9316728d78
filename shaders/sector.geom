// Expands one point to a sensor field with sector_corner_count() corners. field.frag clips the polygon to the arc, so
// that a field has three or four vertices instead of a fan.
layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

in vec4 g_place[1], g_shape[1], g_base[1], g_line[1];

out vec2 v_own;
out vec2 v_part;
flat out vec4 v_shape, v_base, v_line;

void main() {
    int count = sector_corner_count(g_shape[0].y);
    // The order of the corners in a triangle strip.
    for (int k = 0; k < count; ++k) {
        int i = count == 4 && k > 1 ? 5 - k : k;
        v_own = sector_corner(i, g_shape[0]);
        vec2 at = g_place[0].xy + turn(v_own, g_place[0].zw);
        v_part = at / arena.xy;
        v_shape = sector_edges(g_shape[0]);
        v_base = g_base[0];
        v_line = g_line[0];
        gl_Position = view_projection * vec4(to_gl(vec3(at, sector_height)), 1.0);
        EmitVertex();
    }
    EndPrimitive();
}
