in vec2 v_texel;
flat in vec4 v_base;

uniform sampler2D sheet;

out vec4 colour;

// The glyph pixel by pixel as in the sheet, with an outline in the sky's colour that separates it from the background.
void main() {
    ivec2 at = ivec2(floor(v_texel));
    float ink_here = texelFetch(sheet, at, 0).r, near = 0.0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            // The sheet has empty pixels around every character. Clamping keeps reads inside the sheet.
            ivec2 beside = clamp(at + ivec2(x, y), ivec2(0), textureSize(sheet, 0) - 1);
            near = max(near, texelFetch(sheet, beside, 0).r * (1.0 - 0.16 * float(x * x + y * y)));
        }
    float alpha = max(ink_here, 0.75 * clamp(near, 0.0, 1.0)) * v_base.a;
    colour = vec4(mix(sky.rgb, v_base.rgb, ink_here) * alpha, alpha);
}
