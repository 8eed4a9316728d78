// A sensor field without an outline. Fields cover much of the floor and a software renderer executes every branch, so
// outlined.frag is a shader of its own.
in vec2 v_own;
in vec2 v_part;
flat in vec4 v_shape;
flat in vec4 v_base, v_line;

out vec4 colour;

void main() {
    colour = field_colour(v_base.rgb, v_base.w * field_fill(v_own, beside_field(v_own, v_shape), v_shape), v_part);
}
