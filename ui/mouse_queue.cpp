#include "ui/mouse_queue.h"

#include <algorithm>
#include <cfloat>

#include "ui/imgui_compat.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float wheel_reach = 8;  // px by which the pointer may move in the frame of a turn of the wheel

bool has_button_down(const MouseOfAFrame& mouse) {
    return std::any_of(mouse.down.begin(), mouse.down.end(), [](bool down) { return down; });
}

// Without what happens in one frame only.
MouseOfAFrame at_rest(MouseOfAFrame mouse) {
    mouse.wheel = {}, mouse.double_clicked = false, mouse.modifiers.reset();
    return mouse;
}

bool is_near(const MouseOfAFrame& a, const MouseOfAFrame& b) {
    return a.at && b.at && maths::length(*a.at - *b.at) <= wheel_reach;
}

}  // namespace

void MouseQueue::add(Kind kind, const MouseOfAFrame& mouse) {
    newest_ = at_rest(mouse);
    changes_ += kind == Kind::button ? 1 : 0;
    const bool merges = kind == Kind::move && !events_.empty() && events_.back().kind == Kind::move;
    if (merges) events_.pop_back();
    events_.push_back({kind, mouse});
}

void MouseQueue::move(vec2 at) {
    MouseOfAFrame mouse = newest_;
    mouse.at = at;
    add(Kind::move, mouse);
}

void MouseQueue::leave() {
    MouseOfAFrame mouse = newest_;
    mouse.at.reset();
    add(Kind::move, mouse);
}

void MouseQueue::press(int button, double seconds, Modifiers modifiers) {
    MouseOfAFrame mouse = newest_;
    mouse.down[static_cast<std::size_t>(button)] = true;
    mouse.modifiers = modifiers;
    const vec2 at = mouse.at.value_or(vec2{});
    mouse.double_clicked = button == 0 && clicks_.press(seconds, at.x, at.y);
    add(Kind::button, mouse);
}

void MouseQueue::release(int button) {
    if (!is_down(button)) return;
    MouseOfAFrame mouse = newest_;
    mouse.down[static_cast<std::size_t>(button)] = false;
    add(Kind::button, mouse);
}

void MouseQueue::release_all() {
    for (int button = 0; button < static_cast<int>(newest_.down.size()); ++button) release(button);
}

void MouseQueue::turn_wheel(vec2 notches) {
    MouseOfAFrame mouse = newest_;
    mouse.wheel = notches;
    add(Kind::wheel, mouse);
}

bool MouseQueue::any_down() const { return has_button_down(newest_); }

MouseOfAFrame MouseQueue::take() {
    MouseOfAFrame frame = at_rest(shown_);
    bool drags = false, changes = false, turns = false;
    for (; !events_.empty(); events_.pop_front()) {
        const auto& [kind, mouse] = events_.front();
        if (changes) break;
        if (kind == Kind::button && (drags || turns)) break;
        if (kind == Kind::move && turns && !is_near(frame, mouse)) break;
        drags |= kind == Kind::move && has_button_down(mouse);
        changes |= kind == Kind::button;
        shown_changes_ += kind == Kind::button ? 1 : 0;
        turns |= kind == Kind::wheel;
        const vec2 wheel = frame.wheel + mouse.wheel;
        frame = mouse;
        frame.wheel = wheel;
    }
    return shown_ = frame;
}

MouseOfAFrame MouseQueue::outside() const {
    MouseOfAFrame mouse = at_rest(shown_);
    mouse.at.reset();
    return mouse;
}

void hand_over(const MouseOfAFrame& mouse, ImGuiIO& io) {
    const ImVec2 at = mouse.at ? ImVec2(mouse.at->x, mouse.at->y) : ImVec2(-FLT_MAX, -FLT_MAX);
    compat::set_mouse(io, at, mouse.down, {mouse.wheel.x, mouse.wheel.y});
}

void hand_over_double_click(const MouseOfAFrame& mouse, ImGuiIO& io) {
    if (mouse.double_clicked) io.MouseDoubleClicked[0] = true, io.MouseClickedCount[0] = 2;
}

}  // namespace braitenlab::ui
