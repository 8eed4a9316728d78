// A sensor's field on the floor: one triangle up to 120 degrees, two up to 180, a square beyond. The arc is cut in the
// fragment shader.
layout(location = 0) in vec3 corner;  // x: its number 0..3
layout(location = 4) in vec4 place;   // x, y, direction
layout(location = 5) in vec4 shape;   // radius that is drawn, half the field, d0, radius where the fill ends
layout(location = 6) in vec4 base;    // w: how strong the fill is
layout(location = 7) in vec4 line;    // x: how strong the edge is; y: radius of the arc, or minus the chord's distance

out vec2 v_own;    // metres, the sensor's axis along x
out vec2 v_place;  // the world's plane
flat out vec4 v_shape, v_base, v_line;

void main() {
    int i = int(corner.x + 0.5);
    float half_field = shape.y, reach = shape.x;
    float c = cos(half_field), s = sin(half_field);
    if (half_field < 1.0471976) {
        v_own = i == 0 || i == 3 ? vec2(0.0) : reach * vec2(1.0, (i == 1 ? -s : s) / c);
    } else if (half_field <= 1.5707964) {
        float arm = reach / cos(half_field * 0.5);
        v_own = i == 0 ? vec2(0.0) : i == 2 ? vec2(arm, 0.0) : arm * vec2(c, i == 1 ? -s : s);
    } else {
        v_own = reach * vec2(i == 0 || i == 3 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
    }
    // A full circle has no arms that could cut it.
    bool whole = half_field >= 3.1415;
    v_shape = vec4(whole ? 0.0 : s, whole ? -1.0 : c, shape.z > 0.0 ? 1.0 / (shape.z * shape.z) : -1.0,
                   1.0 / (shape.w * shape.w));
    v_base = base;
    v_line = line;
    v_place = place.xy + turn(v_own, place.zw);
    gl_Position = view_projection * vec4(to_gl(vec3(v_place, 0.008)), 1.0);
}
