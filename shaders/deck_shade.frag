// The shadow at the foot of an eye, on the deck.
in vec2 v_own;  // of neuron.vert
in vec4 v_base;

out vec4 colour;

void main() {
    float near = max(1.0 - dot(v_own, v_own), 0.0);
    float alpha = v_base.a * near * near * (3.0 - 2.0 * near);
    colour = vec4(v_base.rgb * alpha, alpha);
}
