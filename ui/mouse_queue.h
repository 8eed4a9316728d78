// Queue of mouse events between the callbacks of the window and frames. Dear ImGui 1.86 has no such queue: it judges a
// press at the position of the pointer in the next frame, so a click is lost if the pointer moves on within that frame,
// and it misses what happens between two frames. Therefore each frame gets at most one change of a button, at the
// position of that change; movements between two changes are merged.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>

#include "core/maths/vec.h"
#include "ui/double_click.h"
#include "ui/key_queue.h"

namespace braitenlab::ui {

// The mouse in one frame. Buttons have Dear ImGui's numbers: left, right, middle.
struct MouseOfAFrame {
    std::optional<maths::vec2> at;  // window pixels; nullopt: outside the window
    std::array<bool, 3> down{};
    maths::vec2 wheel;                   // notches; y: away from the user
    bool double_clicked = false;         // the left button completes a double click in this frame
    std::optional<Modifiers> modifiers;  // at a press of this frame
};

class MouseQueue {
public:
    // Window pixels. Call before press() and release() with the position of these.
    void move(maths::vec2 at);
    void leave();
    void press(int button, double seconds, Modifiers);
    void release(int button);
    void release_all();
    void turn_wheel(maths::vec2 notches);

    // True while the button is down after all events so far, also those that no frame has got yet.
    bool is_down(int button) const { return newest_.down[static_cast<std::size_t>(button)]; }
    bool any_down() const;

    // Presses and releases so far; those of them that take() has returned.
    std::uint64_t changes() const { return changes_; }
    std::uint64_t shown_changes() const { return shown_changes_; }

    // Removes and returns the events for one frame, in order. A press is in the frame of its position and the movement
    // before it, its release in a later frame. A movement with a button down has a frame before the release, so that a
    // quick drag is a drag. Without events: the mouse as it was, its wheel at rest. Call once per frame.
    MouseOfAFrame take();

    // The buttons of the last frame with the pointer outside the window, for a frame that is drawn into a picture.
    MouseOfAFrame outside() const;

private:
    enum class Kind { move, button, wheel };
    // `mouse`: as it is after the event; `wheel`, `double_clicked` and `modifiers` are those of the event.
    struct Event {
        Kind kind = Kind::move;
        MouseOfAFrame mouse;
    };
    void add(Kind, const MouseOfAFrame&);

    std::deque<Event> events_;
    MouseOfAFrame newest_, shown_;  // after the last event; in the last frame
    std::uint64_t changes_ = 0, shown_changes_ = 0;
    DoubleClick clicks_;
};

// Passes the mouse to Dear ImGui; call before its frame begins, and hand_over_double_click() after it has begun.
void hand_over(const MouseOfAFrame&, ImGuiIO&);
void hand_over_double_click(const MouseOfAFrame&, ImGuiIO&);

}  // namespace braitenlab::ui
