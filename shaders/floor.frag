// The floor: a grid of metres that fades before it aliases, and ground outside the arena that fades into the sky. Most
// pixels of a picture are floor, so this shader is short. lamplit.frag adds the light of lamps, brink.frag draws the
// boundary of arenas without walls.
in vec2 v_place;
in float v_far;
in float v_room;
flat in float v_beyond;

out vec4 colour;

void main() {
    float outside = outside_arena(v_place);
    float inside = counts.w == edge_wall ? 1.0 - clamp(outside * 20.0, 0.0, 1.0) : 1.0;
    colour = vec4(faded_floor(floor_at(v_place, inside, within_room(v_room)) * sheen(v_far), v_place, outside, v_beyond), 1.0);
}
