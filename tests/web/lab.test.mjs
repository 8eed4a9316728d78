// The lab in headless Chromium, with a real mouse and keyboard: node --test, by ./dev web.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtemp, readFile, writeFile } from "node:fs/promises";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";

import { largeScene } from "./large.mjs";
import { pause, withWindow } from "./window.mjs";
import { Lab, differing, longestTask, openBrowser, root, squaresInside, squaresOf, useLabs } from "./page.mjs";

const limit = { timeout: 120000 };
const labs = useLabs();
const { withLab, pictureOfWindow, secondsOfWindow, pictureOfPage } = labs;

test("The first picture takes at most twice as long as that of the window", limit, async () => {
    const onPage = [], inWindow = [];
    for (let i = 0; i < 3; ++i) {
        inWindow.push(await secondsOfWindow("01-drive"));
        await withLab("?open=01-drive", async (lab) => {
            onPage.push(await lab.page.evaluate(() => performance.getEntriesByName("first picture")[0].startTime / 1000));
        });
    }
    const words = (times) => times.map((t) => t.toFixed(2)).join(", ");
    console.log(`first picture after ${words(onPage)} s, in the window ${words(inWindow)} s`);
    assert.ok(Math.min(...onPage) < 2 * Math.min(...inWindow));
});

test("The first start shows the title page, Begin the first exercise", limit, () =>
    withLab("", async (lab) => {
        await lab.click("title.begin");
        await lab.until((state) => state.exercise?.id === "01-drive");
    }));

test("Exercise 1 is solved by its slider", limit, () =>
    withLab("?open=01-drive", async (lab) => {
        await lab.click("exercise.predict.2");
        await lab.until((state) => state.exercise.predicted === 1);
        const [x, y, w, h] = await lab.rectangle("bias.RM");
        await lab.page.mouse.click(x + w / 2, y + h / 2);
        await lab.until((state) => state.focus === "bias.RM");
        for (let i = 0; i < 40 && Math.abs((await lab.state()).weights.RM - 0.3) > 0.024; ++i) {
            await lab.page.keyboard.press((await lab.state()).weights.RM < 0.3 ? "ArrowRight" : "ArrowLeft");
            await lab.frames(2);
        }
        await lab.page.keyboard.press("Escape");
        await lab.page.keyboard.press("Space");
        await lab.until((state) => state.exercise.steps.every((step) => step.done), null);
        await lab.until((state) => state.exercise.passed, null, "exercise passed");
    }));

test("A paused scene stays as in the window", limit, async () => {
    const inWindow = await pictureOfWindow("2a-coward", "--after", "3");
    await withLab("?open=2a-coward", async (lab) => {
        await lab.frames(24);  // at rest the scene is copied
        const onPage = await pictureOfPage(lab, "paused");
        assert.ok(differing(onPage, inWindow, 24) < 0.03, `${differing(onPage, inWindow, 24)} of the picture differs`);
    });
});

// Pictures of the scene at rest, of the same in the corner of the wiring editor, and after the editor, of a lab on the
// page or in the window. `take`: returns a PNG picture of the lab. Each picture has the rectangle of its scene.
async function threeAtRest(lab, key, take) {
    const atRest = async (mode) => {
        await lab.until((state, wanted) => state.mode === wanted, mode);
        await pause(2);  // the picture is stored and copied
        await lab.frames(2);
        return { png: await take(lab), scene: (await lab.anchors()).viewport };
    };
    const before = await atRest("paused");
    await key("w");
    const beside = await atRest("wiring");
    await key("w");
    return [before, beside, await atRest("paused")];
}

