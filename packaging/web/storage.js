"use strict";
// What the browser keeps for the lab: the texts of files by their path, of all pages of the lab in this browser.

const storage = {
    // null where the browser refuses it: cookies are blocked, or the page is inside another site's.
    shelf: (() => {
        try {
            localStorage.getItem("");
            return localStorage;
        } catch {
            return null;
        }
    })(),
    seen: new Map(),  // path → text that was read or written last
    prefix: "braitenlab:",

    paths() {
        const found = [];
        for (let i = 0; storage.shelf && i < storage.shelf.length; ++i) {
            const key = storage.shelf.key(i);
            if (key.startsWith(storage.prefix + "/")) found.push(key.slice(storage.prefix.length));
        }
        return found;
    },

    // null if there is none.
    read(path) {
        const text = storage.shelf.getItem(storage.prefix + path);
        storage.seen.set(path, text);
        return text;
    },

    // False if the browser has no room for it: the earlier text stays.
    write(path, text) {
        try {
            storage.shelf.setItem(storage.prefix + path, text);
        } catch {
            return false;
        }
        storage.seen.set(path, text);
        return true;
    },

    remove(path) {
        storage.seen.delete(path);
        storage.shelf?.removeItem(storage.prefix + path);
    },

    // True if another page of the lab has written the text since.
    isNewer: (path) => storage.seen.get(path) !== storage.shelf.getItem(storage.prefix + path),
};

// The open pages of the lab in this browser: each has a number and holds a lock with this number until it ends.
// Without a secure connection the browser has no locks, and only this page is known.
const pages = {
    number: crypto.getRandomValues(new Uint32Array(1))[0] >>> 1,
    others: new Set(),

    async find() {
        const name = "braitenlab page ";
        try {
            navigator.locks.request(name + pages.number, () => new Promise(() => {})).catch(() => {});
            for (const lock of (await navigator.locks.query()).held)
                if (lock.name.startsWith(name)) pages.others.add(Number(lock.name.slice(name.length)));
            pages.others.delete(pages.number);
        } catch {
            // The browser refuses them, as it refuses the storage.
        }
    },

    // True for the file of unsaved work of another page, which is open.
    owns: (path) => pages.others.has(Number(/-(\d+)\.autosave$/.exec(path)?.[1])),
};
