in vec2 v_own;
flat in vec4 v_shape, v_base;

out vec4 colour;

const int kind_ring = 2, kind_thin_ring = 3, kind_memory = 4, kind_arrow = 5,
          kind_whole_socket = 6, kind_dashed_socket = 7, kind_dotted_socket = 8;

// A mark of a vehicle's memory: a soft disc with a cross in a ring.
vec4 memory(float pixel) {
    float d = length(v_own), line = max(v_shape.z, 1.2 * pixel);
    float ring = 1.0 - smoothstep(0.5 - 0.5 * pixel / line, 0.5 + 0.5 * pixel / line, abs(d - v_shape.x) / line);
    vec2 slanted = abs(vec2(v_own.x + v_own.y, v_own.x - v_own.y)) * 0.70711;
    float away = min(slanted.x, slanted.y);
    float arms = (1.0 - smoothstep(line * 0.5 - pixel * 0.5, line * 0.5 + pixel * 0.5, away)) * step(d, v_shape.x * 0.55);
    float fill = 0.22 * (1.0 - smoothstep(v_shape.x - pixel, v_shape.x, d));
    float alpha = v_base.a * max(max(ring, arms), fill);
    return vec4(v_base.rgb * alpha, alpha);
}

// An arrow along +x, as long as the mark.
vec4 arrow(float pixel) {
    float head = min(v_shape.x * 1.4, 0.24);
    float along = v_own.x + v_shape.x, across = abs(v_own.y);
    float shaft = min(v_shape.y * 0.34 - across, min(along, 2.0 * v_shape.x - head * 0.9 - along));
    float tip = min((2.0 * v_shape.x - along) * v_shape.y / head - across, along - (2.0 * v_shape.x - head));
    float within = max(shaft, tip), rim = max(v_shape.z, pixel);
    float body = clamp(within / pixel + 0.5, 0.0, 1.0), all = clamp((within + rim) / pixel + 0.5, 0.0, 1.0);
    float alpha = v_base.a * max(body, all * 0.8);
    return vec4(mix(ink.rgb, v_base.rgb, body) * alpha, alpha);
}

// A ring around the foot of a coloured source. Red, green and blue have different dash patterns, so that they can be
// distinguished without colour.
vec4 socket(int kind, float d, float pixel) {
    float line = max(v_shape.z, 0.8 * pixel * arena.w);
    float ring = 1.0 - smoothstep(line - pixel * 0.5, line + pixel * 0.5, abs(d - v_shape.x));
    float parts = kind == kind_dashed_socket ? 4.0 : 12.0, turn = atan(v_own.y, v_own.x) / 6.2831853 + 0.5;
    float dash = smoothstep(0.40, 0.55, abs(fract(turn * parts) - 0.5) * 2.0);
    float alpha = v_base.a * ring * (kind == kind_whole_socket ? 1.0 : dash);
    return vec4(v_base.rgb * alpha, alpha);
}

void main() {
    int kind = int(v_shape.w + 0.5);
    if (kind == kind_memory || kind == kind_arrow) {
        float pixel = length(fwidth(v_own)) * 0.7;
        colour = kind == kind_memory ? memory(pixel) : arrow(pixel);
        return;
    }
    float d = length(v_own), pixel = fwidth(d);
    if (kind >= kind_whole_socket) {
        colour = socket(kind, d, pixel);
        return;
    }
    // By day yellow has little contrast with the floor: the ring and its dark outline are wider.
    float day = counts.y, stroke = pixel * arena.w;
    float half_width = max(v_shape.z, (kind == kind_ring ? 1.1 + 0.4 * day : 0.7) * stroke);
    float away = abs(d - v_shape.x);
    float line = 1.0 - smoothstep(half_width - pixel * 0.5, half_width + pixel * 0.5, away);
    float rim_width = half_width + max(0.012, (0.8 + 0.5 * day) * stroke);
    float rim = kind == kind_ring ? 1.0 - smoothstep(rim_width - pixel * 0.5, rim_width + pixel * 0.5, away) : 0.0;
    float alpha = max(line, rim * (0.6 + 0.25 * day)) * v_base.a;
    colour = vec4(mix(ink.rgb, v_base.rgb, line) * alpha, alpha);
}
