// A page of the lab in headless Chromium, with a web server of its own.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import os from "node:os";
import path from "node:path";
import { after, before } from "node:test";

// playwright-core is in build/web-tests, where ./dev web installs it.
export const root = path.resolve(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), "../..");
const { chromium } = createRequire(path.join(root, "build/web-tests/"))("playwright-core");

const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };

// Serves a folder at a free port, without compression; returns the address and the bytes sent so far.
export async function serve(folder) {
    let sent = 0;
    const server = createServer(async (request, response) => {
        const name = new URL(request.url, "http://localhost").pathname.replace(/\/$/, "/index.html");
        try {
            const content = await readFile(path.join(folder, path.normalize(name)));
            response.writeHead(200, { "Content-Type": types[path.extname(name)] ?? "application/octet-stream" });
            response.end(content);
            sent += content.length;
        } catch {
            response.writeHead(404).end();
        }
    });
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    return { address: `http://127.0.0.1:${server.address().port}/`, sent: () => sent, close: () => server.close() };
}

// WebGL by SwiftShader, a software renderer. `extra`: further switches.
const program = (extra = []) => ({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", ...extra],
});
export const openBrowser = (extra) => chromium.launch(program(extra));

// A browser with the settings and the storage of a user, who has this folder.
export function openUser(folder) {
    return chromium.launchPersistentContext(folder, { ...program(), viewport: { width: 1280, height: 800 }, locale: "en-US", colorScheme: "dark" });
}

// Runs the window of the desktop without settings of the user until it has written its picture. For keys: window.mjs.
export async function runWindow(...options) {
    const folder = await mkdtemp(path.join(os.tmpdir(), "braitenlab-"));
    const file = path.join(folder, "window.png");
    const timed = 'a=$(date +%s%N); "$@" >&2; echo $(($(date +%s%N) - a))';  // without the start of the X server
    const ns = execFileSync("xvfb-run", ["-a", "bash", "-ec", timed, "bash", path.join(root, "build/release/braitenlab"),
        ...options, "--size", "1280x800", "--screenshot", file],
        { env: { ...process.env, HOME: folder, XDG_STATE_HOME: "", XDG_CONFIG_HOME: "" } });
    return { file, seconds: Number(ns) / 1e9 };
}

// For the tests of one file: a server and a browser of their own, and withLab(query, use, options), which opens a page of
// the lab and fails on errors of the page. `options`: of the browser's context; `init` runs in the page before the lab.
export function useLabs() {
    const shared = {
        async withLab(query, use, { init, ...options } = {}) {
            const lab = await Lab.open(shared.browser, shared.server.address + query, options, init);
            try {
                await use(lab);
                assert.deepEqual(lab.errors, []);
            } finally {
                await lab.page.context().close();
            }
        },
        // The squares of 20 pixels of the picture that the window of the desktop writes, without settings of the user.
        async pictureOfWindow(...options) {
            return squaresOf(shared.browser, await readFile((await runWindow(...options)).file), 20);
        },
        // Seconds from the start of the window to its end after its first picture.
        async secondsOfWindow(...options) {
            return (await runWindow(...options)).seconds;
        },
        // The same of a page; the picture is kept in build/web-tests.
        async pictureOfPage(lab, name) {
            return squaresOf(shared.browser, await lab.page.screenshot({ path: path.join(root, `build/web-tests/${name}.png`) }), 20);
        },
    };
    before(async () => {
        shared.server = await serve(path.join(root, "build/dist/web"));
        shared.browser = await openBrowser();
    });
    after(async () => {
        await shared.browser?.close();
        shared.server?.close();
    });
    return shared;
}

// Mean colours of the squares of `side` pixels of a PNG picture, row by row: [[red, green, blue], …], 0 to 255.
export async function squaresOf(browser, png, side) {
    const page = await browser.newPage();
    const squares = await page.evaluate(async ([base64, side]) => {
        const bitmap = await createImageBitmap(await (await fetch("data:image/png;base64," + base64)).blob());
        const size = { width: Math.floor(bitmap.width / side), height: Math.floor(bitmap.height / side) };
        const canvas = new OffscreenCanvas(size.width, size.height).getContext("2d");
        const small = await createImageBitmap(bitmap, { resizeWidth: size.width, resizeHeight: size.height, resizeQuality: "medium" });
        canvas.drawImage(small, 0, 0);
        const bytes = canvas.getImageData(0, 0, size.width, size.height).data;
        return Array.from({ length: bytes.length / 4 }, (_, i) => Array.from(bytes.slice(4 * i, 4 * i + 3)));
    }, [png.toString("base64"), side]);
    await page.close();
    return squares;
}

// The share of the squares that differ by more than `levels` in a colour.
export function differing(a, b, levels) {
    return a.filter((colour, i) => colour.some((value, c) => Math.abs(value - b[i][c]) > levels)).length / a.length;
}

