"use strict";
// Files of the lab in a browser. The program writes to a file system in memory; this keeps the home folder in the
// browser's storage and downloads what the user saves. Used by page.js, before the program starts.

const home = "/home/web_user";
const keyOf = (path) => "braitenlab:" + path;
const files = {
    known: new Map(),  // path → time of the last change that is stored or downloaded
    isOwn: (path) => path.startsWith(home + "/config/") || path.startsWith(home + "/state/"),

    // Copies the stored files into the file system.
    restore(FS) {
        files.FS = FS;
        for (let i = 0; i < localStorage.length; ++i) {
            const key = localStorage.key(i);
            if (!key.startsWith(keyOf(home + "/"))) continue;
            const path = key.slice(keyOf("").length);
            FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
            FS.writeFile(path, localStorage.getItem(key));
            files.known.set(path, files.changed(path));
        }
    },

    changed: (path) => files.FS.stat(path).mtime.getTime(),

    list(folder = home, found = []) {
        for (const name of files.FS.readdir(folder)) {
            if (name.startsWith(".")) continue;
            const path = folder + "/" + name;
            if (files.FS.isDir(files.FS.stat(path).mode)) files.list(path, found);
            else found.push(path);
        }
        return found;
    },

    // Stores text files; others, such as pictures, are downloaded only.
    store(path, bytes) {
        try {
            localStorage.setItem(keyOf(path), new TextDecoder("utf-8", { fatal: true }).decode(bytes));
        } catch (problem) {
            localStorage.removeItem(keyOf(path));
            if (!(problem instanceof TypeError)) console.warn(`${path} is not kept by the browser: ${problem.message}`);
        }
    },

    download(path, bytes) {
        const link = document.createElement("a");
        link.href = URL.createObjectURL(new Blob([bytes]));
        link.download = path.slice(path.lastIndexOf("/") + 1);
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    },

    // Stores and downloads what has changed since the last call; forgets what has been removed. Files of another page
    // of the lab are left alone.
    keep() {
        const there = new Set(files.list());
        for (const path of files.known.keys()) {
            if (there.has(path)) continue;
            files.known.delete(path);
            localStorage.removeItem(keyOf(path));
        }
        for (const path of there) {
            const changed = files.changed(path);
            if (files.known.get(path) === changed) continue;
            files.known.set(path, changed);
            const bytes = files.FS.readFile(path);
            files.store(path, bytes);
            if (!files.isOwn(path)) files.download(path, bytes);
        }
    },

    // Opens a file of the user's computer in the lab, as a file dropped onto a window.
    async open(file) {
        const folder = home + "/uploads";
        const path = folder + "/" + file.name.replaceAll("/", "_");
        const bytes = new Uint8Array(await file.arrayBuffer());
        files.FS.mkdirTree(folder);
        files.FS.writeFile(path, bytes);
        files.store(path, bytes);
        files.known.set(path, files.changed(path));
        Module.ccall("braitenlab_open", null, ["string"], [path]);
    },

    // Lets the user choose files.
    choose() {
        const input = document.createElement("input");
        input.type = "file";
        input.accept = ".toml,.run";
        input.multiple = true;
        input.onchange = () => [...input.files].forEach(files.open);
        input.click();
    },

    // From the start of the program on.
    follow() {
        setInterval(files.keep, 500);
        // The browser may end the page without another event: the lab saves its work now.
        const leave = () => {
            Module.ccall("braitenlab_leave", null, [], []);
            files.keep();
        };
        addEventListener("pagehide", leave);
        addEventListener("visibilitychange", () => document.visibilityState === "hidden" && leave());
        addEventListener("hashchange", () => {
            if (isLink(location.hash)) Module.ccall("braitenlab_open", null, ["string"], [location.hash]);
        });
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

// Copies a text. Without permission for the clipboard, as on a page without a secure connection, by an older way.
function copyText(text) {
    const byField = () => {
        const field = document.createElement("textarea");
        field.value = text;
        document.body.append(field);
        field.select();
        document.execCommand("copy");
        field.remove();
        element("canvas").focus();
    };
    navigator.clipboard ? navigator.clipboard.writeText(text).catch(byField) : byField();
}
