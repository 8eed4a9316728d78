"use strict";
// The page: checks the browser, loads the program with a progress bar, and starts it. make_page.py sets `built`.

const texts = {
    en: {
        loads: "Loading …", again: "Start again",
        old: "This browser is too old for the lab. Use a current version of Firefox, Chrome, Edge or Safari.",
        graphics: "The lab needs WebGL 2, which this browser does not offer here. Switch on hardware acceleration in " +
                  "the browser’s settings, or use a current version of Firefox, Chrome, Edge or Safari.",
        missing: "A file of the lab could not be loaded: ",
        server: "This page needs a web server. Without one, open braitenlab-web.html, which is a single file.",
        stopped: "The lab has stopped. Your work up to the last seconds is kept and offered at the next start. ",
        ended: "The lab is closed.",
        unkept: "This browser lets the page keep nothing: your work ends with the page. Ctrl+S downloads it.",
        full: "The browser’s storage is full: your newest work is not kept in this browser.",
        download: "Download it", close: "Close",
    },
    de: {
        loads: "Wird geladen …", again: "Neu starten",
        old: "Dieser Browser ist zu alt für das Labor. Nötig ist eine aktuelle Version von Firefox, Chrome, Edge oder Safari.",
        graphics: "Das Labor braucht WebGL 2, das dieser Browser hier nicht bietet. Schalten Sie in den Einstellungen " +
                  "des Browsers die Hardwarebeschleunigung ein, oder nehmen Sie eine aktuelle Version von Firefox, Chrome, Edge oder Safari.",
        missing: "Eine Datei des Labors konnte nicht geladen werden: ",
        server: "Diese Seite braucht einen Webserver. Ohne Webserver öffnen Sie braitenlab-web.html, eine einzelne Datei.",
        stopped: "Das Labor wurde angehalten. Ihre Arbeit bis auf die letzten Sekunden ist gespeichert und wird beim nächsten Start angeboten. ",
        ended: "Das Labor ist geschlossen.",
        unkept: "Dieser Browser lässt die Seite nichts aufbewahren: Ihre Arbeit endet mit der Seite. Strg+S lädt sie herunter.",
        full: "Der Speicher des Browsers ist voll: Ihre neueste Arbeit wird in diesem Browser nicht aufbewahrt.",
        download: "Herunterladen", close: "Schließen",
    },
    es: {
        loads: "Cargando…", again: "Iniciar de nuevo",
        old: "Este navegador es demasiado antiguo para el laboratorio. Use una versión actual de Firefox, Chrome, Edge o Safari.",
        graphics: "El laboratorio necesita WebGL 2, que este navegador no ofrece aquí. Active la aceleración por hardware " +
                  "en la configuración del navegador, o use una versión actual de Firefox, Chrome, Edge o Safari.",
        missing: "No se pudo cargar un archivo del laboratorio: ",
        server: "Esta página necesita un servidor web. Sin servidor, abra braitenlab-web.html, que es un solo archivo.",
        stopped: "El laboratorio se ha detenido. Su trabajo, salvo los últimos segundos, está guardado y se ofrecerá al iniciar de nuevo. ",
        ended: "El laboratorio está cerrado.",
        unkept: "Este navegador no permite a la página guardar nada: su trabajo termina con la página. Ctrl+S lo descarga.",
        full: "El almacenamiento del navegador está lleno: su trabajo más reciente no se guarda en este navegador.",
        download: "Descargarlo", close: "Cerrar",
    },
};
const query = new URLSearchParams(location.search);
const language = query.get("lang") || navigator.language.slice(0, 2);
const words = texts[language] || texts.en;
document.documentElement.lang = texts[language] ? language : "en";

const element = (id) => document.getElementById(id);

function show(message, withButton) {
    element("message").textContent = message;
    element("bar").hidden = true;
    element("again").hidden = !withButton;
    element("cover").hidden = false;
}

element("message").textContent = words.loads;
element("again").textContent = words.again;
element("again").onclick = () => location.reload();

// What the browser lacks; an empty text if nothing.
function whatIsMissing() {
    if (typeof WebAssembly !== "object" || !WebAssembly.Tag || typeof DecompressionStream !== "function") return words.old;
    // The program uses this context. It draws smooth edges by itself (render/gl/resampling.h).
    const context = element("canvas").getContext("webgl2", { antialias: false });
    if (!context) return words.graphics;
    const info = context.getExtension("WEBGL_debug_renderer_info");
    const renderer = info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
    keepValues(context, renderer);
    const inSoftware = /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer);
    if (inSoftware && !query.has("quality")) Module.arguments.push("--quality=auto-low");
    return "";
}

// ── Notices over the lab ──

const notice = {
    shown: "",  // name of the last notice; the user may have hidden it

    // With the words of a button and what it does, or without.
    open(name, message, button, act) {
        if (notice.shown === name) return;
        notice.shown = name;
        element("notice-text").textContent = message;
        element("notice-act").hidden = !button;
        element("notice-act").textContent = button ?? "";
        element("notice-act").onclick = act;
        element("notice").hidden = false;
    },

    close(name) {
        if (notice.shown !== name) return;
        notice.hide();
        notice.shown = "";
    },

    hide() {
        element("notice").hidden = true;
        element("canvas").focus();
    },
};
element("notice-close").setAttribute("aria-label", words.close);
element("notice-close").onclick = notice.hide;

// ── Loading ──

const received = {};

function count(name, bytes) {
    received[name] = (received[name] ?? 0) + bytes;
    const sum = (values) => Object.values(values).reduce((a, b) => a + b, 0);
    element("bar").value = Math.min(1, sum(received) / sum(built.sizes));
}