// The squares of 20 pixels, of a picture 1280 pixels wide, that are wholly inside a rectangle [x, y, width, height].
export function squaresInside(squares, [x, y, w, h]) {
    const side = 20, columns = 1280 / side;
    return squares.filter((_, i) => {
        const left = side * (i % columns), top = side * Math.floor(i / columns);
        return left >= x && top >= y && left + side <= x + w && top + side <= y + h;
    });
}

// Processor time in ms of the longest task of the page's main thread while `work` runs. Unlike a task's duration it does
// not depend on what else the machine does.
export async function longestTask(lab, work) {
    const browser = lab.page.context().browser();
    await browser.startTracing(lab.page, { categories: ["toplevel", "devtools.timeline"] });
    await work();
    const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
    const drawing = traceEvents.find((event) => event.name === "FireAnimationFrame");
    assert.ok(drawing, "the page draws");
    const own = traceEvents.filter((event) => event.pid === drawing.pid && event.tid === drawing.tid);
    const tasks = own.filter((event) => event.name.endsWith("RunTask") && event.tdur);
    assert.ok(tasks.length > 20, `only ${tasks.length} tasks`);
    return Math.max(...tasks.map((event) => event.tdur)) / 1000;
}

// The lab in a page of the browser.
export class Lab {
    constructor(page) {
        this.page = page;
        this.errors = [];
        page.on("pageerror", (error) => this.errors.push(String(error)));
        page.on("console", (message) => {
            if (message.type() === "error" || /GL_INVALID|WebGL:/.test(message.text())) this.errors.push(message.text());
        });
    }

    static async open(browser, address, options = {}, init) {
        const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, locale: "en-US", colorScheme: "dark", ...options });
        if (init) await context.addInitScript(init);
        return Lab.openIn(context, address);
    }

    // Another page of the same user.
    static async openIn(context, address) {
        const lab = new Lab(await context.newPage());
        await lab.go(address);
        return lab;
    }

    async go(address) {
        await this.page.goto(address);
        await this.ready();
    }

    async ready() {
        await this.page.waitForFunction(() => window.braitenlab?.ready, null, { timeout: 60000 });
    }

    state() {
        return this.page.evaluate(() => window.braitenlab.state());
    }

    anchors() {
        return this.page.evaluate(() => window.braitenlab.anchors());
    }

    // Waits until check(state, argument) is true; the check runs in the page.
    async until(check, argument, what = String(check)) {
        const text = `(${check})(window.braitenlab.state(), ${JSON.stringify(argument ?? null)})`;
        try {
            await this.page.waitForFunction(text, null, { timeout: 20000 });
        } catch {
            throw new Error(`never true: ${what}`);
        }
    }

    async rectangle(anchor) {
        for (let tries = 0; tries < 100; ++tries) {
            const found = (await this.anchors())[anchor];
            if (found) return found;
            await this.page.waitForTimeout(50);
        }
        throw new Error(`no ${anchor} in the window; there are: ${Object.keys(await this.anchors()).join(" ")}`);
    }

    async middle(anchor) {
        const [x, y, w, h] = await this.rectangle(anchor);
        return [x + w / 2, y + h / 2];
    }

    async click(anchor) {
        await this.page.mouse.click(...await this.middle(anchor));
    }

    // Presses at one place, moves in steps, releases at another.
    async drag([x0, y0], [x1, y1], steps = 12) {
        const { mouse } = this.page;
        await mouse.move(x0, y0);
        await this.frames(2);
        await mouse.down();
        await this.frames(2);
        for (let i = 1; i <= steps; ++i) {
            await mouse.move(x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps);
            await this.frames(1);
        }
        await mouse.up();
        await this.frames(2);
    }

    // Drops a file with this text onto the page.
    drop(name, text) {
        return this.page.evaluate(([file, content]) => {
            const dataTransfer = new DataTransfer();
            dataTransfer.items.add(new File([content], file));
            dispatchEvent(new DragEvent("drop", { dataTransfer, cancelable: true }));
        }, [name, text]);
    }

    // Puts fingers onto the page at the first places, moves them to the others, lifts them. They move at once: fingers
    // that rest for half a second, two frames of a busy machine, ask for a menu.
    async touch(places) {
        const session = await this.page.context().newCDPSession(this.page);
        const send = (type, at) => session.send("Input.dispatchTouchEvent",
            { type, touchPoints: at.map(([x, y], id) => ({ x, y, id })) });
        await Promise.all([send("touchStart", places[0]), send("touchMove", places[1])]);
        for (const at of places.slice(2)) {
            await this.frames(2);
            await send("touchMove", at);
        }
        await this.frames(2);
        await send("touchEnd", []);
        await this.frames(2);
    }

    // Waits until the lab has drawn this many frames.
    async frames(count) {
        const begun = (await this.state()).frames;
        await this.page.waitForFunction((until) => window.braitenlab.state().frames >= until, begun + count);
    }
}
