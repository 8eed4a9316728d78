uniform sampler2D sheet;

in vec2 v_at;

out vec4 colour;

void main() { colour = texture(sheet, v_at); }
