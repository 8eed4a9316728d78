// Flat marks on the floor: contact shadows and pools of light (shade.frag); rings, memory marks, arrows and the rings
// of coloured sources (mark.frag).
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // x, y, direction
layout(location = 5) in vec4 shape;  // half length, half width, softness or line width, kind
layout(location = 6) in vec4 base;

out vec2 v_own;
flat out vec4 v_shape, v_base;
flat out float v_sharp;  // of shade.frag: shadow: 1 / width of the soft edge; pool: 1 / radius^2

void main() {
    // The quad is larger than the mark: by the softness of a shadow, by the width of a line and a margin. The quad of a
    // pool has the size of the pool.
    const float kind_pool = 1.0;
    // Of a line, whose width is in pixels where it is thin, at least some pixels.
    float pixel = (view_projection * vec4(to_gl(vec3(place.xy, 0.0)), 1.0)).w / eye.w;
    float line = max(2.0 * shape.z + 0.12, 8.0 * pixel * arena.w);
    float beyond = shape.w < kind_pool - 0.5 ? shape.z : shape.w < kind_pool + 0.5 ? 0.0 : line;
    v_own = corner.xy * (shape.xy + beyond);
    v_shape = shape;
    v_base = base;
    v_sharp = shape.w < kind_pool - 0.5 ? 1.0 / (2.2 * shape.z) : 1.0 / (shape.x * shape.x);
    gl_Position = view_projection * vec4(to_gl(vec3(place.xy + turn(v_own, place.zw), 0.004)), 1.0);
}
