// A sensor field as one point; sector.geom expands it.
layout(location = 4) in vec4 place;
layout(location = 5) in vec4 shape;
layout(location = 6) in vec4 base;
layout(location = 7) in vec4 line;

out vec4 g_place, g_shape, g_base, g_line;

void main() {
    g_place = place;
    g_shape = shape;
    g_base = base;
    g_line = line;
}
