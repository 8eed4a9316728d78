// What the page keeps: in the browser's storage, beside other pages of the lab, over a reload.
import assert from "node:assert/strict";
import { mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import os from "node:os";
import path from "node:path";
import { test } from "node:test";

import { Lab, openUser, root, useLabs } from "./page.mjs";

const limit = { timeout: 120000 };
const labs = useLabs();
const { withLab } = labs;
const progress = "braitenlab:/home/web_user/state/students/this-computer.json";

const stored = (lab, key) => lab.page.evaluate((name) => localStorage.getItem(name), key);

// The exercises of the student's stored progress.
const keptExercises = async (lab) => Object.keys(JSON.parse(await stored(lab, progress) ?? "{}").exercises ?? {});

async function predict(lab) {
    await lab.click("exercise.predict.2");
    await lab.until((state) => state.exercise.predicted === 1);
}

// Waits until check(lab) is true.
async function eventually(lab, check, what) {
    for (let tries = 0; tries < 100; ++tries) {
        if (await check()) return;
        await lab.page.waitForTimeout(100);
    }
    assert.fail(`never true: ${what}`);
}

const noticeText = (lab) => lab.page.evaluate(() => (document.getElementById("notice").hidden
    ? "" : document.getElementById("notice-text").textContent));

test("Without storage the lab starts and says that nothing is kept", limit, () =>
    withLab("?open=01-drive", async (lab) => {
        assert.match(await noticeText(lab), /keep nothing/);
        assert.equal(await lab.page.isVisible("#notice-act"), false, "there is nothing to download");
        await lab.frames(3);
        const [x, y, w, h] = await lab.rectangle("hint.bar");
        const notice = await lab.page.locator("#notice").boundingBox();
        assert.ok(y + h <= notice.y + 1 && w > 1000, "the notice covers nothing of the lab");
        await predict(lab);
        await lab.page.waitForSelector("#notice-act:not([hidden])");
        assert.match(await noticeText(lab), /keep nothing/);
        await lab.page.click("#notice-close");
        assert.equal(await noticeText(lab), "");
        await lab.page.waitForTimeout(1500);
        assert.equal(await noticeText(lab), "", "it says so once");
    }, {
        init: () => {
            for (const name of ["localStorage", "sessionStorage"])
                Object.defineProperty(window, name, { get() { throw new DOMException("denied", "SecurityError"); } });
        },
    }));

test("The first theme is the one that the browser asks for, until one is chosen", limit, async () => {
    await withLab("?open=01-drive", async (lab) => {
        assert.equal((await lab.state()).theme, "light");
        await lab.page.keyboard.press("t");
        await lab.until((state) => state.theme === "dark");
        await lab.page.waitForFunction(() => localStorage.getItem("braitenlab:/home/web_user/config/settings.toml"));
        const two = await Lab.openIn(lab.page.context(), labs.server.address + "?open=01-drive");
        assert.equal((await two.state()).theme, "dark");
    }, { colorScheme: "light" });
});

test("In a browser that refuses cookies the lab starts and says that nothing is kept", limit, async () => {
    const folder = await mkdtemp(path.join(os.tmpdir(), "braitenlab-"));
    await mkdir(path.join(folder, "Default"));
    const refused = 2;
    await writeFile(path.join(folder, "Default/Preferences"),
        JSON.stringify({ profile: { default_content_setting_values: { cookies: refused } } }));
    const context = await openUser(folder);
    try {
        const lab = await Lab.openIn(context, labs.server.address + "?open=01-drive");
        assert.match(await noticeText(lab), /keep nothing/);
        await predict(lab);
        assert.deepEqual(lab.errors, []);
    } finally {
        await context.close();
        await rm(folder, { recursive: true });
    }
});

test("A frame that keeps nothing offers a window of its own", limit, async () => {
    const context = await labs.browser.newContext({ locale: "en-US" });
    try {
        await context.addInitScript(refuseStorage);
        const page = await context.newPage();
        await page.route("**/course.html", (route) => route.fulfill({ contentType: "text/html",
            body: '<iframe style="width: 1280px; height: 800px" src="/?open=01-drive"></iframe>' }));
        await page.goto(labs.server.address + "course.html");
        const frame = await (await page.waitForSelector("iframe")).contentFrame();
        await frame.waitForSelector("#notice-own:not([hidden])", { timeout: 60000 });
        assert.equal(await frame.getAttribute("#notice-own", "href"), labs.server.address + "?open=01-drive");
    } finally {
        await context.close();
    }
});

test("A reload offers a prediction and its run without an edit", limit, () =>
    withLab("?open=01-drive", async (lab) => {
        await predict(lab);
        await lab.page.keyboard.press("Space");
        await lab.until((state) => state.tick > 30);
        await lab.page.reload();
        await lab.ready();
        await lab.click("recovery.take");
        await lab.until((state) => state.exercise.predicted === 1 && state.tick > 30);
    }));

test("A full storage keeps what it has, and the page offers the rest as a download", limit, () =>
    withLab("?open=01-drive", async (lab) => {
        await predict(lab);
        await eventually(lab, async () => (await keptExercises(lab)).length === 1, "progress is stored");
        const before = await stored(lab, progress);
        await lab.page.evaluate(() => location.hash = "#e1.05-aggressor");
        await lab.until((state) => state.exercise?.id === "05-aggressor");
        const hasWork = () => lab.page.evaluate(() => Object.keys(localStorage).some((key) => key.endsWith(".autosave")));
        await eventually(lab, async () => !(await hasWork()), "the work on the first exercise is removed");
        await lab.page.evaluate(() => {
            for (let size = 1 << 22; size >= 1; size >>= 1)
                for (let i = 0; ; ++i)
                    try {
                        localStorage.setItem(`fill ${size} ${i}`, "x".repeat(size));
                    } catch {
                        break;
                    }
        });
        await predict(lab);
        await lab.page.waitForSelector("#notice:not([hidden])", { timeout: 15000 });
        assert.match(await noticeText(lab), /full/);
        await lab.page.waitForTimeout(2500);
        assert.equal(await stored(lab, progress), before);
        const downloads = [];
        lab.page.on("download", (download) => downloads.push(download));
        await lab.page.click("#notice-act");
        await eventually(lab, () => downloads.length > 1, "two downloads");
        assert.deepEqual(downloads.map((each) => each.suggestedFilename()).sort(), ["05-aggressor.run", "braitenlab-progress.json"]);
        const file = downloads.find((each) => each.suggestedFilename().endsWith(".json"));
        assert.equal(Object.keys(JSON.parse(await readFile(await file.path(), "utf8")).exercises).length, 2);
    }));

test("Two pages of the lab keep the progress of both", limit, () =>
    withLab("?open=01-drive", async (one) => {
        const two = await Lab.openIn(one.page.context(), labs.server.address + "?open=05-aggressor");
        await one.page.bringToFront();
        await predict(one);
        await eventually(one, async () => (await keptExercises(one)).length === 1, "progress of the first page");
        await two.page.bringToFront();
        await predict(two);
        await eventually(two, async () => (await keptExercises(two)).length === 2, "progress of both pages");
        await one.page.bringToFront();
        await one.click("exercise.predict.1");
        await one.until((state) => state.exercise.predicted === 0);
        await one.page.waitForTimeout(2500);
        assert.equal((await keptExercises(one)).length, 2);
        assert.deepEqual(two.errors, []);
    }));

test("A page follows the progress that another page stores", limit, () =>
    withLab("?open=01-drive", async (one) => {
        await predict(one);
        await eventually(one, async () => (await keptExercises(one)).length === 1, "progress is stored");
        const other = await one.page.context().newPage();
        await other.route("**/empty.html", (route) => route.fulfill({ contentType: "text/html", body: "" }));
        await other.goto(labs.server.address + "empty.html");
        await other.evaluate((key) => {
            const kept = JSON.parse(localStorage.getItem(key));
            kept.exercises["01-drive"].notes = "from another page";
            localStorage.setItem(key, JSON.stringify(kept));
        }, progress);
        await one.page.bringToFront();
        await one.until((state) => state.exercise.notes === "from another page");
    }));

test("Notes of one exercise in two pages keep the words of both, also in a field that is active", limit, () =>
    withLab("?open=01-drive", async (one) => {
        const two = await Lab.openIn(one.page.context(), labs.server.address + "?open=01-drive");
        const openNotes = async (lab) => {
            await lab.page.bringToFront();
            await lab.click("exercise.note");
            await lab.until((state) => state.focus === "exercise.note.text");
            await lab.frames(4);
        };
        const keptNotes = async (lab) => JSON.parse(await stored(lab, progress) ?? "{}").exercises?.["01-drive"]?.notes;
        const type = async (lab, words, all) => {
            await lab.page.keyboard.type(words);
            await eventually(lab, async () => (await keptNotes(lab)) === all, `${all} is stored`);
        };
        await openNotes(one);
        await openNotes(two);
        await type(two, "of two", "of two");
        await one.page.bringToFront();
        await one.until((state) => state.exercise.notes === "of two", null, "the active field takes it over");
        assert.equal((await one.state()).focus, "exercise.note.text");
        await one.page.keyboard.press("End");
        await type(one, " and one", "of two and one");
        await two.page.bringToFront();
        await two.until((state) => state.exercise.notes === "of two and one");
        await two.page.keyboard.press("End");
        await type(two, "!", "of two and one!");
        assert.deepEqual(two.errors, []);
    }));

test("Work of a page that is open is not offered to another one", limit, () =>
    withLab("?open=2a-coward", async (one) => {
        const [x, y, w, h] = await one.rectangle("slider.LL");
        await one.drag([x + w * 0.5, y + h / 2], [x + w * 0.62, y + h / 2]);
        const isWork = (key) => key.endsWith(".autosave");
        await eventually(one, () => one.page.evaluate(() => Object.keys(localStorage).some((key) => key.endsWith(".autosave"))),
            "the work is stored");
        const two = await Lab.openIn(one.page.context(), labs.server.address + "?open=2a-coward");
        await two.frames(6);
        assert.equal((await two.anchors())["recovery.take"], undefined);
        await two.page.close();
        const keys = await one.page.evaluate(() => Object.keys(localStorage));
        assert.equal(keys.filter(isWork).length, 1, "it is kept all the same");
    }));

test("In a lecture F5 goes to the first page, and a reload opens the present one", limit, () =>
    withLab("?open=four-numbers", async (lab) => {
        const { keyboard } = lab.page;
        const at = () => lab.state().then((state) => state.lecture.page);
        const press = async (key, page) => {
            await keyboard.press(key);
            await lab.until((state, wanted) => state.lecture?.page === wanted, page);
        };
        await lab.page.evaluate(() => (window.isSamePage = true));
        await press("PageDown", 2);
        await press("F5", 1);
        assert.ok(await lab.page.evaluate(() => window.isSamePage), "the page is loaded anew");
        await press("PageDown", 2);
        await keyboard.press("PageDown");
        await lab.until((state) => state.lecture.step === 1);
        await lab.frames(3);  // the page is told in the next one
        await lab.page.reload();
        await lab.ready();
        assert.deepEqual([await at(), (await lab.state()).lecture.step], [2, 1]);
        await keyboard.press("F9");
        await lab.until((state) => !state.lecture);
        await lab.frames(3);
        assert.equal(await lab.page.evaluate(() => dispatchEvent(new KeyboardEvent("keydown",
            { key: "F5", bubbles: true, cancelable: true }))), true, "outside a lecture F5 is the browser's");
    }));

test("A hand-in is named as it is among the downloads", limit, () =>
    withLab("?open=01-drive", async (lab) => {
        await predict(lab);
        await lab.page.keyboard.press("Space");
        await lab.until((state) => state.tick > 30);
        await lab.page.keyboard.press("Space");
        const download = lab.page.waitForEvent("download");
        await lab.click("exercise.hand_in");
        await lab.until((state) => state.focus === "exercise.student");
        await lab.page.keyboard.type("Ana");
        await lab.page.keyboard.press("Enter");
        const name = (await download).suggestedFilename();
        assert.match(name, /^01-drive-ana\.braiten-handin\.toml$/);
        await lab.until((state, file) => JSON.stringify(state.notice).includes(file), name);
        assert.doesNotMatch(JSON.stringify((await lab.state()).notice), /home/);
    }));

test("The notes of a lecture are in a window of their own and follow it", limit, () =>
    withLab("?open=four-numbers", async (lab) => {
        const opened = lab.page.waitForEvent("popup");
        await lab.page.keyboard.press("Shift+N");
        const notes = await opened;
        await notes.waitForSelector("h1:has-text('Who is hunting here?')");
        await lab.page.keyboard.press("PageDown");
        await notes.waitForSelector("h1:has-text('What will it do?')");
        assert.equal((await lab.state()).lecture.notes, false, "the audience does not see them");
        await lab.page.bringToFront();
        await lab.page.keyboard.press("n");
        await lab.until((state) => state.lecture.notes, null, "N shows them to the audience");
        await lab.page.keyboard.press("F9");
        await notes.waitForSelector("p:has-text('The lecture is over')");
        await lab.page.keyboard.press("t");
        await notes.waitForFunction(() => getComputedStyle(document.body).backgroundColor === "rgb(255, 255, 255)");
    }));

// In the page before the lab: the browser refuses the storage.
const refuseStorage = () => {
    for (const name of ["localStorage", "sessionStorage"])
        Object.defineProperty(window, name, { get() { throw new DOMException("denied", "SecurityError"); } });
};

test("A page that keeps nothing asks before it is left, once there is progress", limit, async () => {
    const leaves = async (use, init) => {
        let asked = false;
        const lab = await Lab.open(labs.browser, labs.server.address + "?open=01-drive", {}, init);
        lab.page.on("dialog", (dialog) => {
            asked = dialog.type() === "beforeunload";
            dialog.accept();
        });
        await lab.page.mouse.click(600, 400);  // a browser does not ask before the first action of the user
        await use(lab);
        await lab.frames(3);  // progress follows the next one
        await lab.page.close({ runBeforeUnload: true });
        for (let tries = 0; tries < 50 && !asked && !lab.page.isClosed(); ++tries) await new Promise((done) => setTimeout(done, 100));
        await lab.page.context().close();
        return asked;
    };
    assert.equal(await leaves(() => {}, refuseStorage), false, "nothing is lost");
    assert.equal(await leaves(predict, refuseStorage), true);
    assert.equal(await leaves(predict), false, "it is stored");
});

test("Progress and work that a page does not keep are downloaded, and read again by another browser", limit, async () => {
    const saved = {};
    await withLab("?open=01-drive", async (lab) => {
        await predict(lab);
        await lab.page.keyboard.press("Space");
        await lab.until((state) => state.tick > 30);
        await lab.page.keyboard.press("Space");
        await lab.page.waitForTimeout(2500);  // progress is written each second
        lab.page.on("download", async (download) => {
            const file = await download.path();
            saved[download.suggestedFilename()] = await readFile(file, "utf8");
        });
        assert.equal(await lab.page.innerText("#notice-act"), "Download progress and run");
        await lab.page.click("#notice-act");
        await eventually(lab, () => Object.keys(saved).length === 2, "two downloads");
        for (const name in saved) assert.ok((await noticeText(lab)).includes(name), `the page names ${name}`);
    }, { init: refuseStorage });
    assert.deepEqual(Object.keys(saved).sort(), ["01-drive.run", "braitenlab-progress.json"]);
    await withLab("?open=2a-coward", async (lab) => {
        await lab.drop("braitenlab-progress.json", saved["braitenlab-progress.json"]);
        await eventually(lab, async () => (await keptExercises(lab)).includes("01-drive"), "its progress is added");
        await lab.drop("01-drive.run", saved["01-drive.run"]);
        await lab.until((state) => state.exercise?.id === "01-drive" && state.tick > 30);
        await lab.until((state) => state.exercise.predicted === 1);
    });
});

test("The work of each closed page is offered", limit, () =>
    withLab("?open=empty", async (lab) => {
        const others = [];
        for (const scene of ["2a-coward", "2b-aggressor"])
            others.push(await Lab.openIn(lab.page.context(), labs.server.address + `?open=${scene}`));
        for (const other of others) {
            await other.page.bringToFront();
            const [x, y, w, h] = await other.rectangle("slider.LL");
            await other.drag([x + w * 0.5, y + h / 2], [x + w * 0.62, y + h / 2]);
            await other.frames(2);
            await other.page.evaluate(() => files.leave());
            await other.page.waitForTimeout(1100);  // the time of the work is in seconds
        }
        for (const other of others) await other.page.close();
        await lab.page.bringToFront();
        await lab.page.reload();
        await lab.ready();
        await lab.click("recovery.later");
        await lab.frames(4);
        await lab.click("recovery.take");
        await lab.until((state) => state.opened === "2a-coward", null, "the older one is open");
    }));

test("Work that is discarded is not offered after the lab is closed", limit, () =>
    withLab("?open=05-aggressor", async (lab) => {
        const turn = async (slider) => {
            const [x, y, w, h] = await lab.rectangle(slider);
            await lab.drag([x + w * 0.5, y + h / 2], [x + w * 0.62, y + h / 2]);
        };
        await predict(lab);
        await turn("slider.LR");
        await lab.page.keyboard.press("Space");
        await lab.until((state) => state.tick > 30);
        await lab.page.keyboard.press("Space");
        await lab.page.reload();
        await lab.ready();
        await lab.click("recovery.take");
        await lab.until((state) => state.tick > 30);
        await lab.click("menu.file");
        await lab.click("menu.file.exit");
        await lab.frames(3);
        await lab.click("leaving.discard");
        await lab.page.waitForSelector("#again:not([hidden])");
        await lab.page.click("#again");
        await lab.ready();
        await lab.frames(6);
        assert.equal((await lab.anchors())["recovery.take"], undefined);
    }));

test("A file that is dropped while kept work is offered waits for the answer", limit, () =>
    withLab("?open=2a-coward", async (lab) => {
        const [x, y, w, h] = await lab.rectangle("slider.LL");
        await lab.drag([x + w * 0.5, y + h / 2], [x + w * 0.62, y + h / 2]);
        await lab.page.reload();
        await lab.ready();
        await lab.rectangle("recovery.later");
        await lab.drop("mine.toml", await readFile(path.join(root, "exercises/scenes/2b-aggressor.toml"), "utf8"));
        await lab.frames(6);
        assert.equal((await lab.state()).opened, "2a-coward");
        await lab.click("recovery.later");
        await lab.until((state) => state.opened === "mine");
    }));

test("A frame that may refuse downloads offers the text of a hand-in", limit, async () => {
    const context = await labs.browser.newContext({ viewport: { width: 1280, height: 800 }, locale: "en-US",
        permissions: ["clipboard-read", "clipboard-write"] });
    try {
        const page = await context.newPage();
        await page.route("**/course.html", (route) => route.fulfill({ contentType: "text/html",
            body: '<iframe style="position: fixed; inset: 0; width: 100%; height: 100%; border: 0" ' +
                'sandbox="allow-scripts allow-same-origin" src="/?open=01-drive"></iframe>' }));
        await page.goto(labs.server.address + "course.html");
        const frame = await (await page.waitForSelector("iframe")).contentFrame();
        await frame.waitForFunction(() => window.braitenlab?.ready, null, { timeout: 60000 });
        await frame.evaluate(() => {
            window.copied = [];
            navigator.clipboard.writeText = (text) => Promise.resolve(window.copied.push(text));
            FS.writeFile("/home/web_user/a.braiten-handin.toml", "student = 'Ana'");
        });
        await frame.waitForSelector("#notice:not([hidden])");
        assert.match(await frame.textContent("#notice-text"), /a\.braiten-handin\.toml/);
        await frame.click("#notice-act");
        assert.deepEqual(await frame.evaluate(() => window.copied), ["student = 'Ana'"]);
        await frame.waitForFunction(() => /copied.*a\.braiten-handin\.toml/.test(document.getElementById("notice-text").textContent));
        await frame.click("#canvas", { position: { x: 600, y: 300 } });
        await page.keyboard.press("Control+s");
        await frame.waitForFunction(() => window.braitenlab.state().focus === "files.path");
        await page.keyboard.press("Enter");
        await frame.waitForFunction(() => window.braitenlab.state().notice_key === "notice.framed_download", null, { timeout: 10000 });
    } finally {
        await context.close();
    }
});

test("Keys of the window with the notes turn the lecture's page, and the notes tell when they are old", limit, () =>
    withLab("?open=four-numbers", async (lab) => {
        const opened = lab.page.waitForEvent("popup");
        await lab.page.keyboard.press("Shift+N");
        const notes = await opened;
        await notes.waitForSelector("h1:has-text('Who is hunting here?')");
        await notes.bringToFront();
        await notes.keyboard.press("PageDown");
        await lab.page.bringToFront();
        await lab.until((state) => state.lecture.page === 2);
        await lab.page.reload();
        await notes.waitForSelector("p:has-text('no longer follow')");
    }));

test("A hand-in that is dropped is told as the student's", limit, () =>
    withLab("?open=01-drive", async (lab) => {
        await predict(lab);
        await lab.page.keyboard.press("Space");
        await lab.until((state) => state.tick > 30);
        const download = lab.page.waitForEvent("download");
        await lab.click("exercise.hand_in");
        await lab.until((state) => state.focus === "exercise.student");
        await lab.page.keyboard.type("Ana");
        await lab.page.keyboard.press("Enter");
        await lab.drop("x.toml", await readFile(await (await download).path(), "utf8"));
        await lab.until((state) => state.notice === "Ana");
    }));
