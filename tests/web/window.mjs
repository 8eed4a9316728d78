// The window of the desktop beside the page: of the page's size, without settings of the user, with keys and pictures.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import os from "node:os";
import path from "node:path";

import { root } from "./page.mjs";

export const pause = (seconds) => new Promise((done) => setTimeout(done, 1000 * seconds));

const windowId = '"$(xdotool search --onlyvisible --name Braitenlab | tail -n 1)"';

class DesktopWindow {
    constructor(run, folder) {
        this.run = run;
        this.folder = folder;
    }

    // What --state writes.
    state() {
        return this.report("state.json");
    }

    // A file that the window replaces while it runs. One that is half written is read again.
    async report(name) {
        for (let tries = 0; tries < 400; ++tries) {
            const text = await readFile(path.join(this.folder, name), "utf8").catch(() => "");
            if (text.trimEnd().endsWith("}")) return JSON.parse(text);
            await pause(0.05);
        }
        throw new Error("the window does not start");
    }

    // What --anchors writes.
    anchors() {
        return this.report("anchors.json");
    }

    // Waits until check(state, argument) is true.
    async until(check, argument) {
        for (let tries = 0; tries < 400; ++tries) {
            if (check(await this.state(), argument)) return;
            await pause(0.05);
        }
        throw new Error(`never true in the window: ${check}`);
    }

    // Waits until the window has drawn this many frames.
    async frames(count) {
        const begun = (await this.state()).frames;
        await this.until((state) => state.frames >= begun + count);
    }

    // Runs a command with the window's display.
    async command(line) {
        const done = once(this.run.stdout, "data");
        this.run.stdin.write(line + "\n");
        await done;
    }

    key(name) {
        return this.command(`xdotool key ${name}`);
    }

    async click(anchor) {
        const [x, y, w, h] = (await this.anchors())[anchor];
        await this.command(`xdotool mousemove --window ${windowId} ${Math.round(x + w / 2)} ${Math.round(y + h / 2)} click 1`);
    }

    // A PNG picture of the window.
    async picture() {
        const file = path.join(this.folder, "window.png");
        await this.command(`import -window ${windowId} ${file}`);
        return readFile(file);
    }
}

// Opens the window, and closes it after use(window).
export async function withWindow(options, use) {
    const folder = await mkdtemp(path.join(os.tmpdir(), "braitenlab-"));
    const obey = '"$@" >&2 & lab=$!; while IFS= read -r line; do eval "$line" >&2; echo; done; kill $lab; wait $lab';
    const run = spawn("xvfb-run", ["-a", "bash", "-c", obey, "bash", path.join(root, "build/release/braitenlab"),
        ...options, "--size", "1280x800", "--state", path.join(folder, "state.json"), "--anchors", path.join(folder, "anchors.json")],
        { env: { ...process.env, HOME: folder, XDG_STATE_HOME: "", XDG_CONFIG_HOME: "" }, stdio: ["pipe", "pipe", "ignore"] });
    const ended = once(run, "exit");
    try {
        return await use(new DesktopWindow(run, folder));
    } finally {
        run.stdin.end();
        await ended;
        await rm(folder, { recursive: true });
    }
}

// Pictures a second of the lab on a page or in the window.
export async function pace(lab, seconds) {
    const before = await lab.state(), began = performance.now();
    await pause(seconds);
    return ((await lab.state()).frames - before.frames) / ((performance.now() - began) / 1000);
}