for (const quality of ["low", "medium"])
    test(`At ${quality} quality a paused scene stays, also beside the wiring editor and after it`, { timeout: 300000 }, async () => {
        const inWindow = await withWindow(["2a-coward", `--quality=${quality}`], async (lab) => {
            await lab.frames(4);
            return threeAtRest(lab, (key) => lab.key(key), () => lab.picture());
        });
        await withLab(`?open=2a-coward&quality=${quality}`, async (lab) => {
            const onPage = await threeAtRest(lab, (key) => lab.page.keyboard.press(key), () => lab.page.screenshot());
            const shares = [];
            for (const [i, { png, scene }] of onPage.entries()) {
                const [page, window] = await Promise.all([png, inWindow[i].png].map((each) => squaresOf(labs.browser, each, 20)));
                const squares = squaresInside(page, scene);
                assert.ok(squares.length > 50, `only ${squares.length} squares in ${scene}`);
                shares.push(differing(squares, squaresInside(window, inWindow[i].scene), 24));
            }
            console.log(`${quality} quality: ${shares.map((share) => (100 * share).toFixed(1)).join(", ")} % of the scene differ`);
            assert.ok(Math.max(...shares) < 0.05, `${shares} of the scene differ`);
        });
    });

test("A playing scene is as in the window", limit, async () => {
    const inWindow = await pictureOfWindow("2a-coward", "--play", "--after", "2");
    await withLab("?open=2a-coward", async (lab) => {
        await lab.page.keyboard.press("Space");
        await lab.until((state) => state.tick >= 110);
        const onPage = await pictureOfPage(lab, "playing");
        assert.ok(differing(onPage, inWindow, 24) < 0.08, `${differing(onPage, inWindow, 24)} of the picture differs`);
    });
});

test("A drag moves a slider, and undo takes it back", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const before = (await lab.state()).weights.LL;
        const [x, y, w, h] = await lab.rectangle("slider.LL");
        await lab.drag([x + w * 0.5, y + h / 2], [x + w * 0.62, y + h / 2]);
        await lab.until((state, old) => state.weights.LL !== old, before);
        await lab.page.keyboard.press("Escape");
        await lab.page.keyboard.press("Control+z");
        await lab.until((state, old) => state.weights.LL === old, before);
    }));

test("A wire is drawn in the diagram", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        await lab.page.keyboard.press("w");
        await lab.until((state) => state.mode === "wiring");
        await lab.frames(4);
        const before = (await lab.state()).wires;
        await lab.drag(await lab.middle("pin.SL.out"), await lab.middle("pin.MR.in"));
        await lab.until((state, old) => state.wires === old + 1, before);
    }));

test("A scene is saved as a download and opened again by upload", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const { page } = lab;
        await page.keyboard.press("Control+s");
        await lab.until((state) => state.focus === "files.path");
        await page.keyboard.press("Control+a");
        await page.keyboard.type("my own");
        const download = page.waitForEvent("download");
        await page.keyboard.press("Enter");
        const saved = await download;
        assert.equal(saved.suggestedFilename(), "my own.toml");
        const text = await readFile(await saved.path(), "utf8");
        assert.match(text, /\[kind\.coward\]/);

        const file = path.join(await mkdtemp(path.join(os.tmpdir(), "braitenlab-")), "hers.toml");
        await writeFile(file, text.replace(/^title = .*$/m, 'title = "Hers"'));
        await page.keyboard.press("Control+o");
        const chooser = page.waitForEvent("filechooser");
        await lab.click("files.upload");
        await (await chooser).setFiles(file);
        await lab.until((state) => state.opened === "hers");
    }));

test("A broken file is refused with its line", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        await lab.drop("broken.toml", 'format = 1\ntitle = "x\n');
        await lab.until((state) => /broken\.toml/.test(JSON.stringify(state.notice)));
        assert.equal((await lab.state()).opened, "2a-coward");
    }));

test("A reload offers the work back", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const before = (await lab.state()).weights.LL;
        const [x, y, w, h] = await lab.rectangle("slider.LL");
        await lab.drag([x + w * 0.5, y + h / 2], [x + w * 0.62, y + h / 2]);
        await lab.until((state, old) => state.weights.LL !== old, before);
        const edited = (await lab.state()).weights.LL;
        await lab.page.reload();
        await lab.ready();
        await lab.click("recovery.take");
        await lab.until((state, value) => state.weights.LL === value, edited);
    }));

