// What the page keeps: in the browser's storage.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";

import { useLabs } from "./page.mjs";

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
        await predict(lab);
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

test("A full storage keeps what it has, and the page offers the rest as a download", limit, () =>
    withLab("?open=01-drive", async (lab) => {
        await predict(lab);
        await eventually(lab, async () => (await keptExercises(lab)).length === 1, "progress is stored");
        const before = await stored(lab, progress);
        await lab.page.evaluate(() => {
            for (let size = 1 << 22; size >= 1; size >>= 1)
                for (let i = 0; ; ++i)
                    try {
                        localStorage.setItem(`fill ${size} ${i}`, "x".repeat(size));
                    } catch {
                        break;
                    }
        });
        await lab.page.evaluate(() => location.hash = "#e1.05-aggressor");
        await lab.until((state) => state.exercise?.id === "05-aggressor");
        await predict(lab);
        await lab.page.waitForSelector("#notice:not([hidden])", { timeout: 15000 });
        assert.match(await noticeText(lab), /full/);
        await lab.page.waitForTimeout(2500);
        assert.equal(await stored(lab, progress), before);
        const downloads = [];
        lab.page.on("download", (download) => downloads.push(download));
        await lab.page.click("#notice-act");
        await eventually(lab, () => downloads.some((file) => file.suggestedFilename() === "this-computer.json"), "a download");
        const file = downloads.find((each) => each.suggestedFilename() === "this-computer.json");
        assert.equal(Object.keys(JSON.parse(await readFile(await file.path(), "utf8")).exercises).length, 2);
    }));
