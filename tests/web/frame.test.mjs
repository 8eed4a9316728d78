// What is around the lab on its page: loading, title, sizes, fingers.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import path from "node:path";
import { test } from "node:test";

import { root, squaresOf, useLabs } from "./page.mjs";

const limit = { timeout: 120000 };
const labs = useLabs();
const { withLab } = labs;

test("A server that does not compress sends less than 4 MB", limit, async () => {
    const before = labs.server.sent();
    await withLab("?open=2a-coward", () => {});
    const sent = labs.server.sent() - before;
    assert.ok(sent > 1e6 && sent < 4e6, `${sent} bytes`);
});

test("A server may declare the compression of the files", limit, async () => {
    const gz = (route) => route.fetch().then((answer) =>
        route.fulfill({ response: answer, headers: { ...answer.headers(), "content-encoding": "gzip" } }));
    const context = await labs.browser.newContext();
    await context.route("**/*.gz?*", gz);
    const page = await context.newPage();
    await page.goto(labs.server.address + "?open=2a-coward");
    await page.waitForFunction(() => window.braitenlab?.ready, null, { timeout: 60000 });
    await context.close();
});

test("Without scripts the page says what it needs", limit, async () => {
    const context = await labs.browser.newContext({ javaScriptEnabled: false });
    const page = await context.newPage();
    await page.goto(labs.server.address);
    assert.match(await page.innerText("noscript"), /JavaScript/);
    await context.close();
});

test("Without scripts the page has the theme that the browser asks for", limit, async () => {
    for (const [colorScheme, ground] of [["light", [255, 255, 255]], ["dark", [20, 24, 30]]]) {
        const context = await labs.browser.newContext({ javaScriptEnabled: false, colorScheme });
        const page = await context.newPage();
        await page.goto(labs.server.address);
        await page.waitForSelector("#cover");
        const [corner] = await squaresOf(labs.browser, await page.screenshot(), 20);
        assert.deepEqual(corner, ground, colorScheme);
        await context.close();
    }
});

test("While it loads the page tells the share of the bytes", limit, async () => {
    for (const isDeclared of [false, true]) {
        const context = await labs.browser.newContext({ locale: "de-DE" });
        await context.route("**/braitenlab.wasm.gz?*", () => {});  // never answered
        if (isDeclared)
            await context.route(/braitenlab\.(data|js)\.gz/, (route) => route.fetch().then((answer) =>
                route.fulfill({ response: answer, headers: { ...answer.headers(), "content-encoding": "gzip" } })));
        const page = await context.newPage();
        await page.goto(labs.server.address, { waitUntil: "commit" });
        const share = await page.waitForFunction(() => {
            const { data, js } = { data: "braitenlab.data", js: "braitenlab.js" };
            return typeof received === "object" && Math.round(received[data]) === built.sizes[data] &&
                Math.round(received[js]) === built.sizes[js] && document.getElementById("share").textContent;
        }, null, { timeout: 20000 });
        const sizes = await page.evaluate(() => built.sizes), all = Object.values(sizes).reduce((a, b) => a + b);
        const percent = Math.floor(100 * (all - sizes["braitenlab.wasm"]) / all);
        assert.equal(await share.jsonValue(), `${percent} % von ${(all / 1e6).toLocaleString("de", { maximumFractionDigits: 1 })} MB`);
        await context.close();
    }
});

test("An option of the address that the lab does not know is named, and the lab starts without it", limit, async () => {
    for (const [option, named] of [["camera=drivr#e1.05-aggressor", /drivr/], ["lang=fr#e1.05-aggressor", /fr/],
        ["open=3a-lov", /3a-lov/]]) {
        const context = await labs.browser.newContext({ locale: "en-US" });
        const page = await context.newPage();
        await page.goto(`${labs.server.address}?${option}`);
        await page.waitForSelector("#again:not([hidden])", { timeout: 60000 });
        assert.match(await page.innerText("#message"), named);
        await page.click("#again");
        await page.waitForFunction(() => window.braitenlab?.ready, null, { timeout: 60000 });
        assert.equal(await page.evaluate(() => window.braitenlab.state().exercise.id),
            /05-aggressor/.exec(option)?.[0] ?? "01-drive");
        await context.close();
    }
});

