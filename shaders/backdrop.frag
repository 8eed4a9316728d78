uniform sampler2D sheet;

out vec4 colour;

void main() { colour = vec4(texelFetch(sheet, ivec2(gl_FragCoord.xy - window.zw), 0).rgb, 1.0); }
