in vec3 v_colour;
in vec3 v_empty;
in vec2 v_gauge;

out vec4 colour;

void main() { colour = vec4(v_gauge.x <= v_gauge.y ? v_colour : v_empty, 1.0); }
