// The window in a browser: a canvas that fills the page, with WebGL 2. A window pixel is a pixel of the display.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <GLES3/gl3.h>
#include <backends/imgui_impl_opengl3.h>
#include <emscripten/emscripten.h>
#include <emscripten/html5.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "app/imgui_opengl.h"
#include "app/platform/web_keys.h"
#include "app/platform/web_pacing.h"
#include "app/platform/web_touch.h"
#include "app/window.h"
#include "ui/mouse_queue.h"
#include "ui/wiring/canvas.h"

// clang-format off
EM_JS(void, set_page_cursor, (const char* name), { Module.canvas.style.cursor = UTF8ToString(name); });
EM_JS(void, copy_on_page, (const char* text), { Module.copyText(UTF8ToString(text)); });
// The text of the last paste event; released by the caller.
EM_JS(char*, pasted_on_page, (), {
    const text = Module.pastedText || "";
    const size = lengthBytesUTF8(text) + 1;
    const bytes = _malloc(size);
    stringToUTF8(text, bytes, size);
    return bytes;
});
EM_JS(void, want_text_on_page, (bool wanted, bool number), { Module.typing.want(wanted, number); });
EM_JS(void, place_text_on_page, (int x, int y), { Module.typing.place(x, y); });
EM_JS(bool, is_for_fingers, (), { return matchMedia("(pointer: coarse)").matches; });
EM_JS(void, toggle_full_page, (), {
    if (document.fullscreenElement) document.exitFullscreen();
    else document.documentElement.requestFullscreen().catch(() => {});
});
// clang-format on

static_assert(sizeof(ImDrawIdx) == 4, "WebGL 2 draws no list of more than 65,536 vertices by indices of 16 bits");

namespace braitenlab {

namespace {

constexpr const char* canvas = "#canvas";
// Of the only window; null while there is none.
ui::KeyQueue* open_keys = nullptr;
std::vector<std::string>* open_drops = nullptr;

// A button of the browser as Dear ImGui numbers it.
int button_of(unsigned short browser_button) { return browser_button == 1 ? 2 : browser_button == 2 ? 1 : 0; }

const char* css_cursor(ImGuiMouseCursor cursor) {
    switch (cursor) {
        case ImGuiMouseCursor_TextInput:
            return "text";
        case ImGuiMouseCursor_ResizeAll:
            return "move";
        case ImGuiMouseCursor_ResizeNS:
            return "ns-resize";
        case ImGuiMouseCursor_ResizeEW:
            return "ew-resize";
        case ImGuiMouseCursor_ResizeNESW:
            return "nesw-resize";
        case ImGuiMouseCursor_ResizeNWSE:
            return "nwse-resize";
        case ImGuiMouseCursor_Hand:
            return "pointer";
        case ImGuiMouseCursor_NotAllowed:
            return "not-allowed";
        default:
            return "default";
    }
}

// Window pixels per pixel of the page: those of the display. A page smaller than the least window, as of a telephone,
// shows that window reduced. That of an upright telephone is narrower.
double density() {
    double width = 0, height = 0;
    emscripten_get_element_css_size(canvas, &width, &height);
    const double least_width = height > width ? 512 : 640, least_height = 480;
    const double enlarged = std::max({1.0, least_width / std::max(1.0, width), least_height / std::max(1.0, height)});
    return emscripten_get_device_pixel_ratio() * enlarged;
}

// True where a right click opens a menu: over the scene and over the wiring canvas.
bool right_click_opens_menu() {
    const ImGuiWindow* below = ImGui::GetCurrentContext()->HoveredWindow;
    return !ImGui::GetIO().WantCaptureMouse || (below && std::string_view(below->Name) == wiring::canvas_window);
}

Error no_graphics() {
    return {
        "this browser does not offer WebGL 2. Use a current Firefox, Chrome, Edge or Safari, or let it use "
        "hardware acceleration (in the browser's settings)"};
}

}  // namespace

struct Window::Native {
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;
    ui::KeyQueue keys;
    ui::MouseQueue mouse;
    std::vector<std::string> dropped;
    web::HeldKeys held;
    web::Touches touches;
    double last_frame = 0;  // ms
    float twist = 0;        // rad, since take_twist()
    // The last pointer was a finger: as the widgets know it, and by the last event. Their size stays until the finger
    // is lifted, so that what it has pressed stays below it.
    bool touched = is_for_fingers(), is_finger = touched;
    ui::TextKind wanted_text = ui::TextKind::none;
    ImGuiMouseCursor cursor = ImGuiMouseCursor_COUNT;
    std::string clipboard;
    std::optional<Canvas> redirected;  // drawn into in place of the page's
    bool imgui = false;