test("The language is the browser's", limit, () =>
    withLab("?open=2a-coward", async (lab) => assert.equal((await lab.state()).language, "de"), { locale: "de-AT" }));

test("Text is pasted from the clipboard", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        await lab.page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
        await lab.page.evaluate(() => navigator.clipboard.writeText("größer"));
        await lab.page.keyboard.press("Control+s");
        await lab.until((state) => state.focus === "files.path");
        await lab.page.keyboard.press("Control+a");
        await lab.page.keyboard.press("Control+v");
        await lab.until((state) => state.typed === "größer");
    }));

// Scenes and exercises in the address.

// Copies a link by the menu; returns it.
async function copiedLink(lab) {
    await lab.page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await lab.click("menu.file");
    await lab.click("menu.file.copy_link");
    await lab.until((state) => /^\d+$/.test(state.notice), null, "the notice with the length");
    return lab.page.evaluate(() => navigator.clipboard.readText());
}

async function turnSlider(lab, anchor) {
    const before = (await lab.state()).weights;
    const [x, y, w, h] = await lab.rectangle(anchor);
    await lab.drag([x + w * 0.5, y + h / 2], [x + w * 0.62, y + h / 2]);
    await lab.until((state, old) => JSON.stringify(state.weights) !== old, JSON.stringify(before));
    await lab.page.keyboard.press("Escape");
    return (await lab.state()).weights;
}

test("A copied link opens the edited scene in another browser", limit, async () => {
    let link, edited;
    await withLab("?open=2a-coward&lang=en", async (lab) => {
        edited = await turnSlider(lab, "slider.LL");
        link = await copiedLink(lab);
    });
    assert.ok(link.startsWith(labs.server.address + "#b1."), link);
    await withLab(link.slice(labs.server.address.length), async (lab) => {
        assert.deepEqual((await lab.state()).weights, edited);
        assert.equal((await lab.state()).exercise, null);
    });
});

test("A link to an exercise opens it", limit, () =>
    withLab("#e1.05-aggressor", async (lab) => {
        await lab.until((state) => state.exercise?.id === "05-aggressor");
        assert.equal(await copiedLink(lab), labs.server.address + "#e1.05-aggressor");
    }));

test("A new link in the address asks about unsaved work first", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const edited = await turnSlider(lab, "slider.LL");
        await lab.page.evaluate(() => (location.hash = "#e1.05-aggressor"));
        await lab.rectangle("leaving.discard");
        await lab.frames(3);  // the sheet takes its place
        assert.deepEqual((await lab.state()).weights, edited);
        await lab.click("leaving.discard");
        await lab.until((state) => state.exercise?.id === "05-aggressor");
    }));

test("A broken link is refused and leaves the open work alone", limit, async () => {
    await withLab("?open=2a-coward", async (lab) => {
        const edited = await turnSlider(lab, "slider.LL");
        for (const [link, reason] of [["#b1.eNpLyy", /incomplete/], ["#b9.eNpLyy", /version/], ["#b1.!!", /characters/]]) {
            await lab.page.evaluate((hash) => (location.hash = hash), link);
            await lab.until((state, text) => new RegExp(text).test(JSON.stringify(state.notice)), reason.source);
            assert.deepEqual((await lab.state()).weights, edited);
        }
    });
    await withLab("#e1.05-agressor", (lab) => lab.until((state) => /05-aggressor/.test(JSON.stringify(state.notice))));
    // At the start the lab opens its first exercise instead.
    await withLab("#b1.eNpLyy", async (lab) => {
        await lab.until((state) => /incomplete/.test(JSON.stringify(state.notice)));
        assert.equal((await lab.state()).exercise.id, "01-drive");
    });
});

test("A link is opened by pasting it", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        await lab.page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
        await lab.page.evaluate(() => navigator.clipboard.writeText("https://lab.example/#e1.05-aggressor"));
        await lab.page.keyboard.press("Control+v");
        await lab.until((state) => state.exercise?.id === "05-aggressor");
    }));

