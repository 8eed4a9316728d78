// One native window with an OpenGL 3.3 context and Dear ImGui in it. With render/, the only place that knows OpenGL.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/result.h"
#include "render/view/camera.h"
#include "ui/key_queue.h"

struct GLFWwindow;

namespace braitenlab {

struct WindowOptions {
    std::string title;
    int width = 1280, height = 800;
    bool full_screen = false;
    bool visible = true;
    bool watch_graphics = false;      // a context that checks every call, see graphics_errors()
    bool smooth_in_software = false;  // multisampling on a software renderer too, where it triples the cost of a frame
};

class Window {
public:
    // Fails with a sentence that says what is missing: a display, OpenGL 3.3, a driver.
    static Result<Window> open(const WindowOptions&);

    Window(Window&&) noexcept;
    Window& operator=(Window&&) noexcept;
    ~Window();

    // Somebody wants it closed; refuse_close() forgets that.
    bool close_requested() const;
    void refuse_close();

    // Window pixels; a display of high density may have more framebuffer pixels behind each.
    Rect area() const;
    // The size to come back to: that of the window, or what it had before full screen.
    std::pair<int, int> windowed_size() const;
    int framebuffer_width() const;
    int framebuffer_height() const;
    // What the display asks for, at least 1.
    float content_scale() const;

    // Takes what happened since the last call: what the keyboard did, in its order, and dropped files. Waits for
    // something to happen, but not longer than `patience` seconds; 0 does not wait.
    void poll(double patience);
    KeysOfAFrame take_keys(TextInput);
    std::vector<std::string> take_dropped_files();

    // Whether a key is held now.
    bool holds(int glfw_key) const;

    // Dear ImGui's frame, which hears these keys; the font atlas must be filled before the first and may be refilled
    // between frames.
    void begin_frame(const KeysOfAFrame&);
    void end_frame();     // draws Dear ImGui's lists over what has been drawn
    void show();          // swaps the buffers
    void forget_fonts();  // after the atlas was refilled

    void toggle_full_screen();

    // Whether the driver checks every call: asked for, and able to.
    bool watches_graphics() const;

    // What the driver has called an error so far; always 0 unless it was asked to watch. Each has gone to stderr.
    int graphics_errors() const;

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
