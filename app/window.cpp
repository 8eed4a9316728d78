#include "app/window.h"

#include <algorithm>
#include <iostream>

#include <GL/glew.h>
#include <fmt/format.h>
// GLFW after GLEW: both declare OpenGL, and GLEW must be included first.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "app/imgui_opengl.h"
#include "app/platform/platform.h"
#include "core/maths/vec.h"
#include "ui/mouse_queue.h"

namespace braitenlab {

using namespace std::string_view_literals;

namespace {

constexpr int least_width = 780, least_height = 560;  // window pixels; the toolbar and the cards need them
constexpr int smooth_samples = 4;                     // of multisampling
constexpr const char* program_id = "org.braitenlab.braitenlab";

// GLFW reports errors by callback only. The last one explains a failed call.
std::string last_error;

Error no_window() {
    return {
        fmt::format("no window could be opened ({}). A display is needed (on a server: install xvfb and run "
                    "'xvfb-run braitenlab'), with OpenGL 3.3 (install libgl1-mesa-dri for a software renderer)",
                    last_error.empty() ? "no reason given" : last_error)};
}

maths::vec2 vec2_of(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

// The pointer's position in the system's units in pixels of the framebuffer.
maths::vec2 pixels_of(GLFWwindow* window, double x, double y) {
    int width = 1, height = 1, across = 1, down = 1;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &across, &down);
    return vec2_of(x * across / std::max(1, width), y * down / std::max(1, height));
}

// What keys of the numeric keypad are while they type no digits.
struct KeypadKey {
    int keypad, key;
};
constexpr KeypadKey keypad_keys[]{{GLFW_KEY_KP_0, key::insert},  {GLFW_KEY_KP_1, key::end},
                                  {GLFW_KEY_KP_2, key::down},    {GLFW_KEY_KP_3, key::page_down},
                                  {GLFW_KEY_KP_4, key::left},    {GLFW_KEY_KP_6, key::right},
                                  {GLFW_KEY_KP_7, key::home},    {GLFW_KEY_KP_8, key::up},
                                  {GLFW_KEY_KP_9, key::page_up}, {GLFW_KEY_KP_DECIMAL, key::del}};

bool is_on_keypad(int glfw_key) { return glfw_key >= GLFW_KEY_KP_0 && glfw_key <= GLFW_KEY_KP_EQUAL; }

// 0 for 5 without digits.
int key_of_keypad(int glfw_key, bool types_digits) {
    constexpr std::string_view signs = "./*-+\0="sv;
    static_assert(GLFW_KEY_KP_EQUAL - GLFW_KEY_KP_DECIMAL == 6 && GLFW_KEY_KP_ADD - GLFW_KEY_KP_DECIMAL == 4);
    if (glfw_key == GLFW_KEY_KP_ENTER) return key::enter;
    if (!types_digits && glfw_key <= GLFW_KEY_KP_DECIMAL) {
        for (const KeypadKey& each : keypad_keys)
            if (each.keypad == glfw_key) return each.key;
        return 0;
    }
    if (glfw_key <= GLFW_KEY_KP_9) return '0' + glfw_key - GLFW_KEY_KP_0;
    return signs[static_cast<std::size_t>(glfw_key - GLFW_KEY_KP_DECIMAL)];
}

// The digit at its place, else the character a key types on this keyboard layout without Shift, in upper case; other
// keys by GLFW's number.
int key_of(int glfw_key, int scancode) {
    if (glfw_key == GLFW_KEY_SPACE) return ' ';
    if (glfw_key >= GLFW_KEY_0 && glfw_key <= GLFW_KEY_9) return glfw_key;
    if (const char* name = glfwGetKeyName(glfw_key, scancode); name && name[0] != 0 && name[1] == 0)
        return name[0] >= 'a' && name[0] <= 'z' ? name[0] - 'a' + 'A' : name[0];
    return glfw_key;
}

}  // namespace

struct Window::Native {
    GLFWwindow* window = nullptr;
    ui::KeyQueue keys;
    ui::MouseQueue mouse;
    std::vector<std::string> dropped;
    int windowed[4] = {0, 0, 0, 0};  // position and size before full screen
    // Position of the window when Alt was pressed; nullopt: it is not held, or another key has been pressed since.
    std::optional<std::array<int, 2>> alt_pressed_at;
    std::optional<Canvas> canvas;  // drawn into in place of the window
    struct Placed {
        std::pair<int, int> size;
        std::optional<std::pair<int, int>> place;
    };
    std::optional<Placed> hidden;  // where it was: window managers move a window that is hidden
    bool imgui = false;
    bool watches_graphics = false;
    bool num_lock = false;      // at the last key
    bool picture_lost = false;  // see take_loss_of_picture()
    int graphics_errors = 0;