test("A part of the address that the lab does not know is named, and the lab starts", limit, () =>
    withLab("?open=2a-coward&foo=3", async (lab) => {
        assert.match(await lab.page.innerText("#notice-text"), /foo$/);
        assert.equal((await lab.state()).opened, "2a-coward");
    }));

test("The address names a lecture on each of its pages, and then the scene that it leaves open", limit, () =>
    withLab("?open=four-numbers&lang=en", async (lab) => {
        const named = () => lab.page.evaluate(() => new URLSearchParams(location.search).get("open"));
        await lab.page.keyboard.press("PageDown");
        await lab.until((state) => state.lecture?.page === 2);
        await lab.frames(3);
        assert.equal(await named(), "four-numbers");
        await lab.page.keyboard.press("F9");
        await lab.until((state) => !state.lecture);
        await lab.frames(3);
        const { opened } = await lab.state();
        assert.equal(await named(), opened);
        await lab.page.reload();
        await lab.ready();
        assert.equal((await lab.state()).opened, opened);
    }));

test("Before its first picture the page has the colours of the theme", limit, async () => {
    for (const [asked, chosen, ground] of [["light", null, 255], ["dark", null, 20], ["light", "dark", 20], ["dark", "light", 255]]) {
        const context = await labs.browser.newContext({ colorScheme: asked });
        await context.route("**/*.gz?*", () => {});  // never answered
        await context.addInitScript((theme) => theme &&
            localStorage.setItem("braitenlab:/home/web_user/config/settings.toml", `theme = "${theme}"\n`), chosen);
        const page = await context.newPage();
        await page.goto(labs.server.address, { waitUntil: "commit" });
        await page.waitForSelector("#cover");
        const colour = await page.evaluate(() => getComputedStyle(document.getElementById("cover")).backgroundColor);
        assert.ok(colour.startsWith(`rgb(${ground},`), `${asked}, ${chosen}: ${colour}`);
        await context.close();
    }
});

test("The title of the page is that of the open document", limit, async () => {
    const titled = (lab, title) => lab.page.waitForFunction((wanted) => document.title === wanted, title, { timeout: 10000 });
    await withLab("?open=2a-coward", async (lab) => {
        await titled(lab, "Vehicle 2a: Coward – Braitenlab");
        await lab.page.evaluate(() => (location.hash = "#e1.05-aggressor"));
        await titled(lab, "Braitenlab");  // the title of the exercise tells its outcome
    });
    await withLab("?open=four-numbers", (lab) => titled(lab, "Four numbers that look alive – Braitenlab"));
});

test("The page can be enlarged by fingers, and Ctrl with the wheel is the scene's", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const viewport = await lab.page.getAttribute("meta[name=viewport]", "content");
        assert.doesNotMatch(viewport, /maximum-scale|user-scalable/);
        const taken = await lab.page.evaluate(() => ["canvas", "cover"].map((id) => !document.getElementById(id).dispatchEvent(
            new WheelEvent("wheel", { deltaY: 100, ctrlKey: true, bubbles: true, cancelable: true }))));
        assert.deepEqual(taken, [true, true]);
    }));

// Anchors of what is no control, or of a word or a part of a picture.
const noControl = /^(mode|time|hint|term|lesion|stage|brain|viewport|exercise\.(step|predict$)|menu\.rows)/;

test("While a finger is used each control is 44 pixels high, and as before once the mouse moves", limit, () =>
    withLab("?open=01-drive", async (lab) => {
        const height = async () => (await lab.rectangle("bias.RM"))[3];
        await lab.page.mouse.move(500, 400);
        await lab.frames(4);
        const before = await height();
        assert.ok(before < 40, `${before}`);
        await lab.page.touchscreen.tap(...await lab.middle("exercise.predict.2"));
        await lab.until((state) => state.exercise.predicted === 1);
        await lab.frames(4);
        const low = async () => Object.entries(await lab.anchors()).filter(([name, [, , , h]]) => h < 43.5 && !noControl.test(name));
        assert.deepEqual(await low(), []);
        await lab.page.touchscreen.tap(...await lab.middle("menu.view"));
        await lab.rectangle("menu.view.trails");
        await lab.frames(4);
        const [, top, , height_of_menu] = await lab.rectangle("menu.rows");
        const whole = Object.entries(await lab.anchors()).filter(([name, [, y, , h]]) =>
            /^menu\.view\./.test(name) && y + h < top + height_of_menu - 8);  // the last one may be cut
        assert.ok(whole.length > 10);
        for (const [name, [, , , h]] of whole) assert.ok(h > 43.5, `${name}: ${h}`);
        await lab.page.keyboard.press("Escape");
        await lab.page.mouse.move(500, 400);
        await lab.frames(4);
        assert.equal(await height(), before);
    }, { viewport: { width: 1024, height: 768 }, hasTouch: true }));

