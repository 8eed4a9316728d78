in vec3 v_core, v_rim;
in vec3 v_normal, v_towards;

out vec4 colour;

void main() {
    float facing = max(dot(normalize(v_normal), normalize(v_towards)), 0.0);
    colour = vec4(mix(v_rim, v_core, smoothstep(0.25, 0.9, facing)), 1.0);
}