    Native() = default;
    Native(const Native&) = delete;
    Native& operator=(const Native&) = delete;
    ~Native() {
        if (imgui) {
            ImGui_ImplOpenGL3_Shutdown();
            ImGui_ImplGlfw_Shutdown();
            ImGui::DestroyContext();
        }
        if (window) glfwDestroyWindow(window);
        glfwTerminate();
    }

    static Native& of(GLFWwindow* w) { return *static_cast<Native*>(glfwGetWindowUserPointer(w)); }

    // Alt counts when it is released without another key since its press, and the window has kept focus and position:
    // Alt+Tab and Alt with a drag are of the window manager. GLFW releases all keys of a window that loses the focus.
    void follow_alt(int key, int action) {
        if (key != GLFW_KEY_LEFT_ALT) return alt_pressed_at.reset();
        std::array<int, 2> at{};
        glfwGetWindowPos(window, &at[0], &at[1]);
        if (action == GLFW_PRESS) alt_pressed_at = at;
        if (action != GLFW_RELEASE) return;
        if (std::exchange(alt_pressed_at, {}) == at && glfwGetWindowAttrib(window, GLFW_FOCUSED))
            keys.press({braitenlab::key::alt}, false);
    }

    void install_mouse_callbacks() {
        glfwSetCursorPosCallback(window,
                                 [](GLFWwindow* w, double x, double y) { of(w).mouse.move(pixels_of(w, x, y)); });
        glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
            if (!entered && !of(w).mouse.any_down()) of(w).mouse.leave();
        });
        glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) { of(w).mouse.turn_wheel(vec2_of(x, y)); });
        glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
            if (button < GLFW_MOUSE_BUTTON_LEFT || button > GLFW_MOUSE_BUTTON_MIDDLE) return;
            ui::MouseQueue& queue = of(w).mouse;
            if (action == GLFW_PRESS) {
                return queue.press(
                    button, glfwGetTime(),
                    {(mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_ALT) != 0});
            }
            queue.release(button);
            // A drag that ended outside: the pointer has left the window during it.
            if (!queue.any_down() && !glfwGetWindowAttrib(w, GLFW_HOVERED)) queue.leave();
        });
        glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).picture_lost = true; });
        // The window moves under a pointer at rest: the pointer's position in it changes without an event.
        glfwSetWindowPosCallback(window, [](GLFWwindow* w, int, int) {
            double x = 0, y = 0;
            glfwGetCursorPos(w, &x, &y);
            if (glfwGetWindowAttrib(w, GLFW_HOVERED)) of(w).mouse.move(pixels_of(w, x, y));
        });
    }

    void install_key_callbacks() {
        glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
            of(w).follow_alt(key, action);
            if (key == GLFW_KEY_LEFT_ALT) return;
            if (action == GLFW_RELEASE || key == GLFW_KEY_UNKNOWN) return;
            const bool ctrl = (mods & GLFW_MOD_CONTROL) != 0, shift = (mods & GLFW_MOD_SHIFT) != 0;
            of(w).num_lock = (mods & GLFW_MOD_NUM_LOCK) != 0;
            if (is_on_keypad(key)) {
                // Shift has the effect of the lock and no other one.
                const KeyPress press{key_of_keypad(key, of(w).num_lock != shift), ctrl, false};
                if (press.key != 0) of(w).keys.press(press, action == GLFW_REPEAT, of(w).mouse.changes());
                return;
            }
            of(w).keys.press({key_of(key, scancode), ctrl, shift}, action == GLFW_REPEAT, of(w).mouse.changes());
        });
        glfwSetInputMode(window, GLFW_LOCK_KEY_MODS, GLFW_TRUE);
        glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) { of(w).keys.type(character); });
        // The other callback gets no character while Ctrl is held, and + is a shifted digit on some layouts.
        glfwSetCharModsCallback(window, [](GLFWwindow* w, unsigned character, int mods) {
            const bool only_ctrl = (mods & GLFW_MOD_CONTROL) != 0 && (mods & GLFW_MOD_ALT) == 0;
            if (only_ctrl) of(w).keys.type_with_ctrl(character);
        });
    }
};

