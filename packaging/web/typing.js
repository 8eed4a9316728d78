"use strict";
// Text that no key event has: of a keyboard on the screen, an input method or a dead key. While the lab awaits text, an
// invisible field has the focus, so that the browser shows its keyboard; what changes in the field is typed into the lab.
// Keys that the lab takes do not reach the field.

const typing = {
    wanted: false,
    kept: "    ",  // Backspace in an empty field is no event
    last: "    ",

    field: () => element("typing"),

    type(code) {
        Module.ccall("braitenlab_type", null, ["number"], [code]);
    },

    empty() {
        typing.field().value = typing.last = typing.kept;
        typing.field().setSelectionRange(typing.kept.length, typing.kept.length);
    },

    // The lab awaits text, or no longer. A browser may show its keyboard only while it handles a touch: see follow().
    // `number`: the keyboard with digits and the decimal mark of the language.
    want(wanted, number) {
        typing.wanted = wanted;
        typing.field().inputMode = number ? "decimal" : "text";
        if (!wanted) return element("canvas").focus();
        typing.empty();
        typing.field().focus({ preventScroll: true });
    },

    // Where the characters appear, for the list of an input method. Pixels of the lab.
    place(x, y) {
        Object.assign(typing.field().style, { left: `${x / density()}px`, top: `${y / density()}px` });
    },

    // What has changed in the field since the last event: characters to erase, characters to type.
    follow_change() {
        const before = [...typing.last], now = [...typing.field().value];
        typing.last = typing.field().value;
        let same = 0;
        while (same < before.length && same < now.length && before[same] === now[same]) ++same;
        for (let i = same; i < before.length; ++i) typing.type(8);
        for (const character of now.slice(same)) typing.type(character.codePointAt(0));
    },

    // From the start of the program on.
    follow() {
        const field = typing.field();
        field.addEventListener("input", (event) => {
            typing.follow_change();
            if (!event.isComposing && field.value.length < 2) typing.empty();
        });
        field.addEventListener("beforeinput", (event) => {
            if (event.inputType !== "insertLineBreak") return;
            event.preventDefault();
            typing.type(13);
        });
        // A press gives the focus to the canvas.
        for (const end of ["touchend", "mouseup"])
            addEventListener(end, () => typing.wanted && field.focus({ preventScroll: true }));
    },
};
