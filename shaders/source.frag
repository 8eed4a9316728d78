in vec3 v_core, v_rim;
in vec3 v_normal, v_towards;
in vec4 v_edge;

out vec4 colour;

void main() {
    float facing = max(dot(normalize(v_normal), normalize(v_towards)), 0.0);
    vec3 shown = mix(v_rim, v_core, smoothstep(0.25, 0.9, facing));
    colour = vec4(mix(shown, v_edge.rgb, v_edge.a * (1.0 - smoothstep(0.0, 0.6, facing))), 1.0);
}
