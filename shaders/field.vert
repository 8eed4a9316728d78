// A sensor's field on the floor: one triangle up to 120 degrees, two up to 180, a square beyond. The arc is cut in the
// fragment shader.
layout(location = 0) in vec3 corner;  // x: its number 0..3
layout(location = 4) in vec4 place;   // x, y, direction
layout(location = 5) in vec4 shape;   // range, half the field, d0, reach of the fill
layout(location = 6) in vec4 base;    // w: how strong the fill is
layout(location = 7) in vec4 line;    // x: how strong the edge is; y: radius of the arc, or minus the chord's distance

out vec2 v_own;  // metres, the sensor's axis along x
out vec4 v_shape, v_base, v_line;

void main() {
    int i = int(corner.x + 0.5);
    float half_field = shape.y;
    float reach = line.x > 0.0 ? shape.x * 1.01 : shape.w;
    vec2 own;
    if (half_field < 1.0471976) {
        float arm = reach / cos(half_field);
        float side = i == 1 ? -1.0 : 1.0;
        own = i == 0 || i == 3 ? vec2(0.0) : arm * vec2(cos(half_field), side * sin(half_field));
    } else if (half_field <= 1.5707964) {
        float arm = reach / cos(half_field * 0.5);
        float angle = i == 1 ? -half_field : i == 2 ? 0.0 : half_field;
        own = i == 0 ? vec2(0.0) : arm * vec2(cos(angle), sin(angle));
    } else {
        own = reach * vec2(i == 0 || i == 3 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
    }
    v_own = own;
    v_shape = shape;
    v_base = base;
    v_line = line;
    gl_Position = view_projection * vec4(to_gl(vec3(place.xy + turn(own, place.zw), 0.008)), 1.0);
}