    Native() = default;
    Native(const Native&) = delete;
    Native& operator=(const Native&) = delete;
    ~Native() {
        open_keys = nullptr, open_drops = nullptr;
        if (imgui) ImGui_ImplOpenGL3_Shutdown(), ImGui::DestroyContext();
        if (context) emscripten_webgl_destroy_context(context);
    }

    static Native& of(void* user) {
        web::wake();
        return *static_cast<Native*>(user);
    }

    void fit_page() const;
    void place_pointer(double x, double y);
    void press_button(int button);
    void follow_fingers();
    void listen_to_mouse();
    void listen_to_keys();
    void listen_to_touch();
    void use_clipboard();
    void show_cursor();
};

// Makes the canvas as large as the page, in pixels of the display.
void Window::Native::fit_page() const {
    double width = 0, height = 0;
    emscripten_get_element_css_size(canvas, &width, &height);
    const double scale = density();
    const int w = std::max(1, static_cast<int>(std::lround(width * scale)));
    const int h = std::max(1, static_cast<int>(std::lround(height * scale)));
    int old_w = 0, old_h = 0;
    emscripten_get_canvas_element_size(canvas, &old_w, &old_h);
    if (w != old_w || h != old_h) emscripten_set_canvas_element_size(canvas, w, h);
}

// x, y: pixels of the page.
void Window::Native::place_pointer(double x, double y) {
    const double scale = density();
    mouse.move({static_cast<float>(x * scale), static_cast<float>(y * scale)});
}

void Window::Native::press_button(int button) { mouse.press(button, emscripten_get_now() / 1000, held.modifiers()); }

void Window::Native::follow_fingers() {
    if (const auto menu = touches.take_menu(emscripten_get_now(), right_click_opens_menu())) {
        place_pointer(menu->x, menu->y);
        press_button(1);
        mouse.release(1);
    }
    const auto touch = touches.take();
    if (!touch && !mouse.any_down() && mouse.shown_changes() == mouse.changes()) touched = is_finger;
    if (!touch) return;
    constexpr int left = 0, middle = 2;
    place_pointer(touch->x, touch->y);
    for (const auto& [button, fingers] : {std::pair(left, 1), std::pair(middle, 2)}) {
        const bool holds = touch->holds && touch->fingers == fingers;
        if (holds && !mouse.is_down(button)) press_button(button);
        if (!holds) mouse.release(button);
    }
    if (touch->notches != 0) mouse.turn_wheel({0, touch->notches});
    twist += touch->twist;
}

void Window::Native::listen_to_mouse() {
    const auto press = [](int, const EmscriptenMouseEvent* e, void* user) -> EM_BOOL {
        Native& self = of(user);
        self.is_finger = false;
        self.place_pointer(e->clientX, e->clientY);
        self.press_button(button_of(e->button));
        return EM_FALSE;  // the canvas gets the focus
    };
    const auto release = [](int, const EmscriptenMouseEvent* e, void* user) -> EM_BOOL {
        Native& self = of(user);
        self.place_pointer(e->clientX, e->clientY);
        self.mouse.release(button_of(e->button));
        return EM_FALSE;
    };
    const auto move = [](int, const EmscriptenMouseEvent* e, void* user) -> EM_BOOL {
        Native& self = of(user);
        self.place_pointer(e->clientX, e->clientY);
        if (e->buttons == 0) self.mouse.release_all();  // released outside the browser
        self.is_finger = false;
        return EM_FALSE;
    };
    const auto leave = [](int, const EmscriptenMouseEvent*, void* user) -> EM_BOOL {
        Native& self = of(user);
        if (!self.mouse.any_down()) self.mouse.leave();
        return EM_FALSE;
    };
    const auto turn_wheel = [](int, const EmscriptenWheelEvent* e, void* user) -> EM_BOOL {
        const double notch = e->deltaMode == DOM_DELTA_PIXEL ? 100 : e->deltaMode == DOM_DELTA_LINE ? 3 : 1;
        Native& self = of(user);
        self.mouse.turn_wheel({-static_cast<float>(e->deltaX / notch), -static_cast<float>(e->deltaY / notch)});
        return EM_TRUE;
    };
    emscripten_set_mousedown_callback(canvas, this, false, press);
    // Of the whole page: a drag goes on outside the canvas and outside the browser.
    emscripten_set_mouseup_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, false, release);
    emscripten_set_mousemove_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, false, move);
    emscripten_set_mouseleave_callback(canvas, this, false, leave);
    emscripten_set_wheel_callback(canvas, this, false, turn_wheel);
}

