in vec2 v_place;
in vec4 v_colour;

out vec4 colour;

void main() {
    float alpha = v_colour.a * (1.0 - smoothstep(0.7, 1.0, length(v_place)));
    colour = vec4(v_colour.rgb * alpha, alpha);
}
