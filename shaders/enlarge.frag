in vec2 v_at;

uniform sampler2D picture;

out vec4 colour;

void main() { colour = texture(picture, v_at); }
