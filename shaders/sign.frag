in vec3 v_own;
flat in vec4 v_base;
flat in vec2 v_seen;

out vec4 colour;

const float rim_width = 0.14;
const vec2 wheel = vec2(0.0, 0.46), wheel_half = vec2(0.18, 0.06);
const vec2 eye_place = vec2(0.23, 0.24), eye_half = vec2(0.07, 0.06);
const float arrow_tail = -0.3, arrow_tip = 0.08, arrow_half = 0.2;

// Coverage of this pixel by a box centred on `middle` and by its mirror image at -y.
float in_boxes(vec2 own, vec2 pixel, vec2 middle, vec2 half_size) {
    vec2 within = clamp((half_size - abs(vec2(own.x, abs(own.y)) - middle)) / pixel + 0.5, 0.0, 1.0);
    return within.x * within.y;
}

void main() {
    vec3 pixel = fwidth(v_own) + 1e-5;
    vec3 rim = mix(v_base.rgb, mix(mix(v_base.rgb, vec3(1.0), 0.55), mix(ink.rgb, v_base.rgb, 0.2), counts.y),
                   0.6 * v_base.w);
    float brightness = dot(v_base.rgb, vec3(0.30, 0.59, 0.11));
    vec3 arrow = mix(v_base.rgb, brightness > 0.55 ? ink.rgb : vec3(1.0), 0.25 + 0.65 * v_base.w);
    vec3 eyes = mix(ink.rgb, vec3(1.0), 0.25 + 0.75 * (v_own.y > 0.0 ? v_seen.x : v_seen.y));

    vec3 tone = v_base.rgb * sqrt(sky_light.rgb + sun.y * sun_light.rgb);
    tone = mix(tone, rim, clamp((rim_width - v_own.z) / pixel.z + 0.5, 0.0, 1.0));
    tone = mix(tone, ink.rgb, in_boxes(v_own.xy, pixel.xy, wheel, wheel_half));
    tone = mix(tone, eyes, in_boxes(v_own.xy, pixel.xy, eye_place, eye_half));
    float across = arrow_half * (arrow_tip - v_own.x) / (arrow_tip - arrow_tail) - abs(v_own.y);
    vec2 on_arrow = clamp(vec2(v_own.x - arrow_tail, across) / pixel.xy + 0.5, 0.0, 1.0);
    colour = vec4(mix(tone, arrow, on_arrow.x * on_arrow.y), 1.0);
}