test("An upright telephone has its cards below the scene, and larger type keeps all in the page", limit, () =>
    withLab("?open=01-drive", async (lab) => {
        const tap = async (anchor) => {
            await lab.page.touchscreen.tap(...await lab.middle(anchor));
            await lab.frames(4);
        };
        const inside = async () => {
            const anchors = await lab.anchors();
            for (const [name, [x, y, w, h]] of Object.entries(anchors))
                assert.ok(x >= -1 && y >= -1 && x + w <= 401 && y + h <= 801, `${name}: ${[x, y, w, h]}`);
            const [, y, , h] = anchors.viewport;
            for (const card of ["card.exercise", "card.brain"]) assert.ok(anchors[card][1] >= y + h, `${card} is below the scene`);
            return anchors;
        };
        await tap("card.exercise");
        const before = await inside();
        assert.ok(before["exercise.predict.3"][3] >= 43.5, `the last answer: ${before["exercise.predict.3"]}`);
        assert.equal(before["tool.lamp"], undefined, "the tools leave the scene free");
        await tap("tools");
        for (let turns = 0; turns < 20 && !(await lab.anchors())["tool.ruler"]; ++turns) await lab.frames(2);
        assert.ok((await inside())["tool.ruler"], "all tools are shown");
        await tap("tool.hand");
        await lab.page.screenshot({ path: path.join(root, "build/web-tests/narrow.png") });
        await tap("exercise.predict.1");
        await lab.until((state) => state.exercise.predicted === 0);
        const type = (await lab.state()).type_size;
        await tap("menu.view");
        const [x, y, w, h] = await lab.rectangle("menu.rows");
        for (let swipes = 0; swipes < 4 && !(await lab.anchors())["menu.view.larger"]; ++swipes)
            await lab.touch([0.8, 0.6, 0.4, 0.2].map((share) => [[x + w / 2, y + h * share]]));
        await tap("menu.view.larger");
        await lab.until((state, old) => state.type_size > old, type);
        await lab.page.keyboard.press("Escape");
        await lab.frames(8);
        const after = await inside();
        assert.ok(after["card.brain.fold"][3] >= 43, `${after["card.brain.fold"]}`);
        assert.ok(after.time[3] > 1.1 * before.time[3], `larger type: ${before.time} and ${after.time}`);
    }, { viewport: { width: 400, height: 800 }, hasTouch: true, isMobile: true }));

test("On an upright telephone what came of the prediction is in sight after the drive", limit, async () => {
    for (const lang of ["en", "de", "es"])
        await withLab(`?open=01-drive&lang=${lang}`, async (lab) => {
            const tap = async (anchor) => lab.page.touchscreen.tap(...await lab.middle(anchor));
            await tap("exercise.predict.2");
            await lab.until((state) => state.exercise.predicted === 1);
            await tap("button.play");
            await lab.until((state) => state.seconds > 2);
            await tap("button.play");
            await lab.until((state) => state.mode === "paused");
            await lab.frames(12);
            await lab.page.screenshot({ path: path.join(root, `build/web-tests/outcome-${lang}.png`) });
            const anchors = await lab.anchors(), [, top, , height] = anchors["exercise.predict"];
            assert.ok(height > 70, `${lang}: ${height} of it are in sight`);
            assert.ok(top + height <= anchors["exercise.hint"][1], lang);
        }, { viewport: { width: 400, height: 800 }, hasTouch: true, isMobile: true });
});

test("In small windows no tool is below a card, and the hint bar is in the window", limit, async () => {
    for (const [width, height] of [[640, 480], [800, 600]])
        await withLab("?open=2a-coward&lang=de", async (lab) => {
            await lab.frames(6);
            const anchors = await lab.anchors(), brain = anchors["card.brain"];
            for (const tool of ["hand", "lamp", "box", "polygon", "zone", "tape", "ruler"]) {
                const [x, , w] = anchors[`tool.${tool}`];
                assert.ok(x + w <= brain[0], `${tool} at ${width}`);
            }
            await lab.page.keyboard.press("w");
            await lab.until((state) => state.mode === "wiring");
            const [, y, w, h] = await lab.rectangle("hint.bar");
            assert.ok(w === width && y + h <= height + 1, `${y} + ${h}`);
        }, { viewport: { width, height } });
});

