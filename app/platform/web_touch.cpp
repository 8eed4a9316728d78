#include "app/platform/web_touch.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <emscripten/emscripten.h>
#include <emscripten/html5.h>

namespace braitenlab::web {

namespace {

constexpr double notches_per_doubling = 4;  // of the distance of two fingers
constexpr double rest_ms = 500, second_tap_ms = 350;
constexpr double tap_reach = 10, second_tap_reach = 30;  // pixels of the page

}  // namespace

void Touches::follow(int type, const EmscriptenTouchEvent& e) {
    Touch now;
    double x[2] = {}, y[2] = {};
    for (int i = 0; i < e.numTouches; ++i) {
        const EmscriptenTouchPoint& point = e.touches[i];
        const bool is_lifted =
            point.isChanged && (type == EMSCRIPTEN_EVENT_TOUCHEND || type == EMSCRIPTEN_EVENT_TOUCHCANCEL);
        if (is_lifted || now.fingers == 2) continue;
        x[now.fingers] = point.clientX, y[now.fingers] = point.clientY;
        ++now.fingers;
    }
    const double time = emscripten_get_now();
    if (now.fingers == 1 && last_.fingers == 0 && !is_over_) begin_tap({x[0], y[0]}, time);
    if (now.fingers == 2 || (tap_ && now.fingers == 1 && std::hypot(x[0] - tap_->x, y[0] - tap_->y) > tap_reach))
        tap_.reset();
    if (now.fingers == 0) {
        end_tap(time);
        if (last_.fingers > 0) lift();
        is_over_ = false;
        return;
    }
    if (now.fingers == 1 && (is_over_ || last_.fingers == 2)) {
        if (!is_over_) lift();
        is_over_ = true;
        return;
    }
    is_over_ = false;
    if (now.fingers == 2 && last_.fingers == 1) lift();
    now.x = now.fingers == 2 ? (x[0] + x[1]) / 2 : x[0];
    now.y = now.fingers == 2 ? (y[0] + y[1]) / 2 : y[0];
    const double distance = now.fingers == 2 ? std::hypot(x[0] - x[1], y[0] - y[1]) : 0;
    const double angle = now.fingers == 2 ? std::atan2(y[0] - y[1], x[1] - x[0]) : 0;  // y is down
    if (now.fingers != last_.fingers) {
        Touch hover = now;
        steps_.push_back(hover);
        now.presses = now.fingers == 1;
    } else if (distance > 0 && distance_ > 0) {
        now.notches = static_cast<float>(notches_per_doubling * std::log2(distance / distance_));
        now.twist = static_cast<float>(std::remainder(angle - angle_, 2 * std::numbers::pi));
    }
    now.holds = true;
    distance_ = distance, angle_ = angle;
    // Moves within a frame are one.
    const bool moves = !steps_.empty() && !now.presses && steps_.back().holds && !steps_.back().presses;
    if (moves && steps_.back().fingers == now.fingers) {
        Touch& step = steps_.back();
        step.x = now.x, step.y = now.y, step.notches += now.notches, step.twist += now.twist;
    } else {
        steps_.push_back(now);
    }
    last_ = now;
    last_.presses = false;
}

void Touches::lift() {
    Touch end = last_;
    end.holds = end.presses = false, end.notches = end.twist = 0;
    steps_.push_back(end);
    last_ = {};
}

void Touches::begin_tap(Place at, double now) {
    tap_ = at;
    tapped_at_ = now;
}

void Touches::end_tap(double now) {
    if (!tap_ || now - tapped_at_ >= rest_ms) return tap_.reset();
    const bool is_second = tapped_at_ - last_tapped_at_ < second_tap_ms &&
                           std::hypot(tap_->x - last_tap_.x, tap_->y - last_tap_.y) < second_tap_reach;
    if (is_second) menu_ = tap_;
    last_tap_ = *tap_;
    last_tapped_at_ = is_second ? -1e9 : now;  // a third tap begins anew
    tap_.reset();
}

std::optional<Touches::Place> Touches::take_menu(double now, bool opens) {
    if (opens && tap_ && now - tapped_at_ >= rest_ms) {
        menu_ = std::exchange(tap_, std::nullopt);
        lift();
        is_over_ = true;
    }
    if (!steps_.empty()) return std::nullopt;
    const auto asked = std::exchange(menu_, std::nullopt);
    return opens ? asked : std::nullopt;
}

std::optional<Touch> Touches::take() {
    if (steps_.empty()) return std::nullopt;
    const Touch step = steps_.front();
    steps_.pop_front();
    return step;
}

}  // namespace braitenlab::web
