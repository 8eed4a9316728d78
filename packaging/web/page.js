"use strict";
// The page: checks the browser, loads the program with a progress bar, and starts it. make_page.py sets `built`.

const texts = {
    en: {
        loads: "Loading …", share: "{} % of {} MB", again: "Start again",
        old: "This browser is too old for the lab. Use a current version of Firefox, Chrome, Edge or Safari.",
        graphics: "The lab needs WebGL 2, which this browser does not offer here. Switch on hardware acceleration in " +
                  "the browser’s settings, or use a current version of Firefox, Chrome, Edge or Safari.",
        missing: "A file of the lab could not be loaded: ",
        server: "This page needs a web server. Without one, open braitenlab-web.html, which is a single file.",
        stopped: "The lab has stopped. Your work up to the last seconds is kept and offered at the next start. ",
        ended: "The lab is closed.",
        unkept: "This browser lets the page keep nothing: your progress and your work are lost when this page is closed.",
        own: "In a window of its own the lab may keep them",
        full: "The browser’s storage is full: your newest work is not kept in this browser. Download it here, or by " +
              "Exercises > Student… > Save progress; the lab reads the files that are dropped onto it.",
        download: { progress: "Download progress", run: "Download run", both: "Download progress and run" }, close: "Close",
        downloaded: "The browser was given these files to download: {}. Next time, drop them onto the lab, or open them with " +
                    "Ctrl+O > Upload.",
        framed: "The page that contains this one may refuse downloads. If this file is not among yours, copy its text: ",
        copy: "Copy its text", copied: "Its text is copied. Paste it into a file of this name: ",
        unreachable: "the server does not send it",
        page: "in its place the server sends a web page, perhaps of a login: ",
        damaged: "it is incomplete or damaged",
        sandbox: "The page that contains this one does not let it load its files: its frame needs sandbox=\"allow-scripts " +
                 "allow-same-origin allow-downloads\". Or open the lab in a window of its own.",
        refused: "The address of this page has a part that the lab does not know: ", without: "Start without it",
        unknown: "The lab does not know this part of the page’s address and starts without it: ",
        lost: "The browser has taken the graphics from the lab, for example after a fault of the driver. Your work is kept: start again.",
        ended_notes: "These notes no longer follow the lecture: the page of the lab was closed or loaded again. Shift+N in the lab opens them anew.",
    },
    de: {
        loads: "Wird geladen …", share: "{} % von {} MB", again: "Neu starten",
        old: "Dieser Browser ist zu alt für das Labor. Nötig ist eine aktuelle Version von Firefox, Chrome, Edge oder Safari.",
        graphics: "Das Labor braucht WebGL 2, das dieser Browser hier nicht bietet. Schalten Sie in den Einstellungen " +
                  "des Browsers die Hardwarebeschleunigung ein, oder nehmen Sie eine aktuelle Version von Firefox, Chrome, Edge oder Safari.",
        missing: "Eine Datei des Labors konnte nicht geladen werden: ",
        server: "Diese Seite braucht einen Webserver. Ohne Webserver öffnen Sie braitenlab-web.html, eine einzelne Datei.",
        stopped: "Das Labor wurde angehalten. Ihre Arbeit bis auf die letzten Sekunden ist gespeichert und wird beim nächsten Start angeboten. ",
        ended: "Das Labor ist geschlossen.",
        unkept: "Dieser Browser lässt die Seite nichts aufbewahren: Lernstand und Arbeit gehen verloren, wenn Sie diese Seite schließen.",
        own: "In einem eigenen Fenster kann das Labor sie aufbewahren",
        full: "Der Speicher des Browsers ist voll: Ihre neueste Arbeit wird in diesem Browser nicht aufbewahrt. " +
              "Laden Sie sie hier herunter, oder mit Übungen > Lernende… > Lernstand sichern; das Labor liest Dateien, die darauf gezogen werden.",
        download: { progress: "Lernstand herunterladen", run: "Lauf herunterladen", both: "Lernstand und Lauf herunterladen" },
        close: "Schließen",
        downloaded: "Der Browser hat diese Dateien zum Herunterladen erhalten: {}. Ziehen Sie sie beim nächsten Mal auf das Labor, " +
                    "oder öffnen Sie sie mit Strg+O > Hochladen.",
        framed: "Die Seite, die diese enthält, kann Downloads verbieten. Liegt diese Datei nicht bei Ihren Downloads, kopieren Sie ihren Text: ",
        copy: "Text kopieren", copied: "Der Text ist kopiert. Fügen Sie ihn in eine Datei dieses Namens ein: ",
        unreachable: "der Server sendet sie nicht",
        page: "der Server sendet stattdessen eine Webseite, vielleicht eine Anmeldung: ",
        damaged: "sie ist unvollständig oder beschädigt",
        sandbox: "Die Seite, die diese enthält, lässt sie ihre Dateien nicht laden: ihr Rahmen braucht sandbox=\"allow-scripts " +
                 "allow-same-origin allow-downloads\". Oder öffnen Sie das Labor in einem eigenen Fenster.",
        refused: "Die Adresse dieser Seite hat einen Teil, den das Labor nicht kennt: ", without: "Ohne ihn starten",
        unknown: "Das Labor kennt diesen Teil der Adresse nicht und startet ohne ihn: ",
        lost: "Der Browser hat dem Labor die Grafik entzogen, zum Beispiel nach einem Fehler des Treibers. Ihre Arbeit ist gespeichert: starten Sie neu.",
        ended_notes: "Diese Notizen folgen dem Vortrag nicht mehr: die Seite des Labors wurde geschlossen oder neu geladen. Umschalt+N im Labor öffnet sie neu.",
    },
    es: {
        loads: "Cargando…", share: "{} % de {} MB", again: "Iniciar de nuevo",
        old: "Este navegador es demasiado antiguo para el laboratorio. Use una versión actual de Firefox, Chrome, Edge o Safari.",
        graphics: "El laboratorio necesita WebGL 2, que este navegador no ofrece aquí. Active la aceleración por hardware " +
                  "en la configuración del navegador, o use una versión actual de Firefox, Chrome, Edge o Safari.",
        missing: "No se pudo cargar un archivo del laboratorio: ",
        server: "Esta página necesita un servidor web. Sin servidor, abra braitenlab-web.html, que es un solo archivo.",
        stopped: "El laboratorio se ha detenido. Su trabajo, salvo los últimos segundos, está guardado y se ofrecerá al iniciar de nuevo. ",
        ended: "El laboratorio está cerrado.",
        unkept: "Este navegador no permite a la página guardar nada: su progreso y su trabajo se pierden al cerrar esta página.",
        own: "En una ventana propia el laboratorio puede guardarlos",
        full: "El almacenamiento del navegador está lleno: su trabajo más reciente no se guarda en este navegador. " +
              "Descárguelo aquí o con Ejercicios > Estudiante… > Guardar progreso; el laboratorio lee los archivos que se arrastran sobre él.",
        download: { progress: "Descargar el progreso", run: "Descargar la simulación", both: "Descargar progreso y simulación" },
        close: "Cerrar",
        downloaded: "El navegador ha recibido estos archivos para descargarlos: {}. La próxima vez, arrástrelos sobre el " +
                    "laboratorio o ábralos con Ctrl+O > Subir.",
        framed: "La página que contiene esta puede impedir las descargas. Si este archivo no está entre las suyas, copie su texto: ",
        copy: "Copiar su texto", copied: "El texto está copiado. Péguelo en un archivo de este nombre: ",
        unreachable: "el servidor no lo envía",
        page: "en su lugar el servidor envía una página web, quizá de inicio de sesión: ",
        damaged: "está incompleto o dañado",
        sandbox: "La página que contiene esta no le permite cargar sus archivos: su marco necesita sandbox=\"allow-scripts " +
                 "allow-same-origin allow-downloads\". O abra el laboratorio en una ventana propia.",
        refused: "La dirección de esta página tiene una parte que el laboratorio no conoce: ", without: "Iniciar sin ella",
        unknown: "El laboratorio no conoce esta parte de la dirección y se inicia sin ella: ",
        lost: "El navegador ha retirado los gráficos al laboratorio, por ejemplo tras un fallo del controlador. Su trabajo está guardado: inicie de nuevo.",
        ended_notes: "Estas notas ya no siguen la clase: la página del laboratorio se cerró o se cargó de nuevo. Mayús+N en el laboratorio las abre otra vez.",
    },
};
const query = new URLSearchParams(location.search);
const language = query.get("lang") || navigator.language.slice(0, 2);
const words = texts[language] || texts.en;
document.documentElement.lang = texts[language] ? language : "en";

