#include <cstdlib>
#include <map>
#include <utility>

#include <emscripten/emscripten.h>
#include <emscripten/html5.h>

#include "app/platform/page.h"
#include "app/platform/web_pacing.h"

namespace braitenlab {

namespace {

double next_turn = 0;  // ms, on the clock of the page

std::map<std::string, std::function<std::string()>>& offered() {
    static std::map<std::string, std::function<std::string()>> texts;
    return texts;
}

// clang-format off
EM_JS(void, tell_page_of_first_picture, (), { if (Module.onFirstPicture) Module.onFirstPicture(); });
EM_JS(void, tell_page_of_end, (), { if (Module.onEnd) Module.onEnd(); });
EM_JS(void, tell_page_of_document,
      (const char* title, const char* lecture, int page, int revealed, const char* document), {
    Module.onDocument(UTF8ToString(title), UTF8ToString(lecture), page, revealed, UTF8ToString(document));
});
// Calls braitenlab_work() in a task of its own, so that pictures and input come before it. A message, because a browser
// lets setTimeout(0) wait for 4 ms from the fifth call on (HTML standard, 8.6 Timers).
EM_JS(void, work_soon_on_page, (), {
    if (!Module.toWork) {
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () => _braitenlab_work();
        Module.toWork = port2;
    }
    Module.toWork.postMessage(0);
});
EM_JS(void, choose_files_on_page, (), { Module.chooseFiles(); });
EM_JS(bool, page_prefers_light, (), { return matchMedia("(prefers-color-scheme: light)").matches; });
// Empty for a page that has none, such as a frame by srcdoc. Released by the caller.
EM_JS(char*, address_of_page, (), {
    const text = (/^(https?|file):/.test(location.href) ? location.href : "").split(/[?#]/)[0];
    const size = lengthBytesUTF8(text) + 1;
    const bytes = _malloc(size);
    stringToUTF8(text, bytes, size);
    return bytes;
});
// clang-format on

std::function<void()> keep_work;
std::function<bool()> background;
bool background_is_due = false;

void work_soon() {
    if (background && !std::exchange(background_is_due, true)) work_soon_on_page();
}

}  // namespace

namespace web {

void put_off(double seconds) { next_turn = emscripten_get_now() + seconds * 1000; }
void wake() { next_turn = 0; }
bool is_due() { return emscripten_get_now() >= next_turn; }

}  // namespace web

void repeat(std::function<bool()> turn) {
    struct Loop {
        std::function<bool()> turn;
        bool drawn = false;
    };
    emscripten_set_main_loop_arg(
        [](void* argument) {
            auto& loop = *static_cast<Loop*>(argument);
            if (!web::is_due()) return;
            if (!loop.turn()) {
                emscripten_cancel_main_loop();
                keep_work = nullptr;  // the lab has kept or removed its work; the page is left later
                return tell_page_of_end();
            }
            if (!std::exchange(loop.drawn, true)) tell_page_of_first_picture();
            work_soon();
        },
        new Loop{std::move(turn)}, 0, 0);  // until the page is closed
}

bool is_on_page() { return true; }

bool prefers_light() { return page_prefers_light(); }

std::string page_address() {
    char* bytes = address_of_page();
    std::string address = bytes;
    std::free(bytes);
    return address;
}

void tell_page(const DocumentOnPage& now) {
    static DocumentOnPage told;
    if (now == told) return;
    told = now;
    tell_page_of_document(now.title.c_str(), now.lecture.c_str(), now.page, now.revealed, now.document.c_str());
}

void work_between_turns(std::function<bool()> work) { background = std::move(work); }

void choose_files() { choose_files_on_page(); }

void when_page_is_left(std::function<void()> keep) { keep_work = std::move(keep); }

void offer_to_page(const std::string& name, std::function<std::string()> json) { offered()[name] = std::move(json); }

}  // namespace braitenlab

extern "C" EMSCRIPTEN_KEEPALIVE void braitenlab_leave() {
    if (braitenlab::keep_work) braitenlab::keep_work();
}

extern "C" EMSCRIPTEN_KEEPALIVE void braitenlab_work() {
    braitenlab::background_is_due = false;
    if (braitenlab::background()) braitenlab::work_soon();
}

// For scripts of the page. The text is valid until the next call.
extern "C" EMSCRIPTEN_KEEPALIVE const char* braitenlab_text(const char* name) {
    static std::string text;
    const auto found = braitenlab::offered().find(name);
    text = found == braitenlab::offered().end() ? "null" : found->second();
    return text.c_str();
}
