// Discs on the deck: neurons above the wires, the cross over parts with a lesion (neuron.frag), and the shadows of eyes
// (deck_shade.frag).
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // x, y, height, radius
layout(location = 5) in vec4 base;   // w: size of the value 0..1; -1: crossed out; of a shadow its opacity

out vec2 v_own;
out vec4 v_base;

void main() {
    v_own = corner.xy * 1.15;
    v_base = base;
    gl_Position = view_projection * vec4(to_gl(vec3(place.xy + v_own * place.w, place.z)), 1.0);
}
