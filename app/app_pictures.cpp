// App: pictures and clips.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/app.h"
#include "app/applied_theme.h"
#include "app/files/data.h"
#include "app/files/file_commands.h"
#include "app/files/png.h"
#include "app/files/safe_file.h"
#include "app/lab_selection.h"
#include "app/platform/platform.h"
#include "app/reports/brain_drawing.h"
#include "app/reports/paths_file.h"
#include "core/messages.h"

namespace braitenlab {

namespace {

// Pixels per layout pixel in a picture of the scene: lines and letters keep their share of a window of 1280 × 800, and
// remain legible in a small picture.
float pixel_scale_of(int width, int height) {
    constexpr float usual_width = 1280, usual_height = 800, least = 0.75f;
    return std::max(least,
                    std::min(static_cast<float>(width) / usual_width, static_cast<float>(height) / usual_height));
}

std::optional<Error> write_wiring(const Lab& lab, const Strings& strings, const std::filesystem::path& path) {
    const VehicleView* vehicle = selected_vehicle(lab);
    if (!vehicle) return Error{std::string(strings("unavailable.no_vehicle")), path.string()};
    const Snapshot& now = lab.document.session.snapshot();
    const Kind& kind = kind_of(now, *vehicle);
    return write_whole(path,
                       brain_file(*brain_of(now, *vehicle), kind.sensors, brain_heading(*now.scene, kind), strings));
}

std::optional<Error> write_paths(const Lab& lab, const Strings& strings, const std::filesystem::path& path) {
    const Session& session = lab.document.session;
    const Snapshot& now = session.snapshot();
    return write_whole(path, paths_file(session.recording(), session.earliest(), now.tick, now.scene->title, strings));
}

Error too_large(const std::filesystem::path& path) {
    const int most = render::Offscreen::largest();
    return error_of(message_of("picture_too_large", most, most), path.string());
}

}  // namespace

std::optional<Error> App::write_picture(const std::filesystem::path& path) {
    return write_png(path, window_.framebuffer_width(), window_.framebuffer_height(),
                     canvas_ ? canvas_->pixels() : window_.pixels());
}

void App::take_screenshot() {
    lab_.window.screenshot = false;
    std::error_code none;  // write_picture() reports it
    const auto& folder = folders_.pictures;
    std::filesystem::create_directories(folder, none);
    const auto path = free_name(folder, "braitenlab", ".png");
    if (const auto error = write_picture(path)) return show_error(*error);
    say_saved(lab_, "notice.screenshot", path);
}

SceneLook App::scene_look(int width, int height) const {
    SceneLook look{scene_picture(hidden_brains(view_of(lab_))), viewport_.framed};
    look.picture.settings.camera = viewport_.framing.raised(look.picture.settings.camera);
    look.picture.pixel_scale = pixel_scale_of(width, height);
    look.picture.quality = options_.graphics.quality.value_or(Quality::high);
    return look;
}

void App::follow_take_away() {
    const std::chrono::milliseconds part_of_a_frame{has_threads() ? 60 : 16};  // a page has one thread for all
    if (std::exchange(lab_.window.cancels_clip, false)) clip_.reset();
    if (const auto wanted = std::exchange(lab_.window.take_away, std::nullopt)) {
        std::error_code none;  // writing reports it
        std::filesystem::create_directories(folders_.pictures, none);
        const auto path = free_name(folders_.pictures, "braitenlab", row_of(wanted->kind).extension);
        if (const auto error = take(*wanted, path)) return show_error(*error);
        if (!row_of(wanted->kind).is_clip) say_saved(lab_, "notice.screenshot", path);
    }
    if (!clip_ || !clip_->work(part_of_a_frame)) return;
    if (clip_->error())
        show_error(*clip_->error());
    else
        say_saved(lab_, "notice.clip", clip_->plan().file);
    clip_.reset();
}

std::optional<Error> App::take(const TakeAway& wanted, const std::filesystem::path& path) {
    const int width = wanted.width > 0 ? wanted.width : window_.framebuffer_width();
    const int height = wanted.height > 0 ? wanted.height : window_.framebuffer_height();
    if (row_of(wanted.kind).is_clip) return begin_clip(wanted, path);
    if (wanted.kind == TakeKind::wiring) return write_wiring(lab_, words_.strings, path);
    if (wanted.kind == TakeKind::paths) return write_paths(lab_, words_.strings, path);
    return wanted.kind == TakeKind::window ? write_window(path, width, height) : write_scene(path, width, height);
}

std::optional<Error> App::write_scene(const std::filesystem::path& path, int width, int height) {
    render::Offscreen canvas(width, height);
    if (!canvas.ready()) return too_large(path);
    SceneLook look = scene_look(width, height);
    const Snapshot& now = shown_snapshot(lab_);
    look.picture.camera_view = view_of_look(look, now, width, height, viewport_.framed);
    renderer_.use_lettering(lettering_of(look));
    canvas.bind();
    renderer_.draw(now, look.picture);
    canvas.release();
    load_label_font();
    return write_png(path, width, height, canvas.pixels());
}

std::optional<Error> App::write_window(const std::filesystem::path& path, int width, int height) {
    render::Offscreen canvas(width, height);
    if (!canvas.ready()) return too_large(path);
    const ui::PanelState panels = panels_;
    const ViewportState viewport = viewport_;
    panels_.sheet = ui::Sheet::none;
    frame_.magnified =
        std::min(static_cast<float>(width) / window_.area().w, static_cast<float>(height) / window_.area().h);
    window_.redirect(Window::Canvas{canvas.framebuffer(), width, height});
    for (int i = 0; i < 3; ++i) frame(0);  // the first ones measure the cards
    const auto rgb = canvas.pixels();
    window_.redirect(std::nullopt);
    frame_.magnified = 1;
    panels_ = panels, viewport_ = viewport;
    return write_png(path, width, height, rgb);
}

std::optional<Error> App::begin_clip(const TakeAway& wanted, const std::filesystem::path& path) {
    const auto format = clip_format_of(path);
    const auto data = data_folder();
    if (!format || !data) return format ? data.error() : format.error();
    const SceneLook look = scene_look(wanted.width, wanted.height);
    auto clip = Clip::begin(lab_.document.session.recording(), look,
                            {path, *format, wanted.from, wanted.to, wanted.width, wanted.height}, *data / "shaders",
                            lettering_of(look));
    if (!clip) return clip.error();
    clip_.emplace(std::move(*clip));
    return std::nullopt;
}

render::Lettering App::lettering_of(const SceneLook& look) const {
    const auto pixels = static_cast<int>(std::lround(label_em * look.picture.pixel_scale));
    return label_font(find_label_font, pixels, *theme_.fonts().small).lettering;
}

std::optional<Error> App::write_clip(const Options& options) {
    const auto format = clip_format_of(options.clip.file);
    if (!format) return format.error();
    const auto data = data_folder();
    if (!data) return data.error();
    SceneLook look = scene_look(options.width, options.height);
    look.framed.reset();  // there is no run yet: the action of the whole clip
    look.picture.settings.camera = lab_.view.camera;
    const auto tick = [](double seconds) {
        return static_cast<std::uint64_t>(std::llround(seconds * static_cast<double>(clip_second)));
    };
    auto clip = Clip::begin(
        lab_.document.session.recording(), look,
        {options.clip.file, *format, tick(options.clip.from), tick(options.clip.to), options.width, options.height},
        *data / "shaders", lettering_of(look));
    if (!clip) return clip.error();
    while (!clip->work(std::chrono::seconds(1))) {
    }
    return clip->error();
}

}  // namespace braitenlab
