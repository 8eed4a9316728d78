// One native window with an OpenGL 3.3 context and Dear ImGui. Only this class and render/gl use OpenGL.
// app/window.cpp is the window of a desktop, app/platform/web_window.cpp the canvas of a browser.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "render/view/camera.h"
#include "render/view/palette.h"
#include "ui/key_queue.h"

struct GLFWwindow;

namespace braitenlab {

struct WindowOptions {
    std::string title;
    int width = 1280, height = 800;
    bool fits_display = false;  // is made smaller where no display has this size
    bool full_screen = false;
    bool visible = true;
    bool watch_graphics = false;  // the driver checks every call, see graphics_errors()
};

class Window {
public:
    // Fails with what is missing: a display, OpenGL 3.3, a driver.
    static Result<Window> open(const WindowOptions&);

    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;
    ~Window();

    // True once the user has closed the window; refuse_close() resets it.
    bool close_requested() const;
    void refuse_close();
    // Takes the window from the screen at once, for work at the end of the program: no further frame is shown.
    // windowed_size() and windowed_place() stay as they were.
    void hide();

    // Window pixels, which are those of the framebuffer. Some systems (Wayland, browsers) place windows and pointers in
    // units of several pixels; only this class knows them.
    Rect area() const;
    // The size of the window in the system's units; in full screen, the size before it.
    std::pair<int, int> windowed_size() const;
    // The position of its upper left corner on the desktop, in these units; in full screen, before it. nullopt if the
    // system does not tell it.
    std::optional<std::pair<int, int>> windowed_place() const;
    // x, y, width and height of the free area of each display.
    std::vector<std::array<int, 4>> displays() const;
    void move_to(int x, int y);
    int framebuffer_width() const;
    int framebuffer_height() const;
    // The scale that the display is set to, at least 1.
    float content_scale() const;
    // Pictures per second of the fastest display; 0 if unknown.
    int refresh_rate() const;

    // Collects events: keys in their order, dropped files. Waits up to `patience` seconds for the first event or a
    // request to end.
    // A browser delivers events between turns: there poll() returns at once and puts the next turn off instead.
    void poll(double patience);
    // Collects events for `seconds`. Returns at once in a browser, which begins turns at the rate of the display.
    void rest(double seconds);
    ui::KeysOfAFrame take_keys(ui::TextInput);
    std::vector<std::string> take_dropped_files();

    // True while the last pointer was a finger; in a browser only.
    bool is_touched() const;
    // The height that a finger needs, window pixels: 44 pixels of the page. 0 where there is no page.
    float finger() const;
    // The angle by which two fingers have turned since the last call, rad, counter-clockwise.
    float take_twist();
    // Tells the browser whether characters are typed, for its keyboard on the screen and its input methods.
    void want_text(ui::TextKind);

    // True while the key is held.
    bool holds(int glfw_key) const;

    // Begins Dear ImGui's frame with these keys. Precondition: the font atlas is filled.
    void begin_frame(const ui::KeysOfAFrame&);
    void draw_widgets();  // draws Dear ImGui's lists over the scene
    void fill(Colour);    // where no scene is drawn
    void show();          // swaps the buffers
    void upload_fonts();  // call after the font atlas has been filled again
    // True if the system has lost the picture since the last call, for example because the window was covered.
    bool take_loss_of_picture();

    void toggle_full_screen();

    // True if the driver checks every call: requested and supported.
    bool watches_graphics() const;

    // Number of errors that the driver has reported so far; each is printed to stderr. 0 without watch_graphics.
    int graphics_errors() const;

    // From the next frame on the window draws into this framebuffer: area(), framebuffer_width() and
    // framebuffer_height() are those of it, and the pointer is outside. nullopt: into its own one again.
    struct Canvas {
        unsigned framebuffer = 0;
        int width = 0, height = 0;  // px
    };
    void redirect(std::optional<Canvas>);
    bool is_redirected() const;

    // Binds the window's framebuffer, sized to it.
    void bind() const;

    // The framebuffer as RGB bytes, rows from the top.
    std::vector<unsigned char> pixels() const;

private:
    struct Native;
    explicit Window(std::unique_ptr<Native>);
    std::unique_ptr<Native> native_;
};

}  // namespace braitenlab