const element = (id) => document.getElementById(id);

function show(message, withButton) {
    element("message").textContent = message;
    element("bar").hidden = element("share").hidden = true;
    element("again").hidden = !withButton;
    element("cover").hidden = false;
}

element("message").textContent = words.loads;
element("again").textContent = words.again;
element("again").onclick = () => location.reload();

// What the browser lacks; an empty text if nothing.
function whatIsMissing() {
    if (typeof WebAssembly !== "object" || !WebAssembly.Tag || typeof DecompressionStream !== "function") return words.old;
    // The program uses this context. It draws smooth edges by itself (render/gl/resampling.h). Nothing is seen through it,
    // so the browser need not blend it with the page.
    const context = element("canvas").getContext("webgl2", { antialias: false, alpha: false });
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
        element("notice-own").hidden = true;
        element("notice").hidden = false;
    },

    // A frame of another site has no storage, or one of its own; a window has that of the lab.
    offerWindow() {
        if (window.top === window || !/^https?:/.test(location.protocol)) return;
        element("notice-own").href = location.href;
        element("notice-own").textContent = words.own;
        element("notice-own").hidden = false;
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

const received = {};  // compressed bytes

// `isPacked`: the bytes are compressed; else the browser has unpacked them.
function count(name, bytes, isPacked) {
    received[name] = (received[name] ?? 0) + (isPacked ? bytes : bytes * built.sizes[name] / built.unpacked[name]);
    const sum = (values) => Object.values(values).reduce((a, b) => a + b, 0);
    const share = Math.min(1, sum(received) / sum(built.sizes));
    const size = (sum(built.sizes) / 1e6).toLocaleString(document.documentElement.lang, { maximumFractionDigits: 1 });
    element("bar").value = share;
    element("share").textContent = words.share.replace("{}", Math.floor(100 * share)).replace("{}", size);
}

// The compressed bytes of a file of the program: from this page if it contains them, else from the server.
async function bytesOf(name) {
    const inside = element(name);
    if (inside) {
        const packed = Uint8Array.from(atob(inside.textContent.trim()), (c) => c.charCodeAt(0));
        inside.remove();
        return new Blob([packed]).stream();
    }
    const answer = await fetch(`${name}.gz?${built.version}`).catch(() => {
        throw new Unloaded(window.origin === "null" ? words.sandbox : `${words.missing}${name}: ${words.unreachable}`);
    });
    if (!answer.ok) throw new Unloaded(`${words.missing}${name} (${answer.status})`);
    return answer.body;
}

// Why a file of the program is not loaded, in words for the user.
class Unloaded extends Error {}

// The same for a fault of its bytes.
function damaged(name) {
    return (problem) => {
        throw problem instanceof Unloaded ? problem : new Unloaded(`${words.missing}${name}: ${words.damaged}`);
    };
}

// The bytes of a file of the program, unpacked. A server may declare the compression; then the browser has undone it.
async function load(name, type) {
    const reader = (await bytesOf(name)).getReader();
    const first = await reader.read();
    const beginning = new TextDecoder().decode(first.value?.slice(0, 80)).trim();
    if (beginning.startsWith("<")) throw new Unloaded(`${words.missing}${name}: ${words.page}${beginning} …`);
    const isPacked = first.value?.[0] === 0x1f;
    let next = first;
    const bytes = new ReadableStream({
        async pull(controller) {
            const { done, value } = next ?? await reader.read();
            next = null;
            if (done) return controller.close();
            count(name, value.length, isPacked);
            controller.enqueue(value);
        },
    });
    const unpacked = isPacked ? bytes.pipeThrough(new DecompressionStream("gzip")) : bytes;
    return new Response(unpacked, { headers: { "Content-Type": type } });
}

// ── The program ──

// A scene or an exercise in the address (core/io/link.h).
const isLink = (text) => /^#[be]/.test(text);

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

// The address is that of the open document, or names none.
const address = {
    opening: true,  // the next document is that of the address
    open: undefined,
    lecture: "",    // file of the open lecture

    // Whether the address may have opened this document: its file, or "#" and a number of one that came by a link.
    fits(document) {
        const exercise = /^#e\d+\.(.*)$/.exec(location.hash)?.[1];
        if (exercise) return document.endsWith(`/${exercise}.toml`);
        return !isLink(location.hash) || document.startsWith("#");
    },

    // `lecture`: its file, or empty. A lecture is one document, whichever its page. The scene that it leaves open is
    // named: it is in no list of the lab that a reload would open again.
    follow(document, lecture) {
        const open = lecture || document;
        if (open === address.open) return;
        const wasOpening = address.opening, wasLecture = address.lecture;
        address.open = open, address.opening = false, address.lecture = lecture;
        if (wasOpening && address.fits(open)) return;
        const kept = new URLSearchParams(location.search);
        for (const key of ["open", "seed", "camera", "play"]) kept.delete(key);
        const shipped = /^\/data\/exercises\/.*\/([^/]+)\.toml$/.exec(document)?.[1];
        if (wasLecture && !lecture && shipped) kept.set("open", shipped);
        history.replaceState(null, "", `${location.pathname}?${kept}`.replace(/\?$/, ""));
    },

    // Opens the link in the address. A link that is followed again changes nothing in the address.
    follow_link() {
        if (!isLink(location.hash)) return;
        address.opening = true;
        Module.ccall("braitenlab_open", null, ["string"], [location.hash]);
    },
};

// The document of the start: of a lecture that was open before a reload, or of the address.
function documentArguments() {
    const again = lectures.again();
    if (again.length) return again;
    if (isLink(location.hash)) return [location.hash];
    return query.get("open") ? [query.get("open").replace(/^-+/, "")] : [];
}

const valueOptions = ["lang", "seed", "scale", "camera", "quality"], switches = ["play", "lecture", "projector"];

// What the address asks for, as options of the command line: ?open=3a-love&lang=de&play
function programArguments() {
    const list = documentArguments();
    for (const name of valueOptions)
        if (query.get(name)) list.push(`--${name}=${query.get(name)}`);
    for (const name of switches)
        if (query.has(name)) list.push(`--${name}`);
    return list;
}

// Learning platforms add options of their own to an address: these do not keep the lab from starting.
function tellUnknownOptions() {
    const unknown = [...query.keys()].filter((name) => !["open", ...valueOptions, ...switches].includes(name));
    if (unknown.length) notice.open("unknown", words.unknown + unknown.join(", "));
}

// What the program has said before its first picture.
const complaints = [];

var Module = {
    canvas: element("canvas"),
    arguments: programArguments(),
    print: (text) => console.log(text),
    printErr(text) {
        if (!window.braitenlab.ready) complaints.push(text.replace(/^braitenlab: /, ""));
        console.warn(text);
    },
    // It ends before its first picture if it refuses an option of the address.
    quit(status, ended) {
        if (status && !window.braitenlab.ready) {
            show(words.refused + complaints[0], true);
            element("again").textContent = words.without;
            element("again").onclick = () => location.assign(location.pathname + location.hash);
        }
        throw ended;
    },
    pageNumber: pages.number,
    preRun: [() => files.restore(FS)],
    takeOver: files.takeOver,
    keepFiles: files.keep,
    openPage: files.openPage,
    onDocument(title, lecture, page, revealed, document) {
        lectures.follow(title, lecture, page, revealed);
        address.follow(document, lecture);
    },
    copyText,
    chooseFiles: files.choose,
    typing,
    onFirstPicture() {
        element("cover").hidden = true;
        element("canvas").focus();
        window.braitenlab.ready = true;
        tellUnknownOptions();
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
element("canvas").addEventListener("webglcontextlost", () => {
    if (window.braitenlab.ready) files.leave();
    show(words.lost, true);
});

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
    const receive = (name, type, use) => load(name, type).then(use).catch(damaged(name));
    const loading = Promise.all([
        receive("braitenlab.data", "application/octet-stream", (answer) => answer.arrayBuffer()),
        receive("braitenlab.js", "text/javascript", (answer) => answer.text()),
        receive("braitenlab.wasm", "application/wasm", WebAssembly.compileStreaming), finding,
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
        show(location.protocol === "file:" ? words.server : problem.message, true);
    }
}

start();