test("Keys of the browser are left to it", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const kept = await lab.page.evaluate(() =>
            [["t", true], ["w", true], ["r", true], ["F5", false], ["F12", false], ["F11", false], ["z", true], ["w", false]]
                .map(([key, ctrlKey]) => [key, ctrlKey, !dispatchEvent(
                    new KeyboardEvent("keydown", { key, ctrlKey, bubbles: true, cancelable: true }))])
                .filter(([, , taken]) => taken).map(([key, ctrl]) => (ctrl ? "Ctrl+" : "") + key));
        assert.deepEqual(kept, ["Ctrl+z", "w"]);
    }));

test("On a display of double density the picture is sharp and widgets are where the mouse is", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        assert.deepEqual(await lab.page.evaluate(() => [Module.canvas.width, Module.canvas.height]), [1600, 1200]);
        await lab.click("button.play");
        await lab.until((state) => state.mode === "playing");
    }, { viewport: { width: 800, height: 600 }, deviceScaleFactor: 2 }));

test("A finger presses a button and drags a slider, two fingers zoom", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        await lab.page.touchscreen.tap(...await lab.middle("button.play"));
        await lab.until((state) => state.mode === "playing");
        await lab.page.touchscreen.tap(...await lab.middle("button.play"));
        const before = await lab.state();
        const [x, y, w, h] = await lab.rectangle("slider.LL");
        await lab.touch([[[x + w * 0.5, y + h / 2]], [[x + w * 0.55, y + h / 2]], [[x + w * 0.62, y + h / 2]]]);
        await lab.until((state, old) => state.weights.LL !== old, before.weights.LL);
        const [vx, vy, vw, vh] = await lab.rectangle("viewport");
        const fingers = (apart) => [[vx + vw / 2 - apart, vy + vh / 2], [vx + vw / 2 + apart, vy + vh / 2]];
        await lab.touch([fingers(40), fingers(60), fingers(80), fingers(120)]);
        await lab.until((state, old) => JSON.stringify(state.view) !== old, JSON.stringify(before.view));
    }, { hasTouch: true }));

test("Two fingers that turn turn the view", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const before = (await lab.state()).view.azimuth;
        const [vx, vy, vw, vh] = await lab.rectangle("viewport");
        const fingers = (angle) => [1, -1].map((side) =>
            [vx + vw / 2 + side * 80 * Math.cos(angle), vy + vh / 2 + side * 80 * Math.sin(angle)]);
        await lab.touch([0, 0.1, 0.2, 0.3, 0.4, 0.5].map(fingers));  // set and lifted one after the other
        // The scene follows the fingers, which turn clockwise on the screen.
        await lab.until((state, old) => Math.abs(state.view.azimuth - old - 0.5) < 0.02, before, "turned by half a radian");
    }, { hasTouch: true }));

test("Two fingers zoom the diagram", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        await lab.page.keyboard.press("w");
        await lab.until((state) => state.mode === "wiring");
        await lab.frames(4);
        const apart = async () => (await lab.middle("pin.MR.in"))[0] - (await lab.middle("pin.SL.out"))[0];
        const before = await apart(), [x, y, w, h] = await lab.rectangle("canvas");
        const fingers = (reach) => [[x + w / 2 - reach, y + h * 0.8], [x + w / 2 + reach, y + h * 0.8]];
        await lab.touch([fingers(120), fingers(100), fingers(80), fingers(60)]);
        await lab.frames(2);
        const after = await apart();
        assert.ok(Math.abs(after) < 0.8 * Math.abs(before), `${before} to ${after}`);
    }, { hasTouch: true }));

test("Pins reach farther for a finger than for the mouse", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        await lab.page.keyboard.press("w");
        await lab.until((state) => state.mode === "wiring");
        await lab.frames(4);
        const wires = (await lab.state()).wires;
        const beside = async (anchor) => (await lab.middle(anchor)).map((v, i) => v + (i === 1 ? 20 : 0));
        const [from, to] = [await beside("pin.SL.out"), await beside("pin.MR.in")];
        const half = from.map((v, i) => (v + to[i]) / 2);
        await lab.touch([[from], [half], [to], [to]]);
        await lab.until((state, old) => state.wires === old + 1, wires);
        await lab.page.screenshot({ path: path.join(root, "build/web-tests/touch.png") });
        await lab.page.keyboard.press("Control+z");
        await lab.until((state, old) => state.wires === old, wires);
        await lab.drag(from, to);
        await lab.frames(4);
        assert.equal((await lab.state()).wires, wires);
    }, { hasTouch: true }));

