// App: pictures and clips.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/app.h"
#include "app/applied_theme.h"
#include "app/files/data.h"
#include "app/files/screenshot.h"
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

}  // namespace

std::optional<Error> App::write_picture(const std::filesystem::path& path) {
    return write_png(path, window_.framebuffer_width(), window_.framebuffer_height(),
                     canvas_ ? canvas_->pixels() : window_.pixels());
}

void App::take_screenshot() {
    lab_.screenshot = false;
    std::error_code none;  // write_picture() reports it
    const auto& folder = folders_.pictures;
    std::filesystem::create_directories(folder, none);
    const auto path = next_screenshot_name(folder);
    if (const auto error = write_picture(path)) return show_error(*error);
    say(lab_, {NoticeKind::done, "notice.screenshot", path.string()});
}

SceneLook App::scene_look(int width, int height) const {
    SceneLook look{scene_picture(hidden_brains(view_of(lab_))), viewport_.framed};
    look.picture.pixel_scale = pixel_scale_of(width, height);
    return look;
}

render::Lettering App::lettering_of(const SceneLook& look) const {
    const auto pixels = static_cast<int>(std::lround(label_em * look.picture.pixel_scale));
    return label_font(find_label_font, pixels, *theme_.fonts().small).lettering;
}

std::optional<Error> App::write_clip(const Options& options) {
    const auto format = clip_format_of(options.clip);
    if (!format) return format.error();
    const auto data = data_folder();
    if (!data) return data.error();
    SceneLook look = scene_look(options.width, options.height);
    look.framed.reset();  // there is no run yet: the action of the whole clip
    const auto tick = [](double seconds) {
        return static_cast<std::uint64_t>(std::llround(seconds * static_cast<double>(clip_second)));
    };
    auto clip = Clip::begin(
        lab_.document.session.recording(), look,
        {options.clip, *format, tick(options.clip_from), tick(options.clip_to), options.width, options.height},
        *data / "shaders", lettering_of(look));
    if (!clip) return clip.error();
    while (!clip->work(std::chrono::seconds(1))) {
    }
    return clip->error();
}

}  // namespace braitenlab