namespace {

void hint_context(const WindowOptions& options, int samples) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SAMPLES, samples);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.watch_graphics ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
    // The desktop finds name and icon by them in the .desktop file of this name.
    glfwWindowHintString(GLFW_X11_CLASS_NAME, program_id);
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, program_id);
#ifdef GLFW_WAYLAND_APP_ID  // from GLFW 3.4 on
    glfwWindowHintString(GLFW_WAYLAND_APP_ID, program_id);
#endif
}

// The size, or as much of it as a display has, whichever has the most.
std::pair<int, int> size_on_display(int width, int height) {
    int count = 0, widest = 0, highest = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        int area[4]{};
        glfwGetMonitorWorkarea(monitors[i], &area[0], &area[1], &area[2], &area[3]);
        widest = std::max(widest, std::min(width, area[2])), highest = std::max(highest, std::min(height, area[3]));
    }
    return {widest > 0 ? widest : width, highest > 0 ? highest : height};
}

GLFWwindow* make_window(const WindowOptions& options, int samples) {
    hint_context(options, samples);
    GLFWmonitor* monitor = options.full_screen ? glfwGetPrimaryMonitor() : nullptr;
    auto [width, height] = options.fits_display ? size_on_display(options.width, options.height)
                                                : std::pair(options.width, options.height);
    if (monitor)
        if (const GLFWvidmode* mode = glfwGetVideoMode(monitor)) width = mode->width, height = mode->height;
    GLFWwindow* window = glfwCreateWindow(width, height, options.title.c_str(), monitor, nullptr);
    if (window) glfwMakeContextCurrent(window);
    return window;
}

bool renders_in_software() {
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const std::string_view renderer = name ? name : "";
    return renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos;
}

// With multisampling, unless the context does not support it or the renderer is software: it would become too slow, and
// high quality has multisampling of its own (render/gl/resampling.h).
GLFWwindow* make_best_window(const WindowOptions& options) {
    WindowOptions first = options;
    first.visible = false;  // a window that is replaced at once does not flash
    GLFWwindow* window = make_window(first, smooth_samples);
    if (window && !renders_in_software()) {
        if (options.visible) glfwShowWindow(window);
        return window;
    }
    if (window) glfwDestroyWindow(window);
    return make_window(options, 0);
}

// Counts errors of the API only: errors in shaders are returned as an Error.
bool count_errors(int& count) {
    if (!GLEW_KHR_debug) return false;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(
        [](GLenum source, GLenum type, GLuint, GLenum, GLsizei, const GLchar* text, const void* counter) {
            if (source != GL_DEBUG_SOURCE_API || type != GL_DEBUG_TYPE_ERROR) return;
            ++*static_cast<int*>(const_cast<void*>(counter));
            std::cerr << "braitenlab: the graphics driver says: " << text << "\n";
        },
        &count);
    return true;
}

std::optional<Error> load_opengl() {
    glewExperimental = GL_TRUE;
    const GLenum code = glewInit();
    // Under Wayland GLEW reports that there is no GLX display, although it has loaded all functions.
    if (code != GLEW_OK && code != GLEW_ERROR_NO_GLX_DISPLAY)
        return Error{fmt::format("OpenGL's functions could not be loaded ({})",
                                 reinterpret_cast<const char*>(glewGetErrorString(code)))};
    while (glGetError() != GL_NO_ERROR) {
    }  // GLEW may leave a GL error
    if (!GLEW_VERSION_3_3)
        return Error{
            fmt::format("OpenGL 3.3 is needed, this machine offers {}; update the graphics driver or install "
                        "libgl1-mesa-dri for a software renderer",
                        reinterpret_cast<const char*>(glGetString(GL_VERSION)))};
    return std::nullopt;
}

}  // namespace

