// Characters of labels: rectangles on the screen.
layout(location = 0) in vec3 corner;
layout(location = 4) in vec4 box;    // x, y, width, height; pixels, y down
layout(location = 5) in vec4 piece;  // x, y in the sheet of characters, pixels
layout(location = 6) in vec4 base;

out vec2 v_texel;
flat out vec4 v_base;

void main() {
    vec2 within = vec2(corner.x * 0.5 + 0.5, 0.5 - corner.y * 0.5) * box.zw;
    v_texel = piece.xy + within;
    v_base = base;
    vec2 at = (box.xy + within) / window.xy * 2.0 - 1.0;
    gl_Position = vec4(at.x, -at.y, 0.0, 1.0);
}
