// The glow of a source: a disc that faces the camera.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // x, y, height, radius
layout(location = 5) in vec4 base;

out vec2 v_own;
out vec4 v_base;
flat out float v_bulb;  // squared radius of the bulb, as v_own

void main() {
    v_own = corner.xy;
    v_base = base;
    vec3 middle = to_gl(vec3(place.xy, place.z));
    // Moved towards the camera, so that the floor behind does not cut it, and perpendicular to the ray from the camera:
    // the outline of the bulb, a ball, is a circle on such a plane.
    vec3 towards = eye.xyz - middle;
    float far = length(towards);
    towards /= far;
    vec3 right = normalize(cross(picture_up.xyz, towards)), up = cross(towards, right);
    float nearer = 0.8 * place.w;
    // The bulb's radius is 0.168 of the glow's on a dark floor, 0.247 on a light one (add_source in
    // render/view/draw_world.cpp); the glow is nearer and looks larger.
    float share = mix(0.168, 0.247, counts.y), around = share * place.w / far;
    float radius = share * (1.0 - nearer / far) / sqrt(max(1.0 - around * around, 0.1));
    v_bulb = radius * radius;
    vec3 at = middle + (right * corner.x + up * corner.y) * place.w + towards * nearer;
    gl_Position = view_projection * vec4(at, 1.0);
}
