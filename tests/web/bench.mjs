// Prints how fast the page is beside the programs of the desktop, in one session: ./dev bench web [ROUNDS]
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, writeFile } from "node:fs/promises";
import os from "node:os";
import path from "node:path";

import { Lab, longestTask, openBrowser, root, runWindow, serve } from "./page.mjs";
import { pace, pause, withWindow } from "./window.mjs";

const rounds = Number(process.argv[2] ?? 3);
const folder = await mkdtemp(path.join(os.tmpdir(), "braitenlab-"));
const fifty = path.join(folder, "fifty.toml");
const predatorPrey = await readFile(path.join(root, "exercises/scenes/predator-prey.toml"), "utf8");
await writeFile(fifty, predatorPrey.replace(/^population = .*/m, "population = 50"));
const scenes = { "exercise 5": "05-aggressor", "predator-prey": "predator-prey", "50 vehicles": fifty };

const server = await serve(path.join(root, "build/dist/web")), browser = await openBrowser();

// Opens a scene in a page, plays it, and closes the page after use(lab).
async function onPage(scene, use) {
    const lab = await Lab.open(browser, server.address + (scene === fifty ? "?open=empty" : `?open=${scene}&play`));
    try {
        if (scene === fifty) {
            await lab.drop("fifty.toml", await readFile(fifty, "utf8"));
            await lab.until((state) => state.opened === "fifty");
            await lab.page.keyboard.press("Space");
        }
        await lab.until((state) => state.mode === "playing");
        await pause(3);
        return await use(lab);
    } finally {
        await lab.page.context().close();
    }
}

async function picturesASecond(scene) {
    const inWindow = await withWindow([scene, "--play"], async (lab) => {
        await lab.frames(20);
        await pause(3);
        return pace(lab, 5);
    });
    return [await onPage(scene, (lab) => pace(lab, 5)), inWindow];
}

// Work in the background: a document, what starts the work, and [complete parts, all parts].
const background = {
    "cells of a map": ["2a-coward", (lab, key) => key("m"),
        ({ map }) => [map?.cells.flat().filter((cell) => cell !== null).length ?? 0, map?.cells.flat().length]],
    "runs of a study": ["prey-eyes", (lab) => lab.click("study.run"), ({ study }) => [study.done, study.runs]],
};

// Parts a second, from the start until all are complete, for 10 s at most.
async function partsASecond([document, start, count]) {
    const measure = async (lab, key) => {
        await lab.frames(20);
        await start(lab, key);
        const began = performance.now();
        for (;;) {
            const [done, all] = count(await lab.state()), seconds = (performance.now() - began) / 1000;
            if (done === all || seconds > 10) return done / seconds;
            await pause(0.05);
        }
    };
    const inWindow = await withWindow([document], (lab) => measure(lab, (name) => lab.key(name)));
    const lab = await Lab.open(browser, server.address + `?open=${document}`);
    const onPage = await measure(lab, (name) => lab.page.keyboard.press(name));
    await lab.page.context().close();
    return [onPage, inWindow];
}

async function firstPicture() {
    const inWindow = (await runWindow("01-drive")).seconds;
    const lab = await Lab.open(browser, server.address + "?open=01-drive");
    const { startTime } = (await lab.page.evaluate(() => performance.getEntriesByName("first picture").map((e) => e.toJSON())))[0];
    await lab.page.context().close();
    return [startTime / 1000, inWindow];
}

// Processor time of a program, s.
const userTime = (...command) => Number(execFileSync("bash", ["-c", 'TIMEFORMAT=%U; { time "$@" >/dev/null 2>&1; } 2>&1', "bash",
    ...command], { encoding: "utf8", env: { ...process.env, BRAITENLAB_DATA: root } }));

// µs a tick of 50 vehicles, without the start: of 20 minutes less 5.
function tick() {
    const ticks = 15 * 60 * 60;
    const of = (...program) => {
        const run = (minutes) => userTime(...program, "run", fifty, "--seconds", String(60 * minutes), "--threads", "1");
        return (run(20) - run(5)) / ticks * 1e6;
    };
    return [of("node", "--no-experimental-fetch", path.join(root, "build/web/braitenctl.js")),
        of(path.join(root, "build/release/braitenctl"))];
}

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

// Measures `rounds` times and prints the medians; `asked` is the limit of the ratio.
async function row(name, unit, asked, measure) {
    const measured = [];
    for (let i = 0; i < rounds; ++i) measured.push(await measure());
    const [page, desktop] = [0, 1].map((column) => median(measured.map((each) => each[column])));
    const ratio = median(measured.map(([a, b]) => a / b));
    console.log([name.padEnd(28), page.toFixed(2).padStart(8), desktop.toFixed(2).padStart(8), unit.padEnd(12),
        ratio.toFixed(2).padStart(6), asked].join("  "));
}

console.log(`${"".padEnd(28)}      page   desktop  ${"".padEnd(12)}   ratio  asked`);
await row("first picture", "s", "at most 2", firstPicture);
for (const [name, scene] of Object.entries(scenes)) await row(`pictures, ${name}`, "a second", "at least 0.5", () => picturesASecond(scene));
for (const [name, work] of Object.entries(background)) await row(name, "a second", "at least 0.33", () => partsASecond(work));
await row("tick, 50 vehicles", "µs", "at most 2.5", tick);
for (const [name, scene] of [["playing 50 vehicles", fifty], ["playing exercise 5", "05-aggressor"]])
    console.log(`longest task ${name}: ${(await onPage(scene, (lab) => longestTask(lab, () => pause(5)))).toFixed(0)} ms of ` +
        "processor time, asked at most 50");
await browser.close();
server.close();
