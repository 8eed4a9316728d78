// Zones of the floor: each surface has its own texture, each effect its own sign (chevrons, rings, plus signs). Patterns
// are in metres and fade before they alias.
in vec2 v_own;
in float v_room;
flat in vec4 v_shape, v_base, v_flow, v_corners_01, v_corners_23, v_corners_45, v_corners_67;

out vec4 colour;

const int pattern_ice = 0, pattern_carpet = 1, pattern_sand = 2, pattern_tape = 3, pattern_recharge = 4,
          pattern_wind = 5, pattern_slope = 6, pattern_pull = 7, pattern_push = 8;

vec2 zone_corner(int i) {
    vec4 two = i < 2 ? v_corners_01 : i < 4 ? v_corners_23 : i < 6 ? v_corners_45 : v_corners_67;
    return (i & 1) == 0 ? two.xy : two.zw;
}

// Distance inside the zone's edge, m; negative outside.
float inside_edge() {
    int count = int(v_shape.z + 0.5);
    if (count > 2) {
        float within = 1e9;
        for (int i = 0; i < count; ++i) {
            vec2 here = zone_corner(i), along = normalize(zone_corner((i + 1) % count) - here), to = v_own - here;
            within = min(within, along.x * to.y - along.y * to.x);
        }
        return within;
    }
    if (v_shape.z > 0.5) {
        float k = length(v_own / v_shape.xy);
        return (1.0 - k) * k / max(length(v_own / (v_shape.xy * v_shape.xy)), 1e-4);
    }
    vec2 within = v_shape.xy - abs(v_own);
    return min(within.x, within.y);
}

float noise_of(vec2 cell) { return fract(sin(dot(cell, vec2(12.9898, 78.233))) * 43758.5453); }

// Coverage by a line of `width` metres at a distance of `away` metres from its middle.
float line_at(float away, float width, float pixel) {
    return 1.0 - smoothstep(width * 0.5 - pixel * 0.5, width * 0.5 + pixel * 0.5, abs(away));
}

// Visibility 0..1 of a pattern that repeats every `spacing` metres.
float keen(float pixel, float spacing) { return 1.0 - smoothstep(0.25, 0.6, pixel / spacing); }

// Rows of chevrons that point and move along +x.
float chevrons(vec2 at, float speed, float pixel) {
    const float spacing = 0.8, lane = 0.7;
    float row = floor(at.y / lane), across = at.y - (row + 0.5) * lane;
    float shifted = at.x - speed * arena.z + 0.37 * mod(row, 2.0) * spacing;
    float along = (fract(shifted / spacing) - 0.5) * spacing;
    return line_at(along + abs(across) * 0.9, 0.08, pixel) * step(abs(across), 0.22) * keen(pixel, 0.5);
}

float plus_signs(vec2 at, float pixel) {
    const float spacing = 0.8;
    vec2 own = abs((fract(at / spacing) - 0.5) * spacing);
    vec2 arm = 1.0 - smoothstep(vec2(0.03) - pixel * 0.5, vec2(0.03) + pixel * 0.5, own);
    return max(arm.x * step(own.y, 0.13), arm.y * step(own.x, 0.13)) * keen(pixel, 0.3);
}

void main() {
    int pattern = int(v_shape.w + 0.5);
    float pixel = max(length(fwidth(v_own)) * 0.7, 1e-4);
    float within = inside_edge();
    float cover = clamp(within / pixel + 0.5, 0.0, 1.0);
    float edge = line_at(within - 0.03, 0.04, pixel);
    vec3 tone = v_base.rgb, pale = mix(v_base.rgb, vec3(1.0), 0.55);
    float alpha = v_base.a;

    if (pattern == pattern_ice) {
        // Diagonal glints of varying brightness.
        float slant = v_own.x + v_own.y * 0.8, along = v_own.y - v_own.x * 0.8;
        float glint = line_at(fract(slant / 0.9) * 0.9 - 0.45, 0.05, pixel) * smoothstep(0.1, 0.7, sin(along * 1.7 + floor(slant / 0.9) * 2.4));
        tone = mix(tone, pale, max(glint * 0.8 * keen(pixel, 0.3), edge * 0.5));
    } else if (pattern == pattern_carpet) {
        vec2 weave = fract(v_own / 0.16);
        float over = abs(step(0.5, weave.x) - step(0.5, weave.y)) - 0.5;
        tone *= 1.0 + 0.22 * over * keen(pixel, 0.16);
        tone = mix(tone, pale, edge * 0.35);
    } else if (pattern == pattern_sand) {
        tone *= 1.0 + 0.30 * (noise_of(floor(v_own / 0.06)) - 0.5) * keen(pixel, 0.06);
        tone *= 1.0 + 0.06 * sin(v_own.x * 7.0 + 1.5 * sin(v_own.y * 1.3));
    } else if (pattern == pattern_recharge) {
        alpha *= max(max(plus_signs(v_own, pixel), edge), 0.16);
    } else if (pattern == pattern_slope) {
        // Darker downhill; the chevrons do not move.
        vec2 down = vec2(dot(v_own, v_flow.xy), dot(v_own, vec2(-v_flow.y, v_flow.x)));
        alpha *= max(max(chevrons(down, 0.0, pixel), edge * 0.6), 0.10 + 0.16 * v_flow.z * down.x / max(v_shape.x, 0.1));
    } else if (pattern == pattern_wind) {
        vec2 lee = vec2(dot(v_own, v_flow.xy), dot(v_own, vec2(-v_flow.y, v_flow.x)));
        alpha *= max(chevrons(lee, 0.6 + 1.4 * v_flow.z, pixel), edge * 0.5);
    } else if (pattern == pattern_pull || pattern == pattern_push) {
        float d = length(v_own), way = pattern == pattern_pull ? 1.0 : -1.0;
        float ring = line_at((fract(d / 0.8 + way * arena.z * (0.2 + 0.5 * v_flow.z)) - 0.5) * 0.8, 0.05, pixel);
        alpha *= max(ring * keen(pixel, 0.4) * (0.35 + 0.65 * exp(-d * 0.5)), edge * 0.5);
    }
    alpha *= cover;
    colour = vec4(tone * v_room * alpha, alpha);
}
