#!/bin/bash
# WebGL 2 in Chromium: a copy into the canvas is erased by the draw call that follows it.
#
# Guess before the first run: blitFramebuffer into the canvas is kept like any drawing; what is drawn later in the same frame
# lies over it, as in OpenGL and OpenGL ES.
# Seen: once the canvas has been shown it is erased at the first clear or draw call of the next frame. A blit is neither: it
# does not erase the canvas and does not count as drawing, so the draw call after it erases the copy. A clear of the
# depth buffer before the blit keeps it. No error is raised. The same in Chromium 131 and 156.
set -euo pipefail
dir=$(mktemp -d) && trap 'rm -rf "$dir"' EXIT && cd "$dir"
export TMPDIR=$dir

# expect WHAT SEEN WANTED: a difference means that the behaviour has changed.
expect() {
    printf '%-58s %s\n' "$1" "$2"
    [ "$2" = "$3" ] || { echo "changed: it was $3"; exit 1; }
}

# The package holds the browser; its shared libraries are those of Debian's package chromium.
npm install --silent --no-audit --no-fund --prefix "$dir" @sparticuz/chromium@131.0.1 playwright-core@1.52.0 > /dev/null
cat > ask.mjs <<'CODE'
import packed from "@sparticuz/chromium";
import { chromium } from "playwright-core";
const browser = await chromium.launch({
    executablePath: await packed.executablePath(), args: [...packed.args, "--enable-unsafe-swiftshader"] });
const page = await browser.newPage();
await page.setContent("<canvas width=64 height=64></canvas>");
const seen = await page.evaluate(async () => {
    const gl = document.querySelector("canvas").getContext("webgl2", { antialias: false });
    const shader = (kind, text) => {
        const made = gl.createShader(kind);
        gl.shaderSource(made, "#version 300 es\nprecision highp float;\n" + text);
        gl.compileShader(made);
        return made;
    };
    const dot = gl.createProgram();  // a red dot in a corner
    gl.attachShader(dot, shader(gl.VERTEX_SHADER, "void main() { gl_Position = vec4(-.9, -.9, 0, 1); gl_PointSize = 2.; }"));
    gl.attachShader(dot, shader(gl.FRAGMENT_SHADER, "out vec4 c; void main() { c = vec4(1, 0, 0, 1); }"));
    gl.linkProgram(dot);
    gl.useProgram(dot);

    const stored = gl.createFramebuffer();  // green
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, 64, 64);
    gl.bindFramebuffer(gl.FRAMEBUFFER, stored);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
    gl.clearColor(0, 1, 0, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);

    const steps = {
        blit: () => {
            gl.bindFramebuffer(gl.READ_FRAMEBUFFER, stored);
            gl.blitFramebuffer(0, 0, 64, 64, 0, 0, 64, 64, gl.COLOR_BUFFER_BIT, gl.NEAREST);
            gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
        },
        draw: () => gl.drawArrays(gl.POINTS, 0, 1),
        clear: () => gl.clear(gl.DEPTH_BUFFER_BIT),
    };
    const shown = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const found = [];
    for (const order of ["blit draw", "clear blit draw", "draw blit"]) {
        gl.clear(gl.COLOR_BUFFER_BIT);
        await shown();
        for (const step of order.split(" ")) steps[step]();
        const pixel = new Uint8Array(4);
        gl.readPixels(32, 32, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        found.push(pixel[1]);
        await shown();
    }
    return found;
});
console.log(browser.version(), ...seen);
await browser.close();
CODE
answer=$(node ask.mjs)
read -r version first second third <<< "$answer"
echo "Chromium $version"
expect "green in the middle after blit, draw" "$first" 0
expect "after a clear of the depth, blit, draw" "$second" 255
expect "after draw, blit" "$third" 255