test("A text field asks for the keyboard on the screen, whose characters are typed", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const { page } = lab;
        const focused = () => page.evaluate(() => document.activeElement.id);
        assert.notEqual(await focused(), "typing");
        await page.keyboard.press("Control+s");
        await lab.until((state) => state.focus === "files.path");
        await page.waitForFunction(() => document.activeElement.id === "typing");
        await page.keyboard.press("Control+a");
        await page.keyboard.press("Backspace");
        await page.keyboard.insertText("héllo");  // without key events, as a keyboard on the screen
        await lab.until((state) => state.typed === "héllo");
        // An input method replaces what it has shown.
        const session = await page.context().newCDPSession(page);
        for (const text of ["n", "ni", "你"])
            await session.send("Input.imeSetComposition", { text, selectionStart: text.length, selectionEnd: text.length });
        await session.send("Input.insertText", { text: "你" });
        await lab.until((state) => state.typed === "héllo你");
        await page.keyboard.type("ab");
        await lab.until((state) => state.typed === "héllo你ab");
        await page.keyboard.press("Escape");
        await page.keyboard.press("Escape");
        await page.waitForFunction(() => document.activeElement.id === "canvas");
    }, { hasTouch: true }));

test("A number asks for the keyboard of digits, takes a decimal comma, and Enter or another place closes the keyboard", limit, () =>
    withLab("?open=2a-coward&lang=de", async (lab) => {
        const { page } = lab;
        const typing = () => page.evaluate(() => (document.activeElement.id === "typing" ? document.activeElement.inputMode : ""));
        const waitFor = (mode) => page.waitForFunction((wanted) =>
            (document.activeElement.id === "typing" ? document.activeElement.inputMode : "") === wanted, mode);
        const tapNumber = async () => {
            const [x, y, w, h] = await lab.rectangle("slider.LL");
            await page.touchscreen.tap(x + w - 12, y + h / 2);
            await waitFor("decimal");
        };
        await page.touchscreen.tap(...await lab.middle("viewport"));
        await lab.frames(4);
        assert.equal(await typing(), "");
        await tapNumber();
        await page.keyboard.insertText("0,75");  // as a keyboard on the screen
        await lab.frames(2);
        await page.keyboard.press("Enter");
        await lab.until((state) => state.weights.LL === 0.75);
        await waitFor("");
        await tapNumber();
        await page.touchscreen.tap(...await lab.middle("viewport"));
        await waitFor("");
        await page.keyboard.press("Control+s");
        await lab.until((state) => state.focus === "files.path");
        await waitFor("text");
    }, { hasTouch: true, viewport: { width: 1024, height: 768 } }));

test("The lab fills the screen and leaves it again", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const fills = () => lab.page.evaluate(() => document.fullscreenElement !== null);
        for (const wanted of [true, false]) {
            await lab.click("menu.view");
            await lab.click("menu.view.full_screen");
            await lab.page.waitForFunction((value) => (document.fullscreenElement !== null) === value, wanted);
            assert.equal(await fills(), wanted);
        }
    }));

test("Text is copied out of the page", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        await lab.page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
        await lab.page.keyboard.press("Control+s");
        await lab.until((state) => state.focus === "files.path");
        // "ë" has no key: the page types it once its invisible field has the focus, a few frames after the lab's field.
        await lab.page.waitForFunction(() => document.activeElement.id === "typing");
        await lab.page.keyboard.press("Control+a");
        await lab.page.keyboard.type("coward of Zoë");
        await lab.until((state) => state.typed === "coward of Zoë");
        await lab.page.keyboard.press("Control+a");
        await lab.page.keyboard.press("Control+c");
        await lab.page.waitForFunction(async () => (await navigator.clipboard.readText()) === "coward of Zoë");
    }));

