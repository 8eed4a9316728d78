// The floor of floor.frag in the light of lamps. A shader of its own, because a software renderer executes every branch.
in vec2 v_place;
in float v_far;
in float v_room;
flat in float v_beyond;

out vec4 colour;

void main() {
    float outside = outside_arena(v_place);
    float inside = counts.w == edge_wall ? 1.0 - clamp(outside * 20.0, 0.0, 1.0) : 1.0;
    float room = within_room(v_room);
    vec3 ground = floor_at(v_place, inside, room) * sheen(v_far), light = ground * ground, glow = vec3(0.0);
    for (int i = 0; i < int(law.z); ++i) glow += lamp_on_floor(i, v_place);
    // The lines of the grid reflect more of it. Walls keep it inside.
    float reflects = dot(light, vec3(1.0)) / (room * room * dot(floor_colour.rgb * floor_colour.rgb, vec3(1.0)));
    float passes = mix(0.12, 1.0, inside);
    // Between dark and light a floor becomes warm, not grey or white: part of its blue becomes orange. By day the
    // sum of the light falls by nearly half of that part, so that the floor is not nearly white.
    float warmed = min(mix(0.5, 0.18, counts.y) * light.b, mix(0.8, 0.9, counts.y) * glow.r) * passes;
    light += warmed * vec3(mix(vec2(0.85, 0.15), vec2(0.53, 0.0), counts.y), -1.0);
    ground = on_screen(light + glow * (min(0.75 + 0.25 * reflects, 1.4) * passes));
    colour = vec4(faded_floor(ground, v_place, outside, v_beyond), 1.0);
}