Window::Window(std::unique_ptr<Native> native) : native_(std::move(native)) {}
Window::Window(Window&&) noexcept = default;
Window& Window::operator=(Window&&) noexcept = default;
Window::~Window() = default;

Result<Window> Window::open(const WindowOptions& options) {
    glfwSetErrorCallback([](int, const char* text) { last_error = text; });
    if (!glfwInit()) return no_window();
    auto native = std::make_unique<Native>();
    native->window = make_best_window(options);
    if (!native->window) return no_window();
    GLFWwindow* window = native->window;
    glfwSetWindowUserPointer(window, native.get());
    if (const auto error = load_opengl()) return *error;
    if (options.watch_graphics) native->watches_graphics = count_errors(native->graphics_errors);
    glfwSwapInterval(1);
    glfwSetWindowSizeLimits(window, least_width, least_height, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glEnable(GL_MULTISAMPLE);

    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        auto& dropped = Native::of(w).dropped;
        dropped.insert(dropped.end(), paths, paths + count);
    });

    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;         // no file of window positions
    ImGui_ImplGlfw_InitForOpenGL(window, false);  // without its callbacks: input comes from KeyQueue and MouseQueue
    ui::expect_queued_input(ImGui::GetIO());
    ImGui_ImplOpenGL3_Init("#version 330 core");
    native->imgui = true;
    native->install_key_callbacks();
    native->install_mouse_callbacks();
    return Window(std::move(native));
}

bool Window::close_requested() const { return glfwWindowShouldClose(native_->window); }
void Window::refuse_close() { glfwSetWindowShouldClose(native_->window, GLFW_FALSE); }

void Window::hide() {
    native_->hidden = Native::Placed{windowed_size(), windowed_place()};
    if (glfwGetWindowMonitor(native_->window)) toggle_full_screen();  // GLFW hides no window in full screen
    glfwHideWindow(native_->window);
}

Rect Window::area() const {
    return {0, 0, static_cast<float>(framebuffer_width()), static_cast<float>(framebuffer_height())};
}

std::pair<int, int> Window::windowed_size() const {
    if (native_->hidden) return native_->hidden->size;
    int width = 0, height = 0;
    glfwGetWindowSize(native_->window, &width, &height);
    if (glfwGetWindowMonitor(native_->window)) return {native_->windowed[2], native_->windowed[3]};
    return {width, height};
}

std::optional<std::pair<int, int>> Window::windowed_place() const {
    if (native_->hidden) return native_->hidden->place;
    if (glfwGetWindowMonitor(native_->window)) return std::pair(native_->windowed[0], native_->windowed[1]);
    if (glfwGetWindowAttrib(native_->window, GLFW_ICONIFIED)) return std::nullopt;
    int x = 0, y = 0;
    glfwGetError(nullptr);
    glfwGetWindowPos(native_->window, &x, &y);
    if (glfwGetError(nullptr) != GLFW_NO_ERROR) return std::nullopt;  // Wayland
    return std::pair(x, y);
}

std::vector<std::array<int, 4>> Window::displays() const {
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    std::vector<std::array<int, 4>> areas(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        auto& area = areas[static_cast<std::size_t>(i)];
        glfwGetMonitorWorkarea(monitors[i], &area[0], &area[1], &area[2], &area[3]);
    }
    return areas;
}

void Window::move_to(int x, int y) { glfwSetWindowPos(native_->window, x, y); }

int Window::framebuffer_width() const {
    if (native_->canvas) return native_->canvas->width;
    int width = 0, height = 0;
    glfwGetFramebufferSize(native_->window, &width, &height);
    return width;
}

int Window::framebuffer_height() const {
    if (native_->canvas) return native_->canvas->height;
    int width = 0, height = 0;
    glfwGetFramebufferSize(native_->window, &width, &height);
    return height;
}

float Window::content_scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(native_->window, &x, &y);
    return std::max({1.0f, x, y});
}

int Window::refresh_rate() const {
    int count = 0, fastest = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i)
        if (const GLFWvidmode* mode = glfwGetVideoMode(monitors[i])) fastest = std::max(fastest, mode->refreshRate);
    return fastest;
}

