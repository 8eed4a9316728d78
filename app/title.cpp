#include "app/title.h"

#include "app/files/data.h"
#include "app/lab_selection.h"
#include "app/playback.h"
#include "app/viewport.h"
#include "ui/panels/title_page.h"

namespace braitenlab {

namespace {

constexpr const char* title_scene = "moth-and-hunter";
constexpr int ticks_before = 5 * 60;  // the paths are then long enough to be seen
constexpr float title_elevation = 0.55f, title_zoom = 1.25f;

}  // namespace

std::optional<Lab> title_lab(const std::function<void(const Snapshot&)>& seen) {
    const auto file = find_shipped(title_scene);
    if (!file) return std::nullopt;
    auto opened = open_lab(*file, std::nullopt, {});
    if (!opened) return std::nullopt;
    Lab title = std::move(*opened);
    for (int i = 0; i < ticks_before; ++i) {
        title.document.session.step();
        seen(title.document.session.snapshot());
    }
    select_none(title);
    title.view.sensors = title.view.overlays.labels = false;
    title.view.camera.elevation = title_elevation;
    title.view.camera.zoom = title_zoom;
    title.view.orbits = true;
    set_mode(title, Mode::playing);
    return title;
}

void advance_title(Lab& title, float seconds) {
    if (title.preferences.reduce_motion) return;
    advance(title, seconds);
    orbit_slowly(title.view.camera, seconds);
}

Rect title_area(Rect window) {
    const float words = ui::title_words_share;
    if (window.h > window.w) return {window.x, window.y + words * window.h, window.w, (1 - words) * window.h};
    return {window.x + words * window.w, window.y, (1 - words) * window.w, window.h};
}

}  // namespace braitenlab