// The longest turn of the lab while `work` runs, ms. A turn is what keeps the page from answering.
async function longestTurn(lab, work) {
    await lab.page.evaluate(() => {
        window.turns = { longest: 0, count: 0, runs: true };
        let seen = -1;
        const measure = () => {
            const { frames, frame_ms } = window.braitenlab.state();
            if (frames !== seen) {
                if (seen >= 0) window.turns.longest = Math.max(window.turns.longest, frame_ms), ++window.turns.count;
                seen = frames;
            }
            if (window.turns.runs) requestAnimationFrame(measure);
        };
        requestAnimationFrame(measure);
    });
    await work();
    const { longest, count } = await lab.page.evaluate(() => ((window.turns.runs = false), window.turns));
    assert.ok(count > 5, `only ${count} turns were measured`);
    return longest;
}

// No turn takes 100 ms while the lab works. Where drawing alone takes as long, as on a software renderer of a busy
// machine, the work adds less than 50 ms to the longest turn without it. The better of two tries counts.
async function staysSmooth(what, query, rest, work) {
    const measured = [];
    for (let i = 0; i < 2; ++i)
        await withLab(query, async (lab) => {
            const longest = await longestTurn(lab, () => work(lab));
            await rest(lab);
            measured.push([longest, await longestTurn(lab, () => lab.page.waitForTimeout(3000))]);
        });
    const words = measured.map(([longest, without]) => `${longest.toFixed(0)} (without ${without.toFixed(0)})`);
    console.log(`longest turn ${what}: ${words.join(", ")} ms`);
    assert.ok(measured.some(([longest, without]) => longest < Math.max(100, without + 50)));
}

test("The page answers while an exercise is graded", limit, () =>
    staysSmooth("while grading", "?open=01-drive", () => {}, async (lab) => {
        await lab.click("exercise.predict.2");
        await lab.until((state) => state.exercise.predicted === 1);
        const [x, y, w, h] = await lab.rectangle("bias.RM");
        await lab.page.mouse.click(x + w / 2, y + h / 2);
        await lab.until((state) => state.focus === "bias.RM");
        for (let i = 0; i < 40 && Math.abs((await lab.state()).weights.RM - 0.3) > 0.024; ++i) {
            await lab.page.keyboard.press((await lab.state()).weights.RM < 0.3 ? "ArrowRight" : "ArrowLeft");
            await lab.frames(2);
        }
        await lab.page.keyboard.press("Escape");
        await lab.page.keyboard.press("Space");
        await lab.until((state) => state.exercise.starts.length > 0, null, "a grade");
    }));

test("The page answers while a map of behaviour is computed", limit, () =>
    staysSmooth("while a map is computed", "?open=2a-coward", async (lab) => {
        await lab.page.keyboard.press("m");
        await lab.page.keyboard.press("Space");
    }, async (lab) => {
        await lab.page.keyboard.press("m");
        await lab.until((state) => state.map?.done, null, "the whole map");
    }));

test("A map of behaviour takes at most six times as long as on one thread of the desktop", limit, async () => {
    const program = path.join(root, "build/release/braitenctl");
    const seconds = (began) => (performance.now() - began) / 1000;
    let began = performance.now();
    execFileSync(program, ["map", "2a-coward", "--threads", "1"], { env: { ...process.env, BRAITENLAB_DATA: root } });
    const native = seconds(began);
    await withLab("?open=2a-coward", async (lab) => {
        began = performance.now();
        await lab.page.keyboard.press("m");
        await lab.page.waitForFunction(() => window.braitenlab.state().map?.done, null, { timeout: 90000, polling: 500 });
        console.log(`map of behaviour: ${seconds(began).toFixed(1)} s, braitenctl ${native.toFixed(1)} s`);
        assert.ok(seconds(began) < 6 * native + 1);
    });
});