// A place of the floor beside the vehicle and the lamp.
async function floor(lab) {
    const [x, y, w, h] = await lab.rectangle("viewport");
    return [x + w * 0.5, y + h * 0.85];
}

test("A finger that rests, or taps twice, opens the menu of a right click, with rows of 44 pixels", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const session = await lab.page.context().newCDPSession(lab.page);
        const send = (type, at) => session.send("Input.dispatchTouchEvent",
            { type, touchPoints: at.map(([x, y], id) => ({ x, y, id })) });
        const place = await floor(lab);
        const rows = async () => Object.entries(await lab.anchors()).filter(([name]) => name.startsWith("menu.add"));
        await send("touchStart", [place]);
        await lab.page.waitForTimeout(800);
        await send("touchEnd", []);
        await lab.rectangle("menu");
        await lab.frames(3);
        for (const [name, [, , , height]] of await rows()) assert.ok(height >= 43.5, `${name}: ${height}`);
        await lab.page.screenshot({ path: path.join(root, "build/web-tests/menu.png") });
        await lab.page.keyboard.press("Escape");
        await lab.frames(4);
        assert.equal((await lab.anchors()).menu, undefined);
        await Promise.all([1, 2].flatMap(() => [send("touchStart", [place]), send("touchEnd", [])]));  // quickly
        await lab.rectangle("menu");
    }, { hasTouch: true }));

test("A finger that rests on a slider leaves its value", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const before = (await lab.state()).weights;
        const session = await lab.page.context().newCDPSession(lab.page);
        const [x, y, w, h] = await lab.rectangle("slider.LL");
        const at = { x: x + w * 0.875, y: y + h / 2, id: 0 };
        await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [at] });
        await lab.page.waitForTimeout(900);
        const held = (await lab.state()).weights;
        await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
        await lab.frames(4);
        assert.deepEqual((await lab.state()).weights, held);
        assert.equal((await lab.anchors()).menu, undefined);
        assert.ok(before);
    }, { hasTouch: true }));

// The words of a page whose files the server answers in this way, once it has given up.
async function wordsOfFailure(pattern, answer, address = labs.server.address) {
    const context = await labs.browser.newContext({ locale: "en-US" });
    try {
        await context.route(pattern, answer);
        const page = await context.newPage();
        await page.goto(address);
        await page.waitForSelector("#again:not([hidden])", { timeout: 30000 });
        return await page.innerText("#message");
    } finally {
        await context.close();
    }
}

test("A file that does not arrive is named, with what came in its place", limit, async () => {
    const login = (route) => route.fulfill({ contentType: "text/html", body: "<!DOCTYPE html><title>Login</title>" });
    for (const name of ["wasm", "data", "js"]) {
        const words = await wordsOfFailure(`**/braitenlab.${name}.gz?*`, login);
        assert.match(words, new RegExp(`braitenlab\\.${name}.*web page.*Login`));
    }
    const half = async (route) => {
        const body = await (await route.fetch()).body();
        await route.fulfill({ body: body.subarray(0, body.length / 2) });
    };
    for (const name of ["wasm", "data", "js"])
        assert.match(await wordsOfFailure(`**/braitenlab.${name}.gz?*`, half), new RegExp(`braitenlab\\.${name}: it is incomplete`));
    assert.match(await wordsOfFailure("**/braitenlab.data.gz?*", (route) => route.abort()), /braitenlab\.data: the server does not/);
});

test("In a frame that may not load the files the page says what the frame needs", limit, async () => {
    const page = await labs.browser.newPage();
    await page.route("**/course.html", (route) => route.fulfill({ contentType: "text/html",
        body: '<iframe sandbox="allow-scripts" src="/"></iframe>' }));
    await page.goto(labs.server.address + "course.html");
    const frame = await (await page.waitForSelector("iframe")).contentFrame();
    await frame.waitForSelector("#again:not([hidden])", { timeout: 30000 });
    assert.match(await frame.textContent("#message"), /allow-same-origin/);
    await page.close();
});