// The compressed bytes of a file of the program: from this page if it contains them, else from the server.
async function bytesOf(name) {
    const inside = element(name);
    if (inside) {
        const packed = Uint8Array.from(atob(inside.textContent.trim()), (c) => c.charCodeAt(0));
        inside.remove();
        return new Blob([packed]).stream();
    }
    const answer = await fetch(`${name}.gz?${built.version}`);
    if (!answer.ok) throw new Error(`${name} (${answer.status})`);
    return answer.body;
}

// The bytes of a file of the program, unpacked. A server may declare the compression; then the browser has undone it.
async function load(name, type) {
    const reader = (await bytesOf(name)).getReader();
    const first = await reader.read();
    const isPacked = first.value?.[0] === 0x1f;
    let next = first;
    const bytes = new ReadableStream({
        async pull(controller) {
            const { done, value } = next ?? await reader.read();
            next = null;
            if (done) return controller.close();
            count(name, value.length);
            controller.enqueue(value);
        },
    });
    const unpacked = isPacked ? bytes.pipeThrough(new DecompressionStream("gzip")) : bytes;
    return new Response(unpacked, { headers: { "Content-Type": type } });
}

// ── The program ──

// A scene or an exercise in the address (core/io/link.h).
const isLink = (text) => /^#[be]\d/.test(text);

// The page of the open lecture, which a reload opens again. Each page of the lab has its own.
const lectures = {
    key: "braitenlab:lecture",

    // `name`: of the open document, or empty; `file`: of the open lecture, or empty; `page` counts from 1.
    follow(name, file, page, revealed) {
        document.title = name ? `${name} – Braitenlab` : "Braitenlab";
        try {
            if (file) sessionStorage.setItem(lectures.key, JSON.stringify([file, page, revealed]));
            else sessionStorage.removeItem(lectures.key);
        } catch {
            // The browser keeps nothing: a reload begins anew.
        }
    },

    // Options of the command line; empty if the page is not reloaded in a lecture.
    again() {
        try {
            if (performance.getEntriesByType("navigation")[0]?.type !== "reload") return [];
            const [file, page, revealed] = JSON.parse(sessionStorage.getItem(lectures.key)) ?? [];
            return file ? [file, `--page=${page}`, `--revealed=${revealed}`] : [];
        } catch {
            return [];
        }
    },
};

// The document of the start: of a lecture that was open before a reload, or of the address.
function documentArguments() {
    const again = lectures.again();
    if (again.length) return again;
    if (isLink(location.hash)) return [location.hash];
    return query.get("open") ? [query.get("open").replace(/^-+/, "")] : [];
}

// What the address asks for, as options of the command line: ?open=3a-love&lang=de&play
function programArguments() {
    const list = documentArguments();
    for (const name of ["lang", "seed", "scale", "camera", "quality"])
        if (query.get(name)) list.push(`--${name}=${query.get(name)}`);
    for (const name of ["play", "lecture", "projector"])
        if (query.has(name)) list.push(`--${name}`);
    return list;
}

var Module = {
    canvas: element("canvas"),
    arguments: programArguments(),
    print: (text) => console.log(text),
    printErr: (text) => console.warn(text),
    pageNumber: pages.number,
    preRun: [() => files.restore(FS)],
    takeOver: files.takeOver,
    keepFiles: files.keep,
    openPage: files.openPage,
    onDocument: lectures.follow,
    copyText,
    chooseFiles: files.choose,
    typing,
    onFirstPicture() {
        element("cover").hidden = true;
        element("canvas").focus();
        window.braitenlab.ready = true;
        files.follow();
        typing.follow();
        performance.mark("first picture");
    },
    onEnd: () => show(words.ended, true),
    onAbort: (reason) => show(words.stopped + reason, true),
};

window.addEventListener("error", (event) => {
    if (window.braitenlab.ready) show(words.stopped + event.message, true);
});

// The system takes the graphics away, for example after a fault of the driver.
element("canvas").addEventListener("webglcontextlost", () => show(words.stopped, true));

// Pixels of the lab per pixel of the page: a small page shows the lab reduced.
const density = () => element("canvas").width / element("canvas").clientWidth;

// For scripts: what --state and --anchors write. Rectangles are in pixels of the page, as mouse events are.
window.braitenlab = {
    ready: false,
    state: () => JSON.parse(Module.ccall("braitenlab_text", "string", ["string"], ["state"])),
    anchors() {
        const rectangles = JSON.parse(Module.ccall("braitenlab_text", "string", ["string"], ["anchors"]));
        for (const name in rectangles) rectangles[name] = rectangles[name].map((v) => v / density());
        return rectangles;
    },
};

// The program is compiled while it arrives.
async function start() {
    const finding = pages.find();
    const compiling = load("braitenlab.wasm", "application/wasm").then(WebAssembly.compileStreaming);
    const loading = Promise.all([
        load("braitenlab.data", "application/octet-stream").then((answer) => answer.arrayBuffer()),
        load("braitenlab.js", "text/javascript").then((answer) => answer.text()),
        compiling, finding,
    ]);
    const missing = whatIsMissing();
    if (missing) return loading.catch(() => {}), show(missing, false);
    try {
        const [data, script, program] = await loading;
        Module.instantiateWasm = (imports, use) => {
            WebAssembly.instantiate(program, imports).then((instance) => use(instance, program));
            return {};
        };
        Module.getPreloadedPackage = () => data;
        const tag = document.createElement("script");
        tag.textContent = script;
        document.body.append(tag);
    } catch (problem) {
        show(location.protocol === "file:" ? words.server : words.missing + problem.message, true);
    }
}

start();
