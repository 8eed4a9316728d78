// The glow of a source: a disc that faces the camera.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 place;  // x, y, height, radius
layout(location = 5) in vec4 base;
layout(location = 6) in vec4 around;  // x: radius of what it surrounds, a share of its own; y: 1: a ball

out vec2 v_own;
out vec4 v_base;
flat out float v_bulb;  // squared radius of what it surrounds, as v_own; 0: nothing
flat out float v_ball;

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
    // The glow is nearer than the bulb, which therefore covers a smaller share of it.
    float outline = around.x * place.w / far;
    float radius = around.x * (1.0 - nearer / far) / sqrt(max(1.0 - outline * outline, 0.1));
    v_bulb = radius * radius;
    v_ball = around.y;
    vec3 at = middle + (right * corner.x + up * corner.y) * place.w + towards * nearer;
    gl_Position = view_projection * vec4(at, 1.0);
}
