"use strict";
// Files of the lab in a browser. The program writes to a file system in memory; this keeps the home folder in the
// browser's storage (storage.js) and downloads what the user saves. Used by page.js, before the program starts.

const home = "/home/web_user", students = home + "/state/students";
const files = {
    known: new Map(),      // path → stamp of the content that is stored or downloaded
    unstored: new Set(),   // paths whose content the browser has no room for
    isOwn: (path) => path.startsWith(home + "/config/") || path.startsWith(home + "/state/"),

    // Copies the stored files into the file system.
    restore(FS) {
        files.FS = FS;
        for (const path of storage.paths())
            if (path.startsWith(home + "/") && !pages.owns(path)) files.fetch(path);
    },

    // Copies a stored file into the file system.
    fetch(path) {
        const text = storage.read(path);
        if (text === null) return;  // another page has just removed it
        files.FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
        files.FS.writeFile(path, text);
        files.known.set(path, files.stamp(path));
    },

    // Copies what other pages of the lab have stored in the folder since. A file of unsaved work has one page only.
    takeOver(folder) {
        for (const path of storage.paths())
            if (path.startsWith(folder + "/") && !path.endsWith(".autosave") && storage.isNewer(path)) files.fetch(path);
    },

    // Another page of the lab has stored the progress of a student: the program reads it within a second.
    followProgress({ key, storageArea }) {
        const path = key?.slice(storage.prefix.length);
        if (storageArea === storage.shelf && path?.startsWith(students + "/") && storage.isNewer(path)) files.fetch(path);
    },

    // Differs after each change: a file is replaced by another one, which may be written in the same millisecond.
    stamp(path) {
        const { ino, mtime } = files.FS.stat(path);
        return `${ino} ${mtime.getTime()}`;
    },

    list(folder = home, found = []) {
        for (const name of files.FS.readdir(folder)) {
            if (name.startsWith(".")) continue;
            const path = folder + "/" + name;
            if (files.FS.isDir(files.FS.stat(path).mode)) files.list(path, found);
            else found.push(path);
        }
        return found;
    },

    // Stores text files; others, such as pictures, are downloaded only. What is not stored stays as it was stored last,
    // and the page says so.
    store(path, bytes) {
        if (!storage.shelf) return;
        const text = textOf(bytes);
        if (text === null) return storage.remove(path);
        if (storage.write(path, text)) {
            if (files.unstored.delete(path) && !files.unstored.size) notice.close("full");
        } else {
            files.unstored.add(path);
            notice.open("full", words.full, words.download.both, files.downloadLosses);
        }
    },

    // A page that contains this one may refuse downloads without a word: there the text can be copied, too.
    download(bytes, name) {
        const link = document.createElement("a");
        link.href = URL.createObjectURL(new Blob([bytes]));
        link.download = name;
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 60000);
        const text = window.top === window ? null : textOf(bytes);
        const shown = `download ${link.href}`;
        const copy = async () => {
            if (await copyText(text) && notice.shown === shown) element("notice-text").textContent = words.copied + name;
        };
        if (text !== null) notice.open(shown, words.framed + name, words.copy, copy);
    },

    // Progress and work that end with the page.
    losses() {
        const isLoss = (path) => path.startsWith(students + "/") || path.endsWith(".autosave");
        return (storage.shelf ? [...files.unstored] : files.list()).filter(isLoss);
    },

    // The names say what they are; the lab reads them again when they are dropped onto it.
    downloadLosses() {
        files.leave();
        const names = [];
        for (const path of files.losses()) {
            const bytes = files.FS.readFile(path);
            const own = path.slice(path.lastIndexOf("/") + 1).replace(/\.json$/, "");
            const name = path.endsWith(".autosave") ? `${JSON.parse(textOf(bytes)).autosave.name || "work"}.run`
                : `braitenlab-progress${own === "this-computer" ? "" : `-${own}`}.json`;
            files.download(bytes, name);
            names.push(name);
        }
        if (files.tellsLosses()) element("notice-text").textContent = words.downloaded.replace("{}", names.join(", "));
    },

    // True while the notice is about what is not kept. In a frame that of a download may follow it.
    tellsLosses: () => ["unkept", "full"].includes(notice.shown),

    // A notice about what is not kept has its button, which names what it downloads, while there is something.
    offerLosses() {
        if (!files.tellsLosses()) return;
        const losses = files.losses(), runs = losses.filter((path) => path.endsWith(".autosave")).length;
        element("notice-act").hidden = !losses.length;
        element("notice-act").textContent = words.download[!runs ? "progress" : runs === losses.length ? "run" : "both"];
    },

    // The browser may end the page without another event: the lab saves its work now.
    leave() {
        Module.ccall("braitenlab_leave", null, [], []);
        files.keep();
    },

    // Stores and downloads what has changed since the last call; forgets what has been removed. Files of another page
    // of the lab are left alone.
    keep() {
        const there = new Set(files.list());
        for (const path of files.known.keys()) {
            if (there.has(path)) continue;
            files.known.delete(path);
            files.unstored.delete(path);
            storage.remove(path);
        }
        for (const path of there) {
            const stamp = files.stamp(path);
            if (files.known.get(path) === stamp) continue;
            files.known.set(path, stamp);
            if (path === files.shown?.path) {
                if (!files.shown.window.closed) files.fillPage();
                continue;
            }
            const bytes = files.FS.readFile(path);
            files.store(path, bytes);
            if (!files.isOwn(path)) files.download(bytes, path.slice(path.lastIndexOf("/") + 1));
        }
        files.offerLosses();
    },

    // Shows a page that the lab has written in a window of its own, which follows the file. False if the browser
    // refuses the window.
    openPage(path) {
        const shown = window.open("", "braitenlab page", "popup,width=900,height=700");
        if (!shown) return false;
        files.shown = { path, window: shown };
        files.fillPage();
        shown.onkeydown = files.passOn;
        return true;
    },

    // A remote control for slides types into the window that was used last: its keys are the lab's in each.
    passOn(event) {
        const { key, code, shiftKey } = event;
        if (event.ctrlKey || event.altKey || event.metaKey || !["PageUp", "PageDown", "F5", "b", "B", "."].includes(key)) return;
        event.preventDefault();
        for (const type of ["keydown", "keyup"]) dispatchEvent(new KeyboardEvent(type, { key, code, shiftKey, bubbles: true }));
    },

    // The page stays open when the lab's ends.
    markPageAsOld() {
        if (!files.shown || files.shown.window.closed) return;
        const page = files.shown.window.document, line = page.createElement("p");
        line.textContent = words.ended_notes;
        line.style = "background: #f0b64a; color: #14181e; padding: 8px 16px; margin: 0";
        page.body.prepend(line);
    },

    fillPage() {
        const page = files.shown.window.document;
        const read = new DOMParser().parseFromString(files.FS.readFile(files.shown.path, { encoding: "utf8" }), "text/html");
        page.replaceChild(page.adoptNode(read.documentElement), page.documentElement);  // without its scripts
    },

    // Opens a file of the user's computer in the lab, as a file dropped onto a window.
    async open(file) {
        const folder = home + "/uploads";
        const path = folder + "/" + file.name.replaceAll("/", "_");
        const bytes = new Uint8Array(await file.arrayBuffer());
        files.FS.mkdirTree(folder);
        files.FS.writeFile(path, bytes);
        files.store(path, bytes);
        files.known.set(path, files.stamp(path));
        Module.ccall("braitenlab_open", null, ["string"], [path]);
    },

    // Lets the user choose files.
    choose() {
        const input = document.createElement("input");
        input.type = "file";
        input.accept = ".toml,.run,.json";
        input.multiple = true;
        input.onchange = () => [...input.files].forEach(files.open);
        input.click();
    },

    // From the start of the program on.
    follow() {
        if (!storage.shelf) {
            notice.open("unkept", words.unkept, words.download.both, files.downloadLosses);
            notice.offerWindow();
        }
        files.offerLosses();
        setInterval(files.keep, 500);
        addEventListener("beforeunload", (event) => {
            files.leave();
            if (files.losses().length) event.preventDefault();
        });
        addEventListener("pagehide", files.leave);
        addEventListener("pagehide", files.markPageAsOld);
        addEventListener("visibilitychange", () => (document.visibilityState === "hidden" ? files.leave() : files.takeOver(students)));
        addEventListener("popstate", address.follow_link);
        addEventListener("storage", files.followProgress);
        addEventListener("dragover", (event) => event.preventDefault());
        addEventListener("drop", (event) => {
            event.preventDefault();
            [...event.dataTransfer.files].forEach(files.open);
        });
        addEventListener("paste", (event) => {
            event.preventDefault();
            Module.pastedText = event.clipboardData.getData("text/plain");
            Module.ccall("braitenlab_paste", null, [], []);
        });
        addEventListener("contextmenu", (event) => event.preventDefault());
        // Ctrl and the wheel zoom the scene, not the page.
        addEventListener("wheel", (event) => event.ctrlKey && event.preventDefault(), { passive: false });
    },
};

// null for bytes that are no text.
function textOf(bytes) {
    try {
        return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
    } catch {
        return null;
    }
}

// Copies a text. Without permission for the clipboard, as on a page without a secure connection, by an older way.
// Resolves to false if the browser refuses both.
async function copyText(text) {
    const byField = () => {
        const field = document.createElement("textarea");
        field.value = text;
        document.body.append(field);
        field.select();
        const isCopied = document.execCommand("copy");
        field.remove();
        element("canvas").focus();
        return isCopied;
    };
    return navigator.clipboard ? navigator.clipboard.writeText(text).then(() => true, byField) : byField();
}