void Window::poll(double patience) {
    if (patience <= 0) return glfwPollEvents();
    constexpr double slice = 0.05;  // s: GLFW goes on waiting when a signal comes
    const double until = glfwGetTime() + patience;
    for (double began = glfwGetTime(); began < until && !is_told_to_end(); began = glfwGetTime()) {
        glfwWaitEventsTimeout(std::min(until - began, slice));
        if (glfwGetTime() - began < 0.9 * slice) return;  // an event
    }
}

void Window::rest(double seconds) {
    const double until = glfwGetTime() + seconds;
    for (double left = 0; (left = until - glfwGetTime()) > 0;) poll(left);
}

ui::KeysOfAFrame Window::take_keys(ui::TextInput text) {
    return native_->keys.take(text, native_->mouse.shown_changes());
}
std::vector<std::string> Window::take_dropped_files() { return std::exchange(native_->dropped, {}); }

bool Window::is_touched() const { return false; }
float Window::finger() const { return 0; }
float Window::take_twist() { return 0; }
void Window::want_text(ui::TextKind) {}
bool Window::holds(int glfw_key) const {
    const auto is_down = [this](int each) { return glfwGetKey(native_->window, each) == GLFW_PRESS; };
    if (is_down(glfw_key)) return true;
    return !native_->num_lock &&
           std::any_of(std::begin(keypad_keys), std::end(keypad_keys),
                       [&](const KeypadKey& each) { return each.key == glfw_key && is_down(each.keypad); });
}

void Window::begin_frame(const ui::KeysOfAFrame& keys) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {area().w, area().h};
    io.DisplayFramebufferScale = {1, 1};
    const ui::MouseOfAFrame mouse = native_->canvas ? native_->mouse.outside() : native_->mouse.take();
    ui::hand_over(mouse, io);
    const auto either = [this](int left, int right) { return holds(left) || holds(right); };
    const ui::Modifiers held{either(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
                             either(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                             either(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)};
    ui::hand_over(keys, mouse.modifiers.value_or(held), io);
    ImGui::NewFrame();
    ui::hand_over_double_click(mouse, io);
}

void Window::fill(Colour colour) {
    bind();
    glDisable(GL_SCISSOR_TEST);
    glClearColor(colour.r, colour.g, colour.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Window::draw_widgets() { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

bool Window::take_loss_of_picture() { return std::exchange(native_->picture_lost, false); }

void Window::show() { glfwSwapBuffers(native_->window); }

void Window::upload_fonts() { upload_atlas(); }

void Window::toggle_full_screen() {
    GLFWwindow* window = native_->window;
    int* w = native_->windowed;
    if (glfwGetWindowMonitor(window)) {
        glfwSetWindowMonitor(window, nullptr, w[0], w[1], std::max(w[2], 640), std::max(w[3], 480), 0);
        return;
    }
    glfwGetWindowPos(window, &w[0], &w[1]);
    glfwGetWindowSize(window, &w[2], &w[3]);
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (mode) glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

bool Window::watches_graphics() const { return native_->watches_graphics; }
int Window::graphics_errors() const { return native_->graphics_errors; }

void Window::redirect(std::optional<Canvas> canvas) { native_->canvas = canvas; }

bool Window::is_redirected() const { return native_->canvas.has_value(); }

void Window::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, native_->canvas ? native_->canvas->framebuffer : 0);
    glViewport(0, 0, framebuffer_width(), framebuffer_height());
}

std::vector<unsigned char> Window::pixels() const {
    const int width = framebuffer_width(), height = framebuffer_height();
    const auto row = static_cast<std::size_t>(width) * 3;
    std::vector<unsigned char> bottom_up(row * static_cast<std::size_t>(height)), top_down(bottom_up.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, bottom_up.data());
    for (int y = 0; y < height; ++y) {
        const auto from = bottom_up.begin() + static_cast<std::ptrdiff_t>(row) * (height - 1 - y);
        std::copy(from, from + static_cast<std::ptrdiff_t>(row),
                  top_down.begin() + static_cast<std::ptrdiff_t>(row) * y);
    }
    return top_down;
}

}  // namespace braitenlab
