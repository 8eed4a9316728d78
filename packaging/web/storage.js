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
    read: (path) => storage.shelf.getItem(storage.prefix + path),

    // False if the browser has no room for it: the earlier text stays.
    write(path, text) {
        try {
            storage.shelf.setItem(storage.prefix + path, text);
        } catch {
            return false;
        }
        return true;
    },

    remove: (path) => storage.shelf?.removeItem(storage.prefix + path),
};