test("A page that loses its graphics says so, and its work is offered again", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const [x, y, w, h] = await lab.rectangle("slider.LL");
        await lab.drag([x + w * 0.5, y + h / 2], [x + w * 0.62, y + h / 2]);
        await lab.page.evaluate(() => document.getElementById("canvas").getContext("webgl2").getExtension("WEBGL_lose_context").loseContext());
        await lab.page.waitForSelector("#cover:not([hidden])");
        assert.match(await lab.page.innerText("#message"), /graphics/);
        await lab.page.click("#again");
        await lab.ready();
        await lab.rectangle("recovery.take");
        lab.errors = lab.errors.filter((error) => !/CONTEXT_LOST/.test(error));
    }));

test("The address names the open document or none, and a link opens again", limit, () =>
    withLab("?open=2a-coward&lang=en#e1.05-aggressor", async (lab) => {
        const at = () => lab.page.evaluate(() => location.search + location.hash);
        await lab.until((state) => state.exercise?.id === "05-aggressor");
        assert.equal(await at(), "?open=2a-coward&lang=en#e1.05-aggressor");
        await lab.drop("mine.toml", await readFile(path.join(root, "exercises/scenes/2b-aggressor.toml"), "utf8"));
        await lab.until((state) => state.opened === "mine");
        await lab.frames(3);
        assert.equal(await at(), "?lang=en");
        await lab.page.evaluate(() => (location.hash = "#e1.05-aggressor"));
        await lab.until((state) => state.exercise?.id === "05-aggressor");
        await lab.frames(3);
        assert.equal(await at(), "?lang=en#e1.05-aggressor");
    }));

test("A document of the name of another one does not take over its address", limit, async () => {
    const at = (lab) => lab.page.evaluate(() => location.search + location.hash);
    const text = (await readFile(path.join(root, "exercises/scenes/2a-coward.toml"), "utf8")).replace(/^title = .*$/m, 'title = "Hers"');
    const titled = (lab, title) => lab.page.waitForFunction((wanted) => document.title === wanted, `${title} – Braitenlab`, { timeout: 10000 });
    await withLab("?open=2a-coward&lang=en", async (lab) => {
        await lab.drop("2a-coward.toml", text);
        await titled(lab, "Hers");
        assert.equal(await at(lab), "?lang=en");
    });
    await withLab("?open=2b-aggressor&lang=en", async (lab) => {
        await lab.drop("one.toml", text);
        await titled(lab, "Hers");
        const copied = async () => {
            await lab.page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
            await lab.click("menu.file");
            await lab.click("menu.file.copy_link");
            await lab.until((state) => /^\d+$/.test(state.notice));
            return new URL(await lab.page.evaluate(() => navigator.clipboard.readText())).hash;
        };
        const first = await copied();
        await lab.page.evaluate((hash) => (location.hash = hash), first);
        await lab.until((state) => state.opened !== "one");
        await titled(lab, "Hers");
        await lab.frames(4);
        assert.equal(await at(lab), `?lang=en${first}`);
        await lab.drop("two.toml", text);  // of the same title and as the link, a file of its own
        await lab.until((state) => state.opened === "two");
        await lab.frames(4);
        assert.equal(await at(lab), "?lang=en");
    });
});

test("A link that is not opened, to keep unsaved work, does not name the next document", limit, () =>
    withLab("?open=2a-coward&lang=en", async (lab) => {
        const [x, y, w, h] = await lab.rectangle("slider.LL");
        await lab.drag([x + w * 0.5, y + h / 2], [x + w * 0.62, y + h / 2]);
        await lab.page.evaluate(() => (location.hash = "#e1.05-aggressor"));
        await lab.rectangle("leaving.discard");
        await lab.frames(3);
        await lab.page.keyboard.press("Escape");
        await lab.frames(3);
        await lab.drop("mine.toml", await readFile(path.join(root, "exercises/scenes/2b-aggressor.toml"), "utf8"));
        await lab.rectangle("leaving.discard");
        await lab.frames(3);
        await lab.click("leaving.discard");
        await lab.until((state) => state.opened === "mine");
        await lab.frames(3);
        assert.equal(await lab.page.evaluate(() => location.search + location.hash), "?lang=en");
    }));