test("No task takes 50 ms of processor time while vehicles drive, a map or a study is computed", limit, async () => {
    const measured = {};
    await withLab("?open=predator-prey&play", async (lab) => {
        await pause(3);
        measured.playing = await longestTask(lab, () => pause(5));
    });
    await withLab("?open=2a-coward", async (lab) => {
        await pause(3);
        measured.map = await longestTask(lab, async () => {
            await lab.page.keyboard.press("m");
            await lab.page.waitForFunction(() => window.braitenlab.state().map?.done, null, { timeout: 90000, polling: 500 });
        });
    });
    await withLab("?open=prey-eyes", async (lab) => {
        await lab.click("study.run");
        await lab.until((state) => state.study?.running);
        measured.study = await longestTask(lab, () => pause(6));
    });
    console.log(`longest task: ${JSON.stringify(measured)} ms`);
    for (const [what, ms] of Object.entries(measured)) assert.ok(ms < 50, `${what}: ${ms} ms`);
});

test("Without graphics hardware nothing is drawn by instances", limit, () =>
    withLab("?open=predator-prey&play", async (lab) => {
        const drawn = await lab.page.evaluate(() => ((window.drawn = { instances: 0, calls: 0 }), window.drawn));
        assert.equal(drawn.calls, 0);
        await lab.frames(3);
        const { instances, calls } = await lab.page.evaluate(() => window.drawn);
        assert.ok(calls > 20, `${calls} calls`);
        assert.equal(instances, 0);
    }, {
        init: () => {
            window.drawn = { instances: 0, calls: 0 };
            const drawing = WebGL2RenderingContext.prototype;
            const follow = (name, count) => {
                const real = drawing[name];
                drawing[name] = function (...given) {
                    count(...given);
                    return real.apply(this, given);
                };
            };
            follow("drawElements", () => ++window.drawn.calls);
            follow("drawElementsInstanced", (mode, indices, type, first, instances) => (window.drawn.instances += instances));
        },
    }));

test("A diagram of 304 nodes and 1,200 wires looks as on the desktop", limit, async () => {
    const text = largeScene(304, 1200);
    const folder = await mkdtemp(path.join(os.tmpdir(), "braitenlab-")), file = path.join(folder, "large.toml");
    await writeFile(file, text);
    const inWindow = await withWindow([file], async (lab) => {
        await lab.frames(4);
        await lab.key("w");
        await lab.until((state) => state.mode === "wiring");
        await pause(2);
        await lab.frames(4);
        return squaresOf(labs.browser, await lab.picture(), 20);
    });
    await withLab("?open=2a-coward", async (lab) => {
        await lab.drop("large.toml", text);
        await lab.until((state) => state.opened === "large");
        await lab.page.keyboard.press("w");
        await lab.until((state) => state.mode === "wiring");
        await lab.page.waitForTimeout(2000);
        await lab.frames(4);
        assert.equal(Object.keys(await lab.anchors()).filter((name) => name.startsWith("node.")).length, 304);
        const onPage = await pictureOfPage(lab, "large");
        const share = differing(onPage, inWindow, 24);
        console.log(`${(100 * share).toFixed(1)} % of the diagram differs`);
        assert.ok(share < 0.04, `${share} of the picture differs`);
    });
});

test("The single file runs without a server", limit, async () => {
    const lab = await Lab.open(labs.browser, pathToFileURL(path.join(root, "build/dist/braitenlab-web.html")) + "?open=2a-coward");
    await lab.until((state) => state.opened === "2a-coward");
    assert.deepEqual(lab.errors, []);
    await lab.page.context().close();
});

test("Without WebGL 2 the page says what is missing", limit, async () => {
    const other = await openBrowser(["--disable-webgl2", "--disable-3d-apis"]);
    try {
        const page = await other.newPage();
        await page.goto(labs.server.address);
        await page.waitForFunction(() => /WebGL 2/.test(document.getElementById("message").textContent));
        assert.equal(await page.isVisible("#cover"), true);
    } finally {
        await other.close();
    }
});