void Window::Native::listen_to_keys() {
    const auto press = [](int, const EmscriptenKeyboardEvent* e, void* user) -> EM_BOOL {
        Native& self = of(user);
        self.held.set(*e, true);
        constexpr unsigned of_input_method = 229;  // its characters come by braitenlab_type()
        if (e->keyCode == of_input_method || !web::is_for_lab(*e)) return EM_FALSE;
        if (const KeyPress key = web::press_of(*e); key.key != 0) self.keys.press(key, e->repeat, self.mouse.changes());
        if (const unsigned character = web::character_of(*e)) self.keys.type(character);
        return EM_TRUE;
    };
    const auto release = [](int, const EmscriptenKeyboardEvent* e, void* user) -> EM_BOOL {
        of(user).held.set(*e, false);
        return EM_FALSE;
    };
    const auto lose_focus = [](int, const EmscriptenFocusEvent*, void* user) -> EM_BOOL {
        Native& self = of(user);
        self.held = {};
        self.mouse.release_all();
        return EM_FALSE;
    };
    emscripten_set_keydown_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, false, press);
    emscripten_set_keyup_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, false, release);
    emscripten_set_blur_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, false, lose_focus);
}

void Window::Native::listen_to_touch() {
    const auto listen = [](int type, const EmscriptenTouchEvent* e, void* user) -> EM_BOOL {
        Native& self = of(user);
        self.touches.follow(type, *e);
        self.is_finger = true;
        return EM_TRUE;  // no mouse events for it
    };
    emscripten_set_touchstart_callback(canvas, this, false, listen);
    emscripten_set_touchmove_callback(canvas, this, false, listen);
    emscripten_set_touchend_callback(canvas, this, false, listen);
    emscripten_set_touchcancel_callback(canvas, this, false, listen);
}

void Window::Native::use_clipboard() {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = this;
    io.SetClipboardTextFn = [](void* user, const char* text) {
        static_cast<Native*>(user)->clipboard = text;
        copy_on_page(text);
    };
    io.GetClipboardTextFn = [](void* user) {
        auto& text = static_cast<Native*>(user)->clipboard;
        char* pasted = pasted_on_page();
        if (*pasted) text = pasted;
        std::free(pasted);
        return text.c_str();
    };
}

void Window::Native::show_cursor() {
    const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
    if (wanted != std::exchange(cursor, wanted)) set_page_cursor(css_cursor(wanted));
}

Window::Window(std::unique_ptr<Native> native) : native_(std::move(native)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

Result<Window> Window::open(const WindowOptions&) {
    auto native = std::make_unique<Native>();
    native->fit_page();
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.alpha = false;
    wanted.antialias = false;  // high quality has multisampling of its own (render/gl/resampling.h)
    wanted.powerPreference = EM_WEBGL_POWER_PREFERENCE_DEFAULT;
    native->context = emscripten_webgl_create_context(canvas, &wanted);
    if (native->context <= 0) return no_graphics();
    emscripten_webgl_make_context_current(native->context);

    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // no file of window positions
    io.BackendPlatformName = "web";
    io.ImeSetInputScreenPosFn = [](int x, int y) { place_text_on_page(x, y); };
    ui::expect_queued_input(io);
    ImGui_ImplOpenGL3_Init("#version 300 es");
    native->imgui = true;
    native->use_clipboard();
    native->listen_to_mouse();
    native->listen_to_keys();
    native->listen_to_touch();
    open_keys = &native->keys, open_drops = &native->dropped;
    return Window(std::move(native));
}

// The browser closes the page without a question; autosave keeps the work.
bool Window::close_requested() const { return false; }
void Window::refuse_close() {}
void Window::hide() {}

Rect Window::area() const {
    return {0, 0, static_cast<float>(framebuffer_width()), static_cast<float>(framebuffer_height())};
}

std::pair<int, int> Window::windowed_size() const { return {framebuffer_width(), framebuffer_height()}; }
std::optional<std::pair<int, int>> Window::windowed_place() const { return std::nullopt; }
std::vector<std::array<int, 4>> Window::displays() const { return {}; }
void Window::move_to(int, int) {}

int Window::framebuffer_width() const {
    if (native_->redirected) return native_->redirected->width;
    int width = 0, height = 0;
    emscripten_get_canvas_element_size(canvas, &width, &height);
    return width;
}

int Window::framebuffer_height() const {
    if (native_->redirected) return native_->redirected->height;
    int width = 0, height = 0;
    emscripten_get_canvas_element_size(canvas, &width, &height);
    return height;
}

float Window::content_scale() const { return std::max(1.0f, static_cast<float>(emscripten_get_device_pixel_ratio())); }

int Window::refresh_rate() const { return 0; }

// Events arrive between the turns.
void Window::poll(double patience) {
    native_->fit_page();
    if (patience > 0) web::put_off(patience);
}

void Window::rest(double) {}  // the browser begins the next turn at the rate of the display

ui::KeysOfAFrame Window::take_keys(ui::TextInput text) {
    return native_->keys.take(text, native_->mouse.shown_changes());
}
std::vector<std::string> Window::take_dropped_files() { return std::exchange(native_->dropped, {}); }
bool Window::is_touched() const { return native_->touched; }
float Window::finger() const { return static_cast<float>(std::ceil(44 * density())); }
float Window::take_twist() { return std::exchange(native_->twist, 0.0f); }
void Window::want_text(ui::TextKind wanted) {
    if (wanted == std::exchange(native_->wanted_text, wanted)) return;
    want_text_on_page(wanted != ui::TextKind::none, wanted == ui::TextKind::number);
}
bool Window::holds(int glfw_key) const { return native_->held.has(glfw_key); }

void Window::begin_frame(const ui::KeysOfAFrame& keys) {
    Native& self = *native_;
    ImGui_ImplOpenGL3_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(framebuffer_width()), static_cast<float>(framebuffer_height())};
    const double now = emscripten_get_now();
    io.DeltaTime = std::clamp(static_cast<float>((now - std::exchange(self.last_frame, now)) / 1000), 1e-4f, 0.25f);
    self.follow_fingers();
    const ui::MouseOfAFrame mouse = self.redirected ? self.mouse.outside() : self.mouse.take();
    ui::hand_over(mouse, io);
    ui::hand_over(keys, mouse.modifiers.value_or(self.held.modifiers()), io);
    self.show_cursor();
    ImGui::NewFrame();
    ui::hand_over_double_click(mouse, io);
}

