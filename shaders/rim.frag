in vec4 v_rim;

out vec4 colour;

void main() { colour = vec4(v_rim.rgb * v_rim.a, v_rim.a); }