void Window::draw_widgets() { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

bool Window::take_loss_of_picture() { return false; }  // the browser keeps it

void Window::fill(Colour) {}  // the page has a picture of its own until the first turn
void Window::show() {}        // the browser shows the canvas after the turn

void Window::upload_fonts() { upload_atlas(); }

void Window::toggle_full_screen() { toggle_full_page(); }

bool Window::watches_graphics() const { return false; }
int Window::graphics_errors() const { return 0; }

void Window::redirect(std::optional<Canvas> wanted) { native_->redirected = wanted; }
bool Window::is_redirected() const { return native_->redirected.has_value(); }

void Window::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, native_->redirected ? native_->redirected->framebuffer : 0);
    glViewport(0, 0, framebuffer_width(), framebuffer_height());
}

std::vector<unsigned char> Window::pixels() const {
    const auto width = static_cast<std::size_t>(framebuffer_width());
    const auto height = static_cast<std::size_t>(framebuffer_height());
    std::vector<unsigned char> rgba(width * height * 4), rgb;
    rgb.reserve(width * height * 3);
    glReadPixels(0, 0, framebuffer_width(), framebuffer_height(), GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    for (std::size_t y = height; y-- > 0;)
        for (std::size_t x = 0; x < width; ++x) {
            const auto from = rgba.begin() + static_cast<std::ptrdiff_t>((y * width + x) * 4);
            rgb.insert(rgb.end(), from, from + 3);
        }
    return rgb;
}

}  // namespace braitenlab

// Events that the page passes on.
extern "C" {

// Text is pasted: pasted_on_page() returns it.
EMSCRIPTEN_KEEPALIVE void braitenlab_paste() {
    braitenlab::web::wake();
    if (braitenlab::open_keys) braitenlab::open_keys->press({'V', true});
}

// A character is typed by an input method or a keyboard on the screen; 8: Backspace, 13: Enter.
EMSCRIPTEN_KEEPALIVE void braitenlab_type(unsigned character) {
    constexpr unsigned backspace = 8, enter = 13;
    braitenlab::web::wake();
    if (!braitenlab::open_keys) return;
    if (character == backspace || character == enter)
        braitenlab::open_keys->press({character == enter ? braitenlab::key::enter : braitenlab::key::backspace});
    else
        braitenlab::open_keys->type(character);
}

// A file is uploaded or dropped; the page has written it to this path.
EMSCRIPTEN_KEEPALIVE void braitenlab_open(const char* path) {
    braitenlab::web::wake();
    if (braitenlab::open_drops) braitenlab::open_drops->emplace_back(path);
}

}  // extern "C"
