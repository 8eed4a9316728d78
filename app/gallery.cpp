#include "app/gallery.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <stb_image.h>

#include "app/document.h"
#include "app/files/data.h"
#include "app/files/png.h"
#include "core/maths/fnv.h"
#include "core/scene/file_kind.h"
#include "render/view/framing.h"

namespace braitenlab {

namespace {

constexpr int picture_width = 480, picture_height = 278;
constexpr float picture_elevation = 0.85f, least_vehicle = 0.07f;  // rad; of the width

// RGBA, rows from the bottom; empty if there is no such picture.
std::vector<std::uint8_t> read_picture(const std::filesystem::path& path) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> read(
        stbi_load(path.string().c_str(), &width, &height, &channels, 4), stbi_image_free);
    if (!read || width != picture_width || height != picture_height) return {};
    const std::size_t row = static_cast<std::size_t>(width) * 4;
    std::vector<std::uint8_t> pixels;
    for (std::size_t y = static_cast<std::size_t>(height); y-- > 0;)
        pixels.insert(pixels.end(), read.get() + y * row, read.get() + (y + 1) * row);
    return pixels;
}

// Errors are not reported: the picture is then rendered again at the next start.
void write_picture(const std::filesystem::path& path, const std::vector<std::uint8_t>& rgba) {
    std::vector<unsigned char> rgb;
    for (std::size_t y = picture_height; y-- > 0;)
        for (std::size_t x = 0; x < picture_width; ++x) {
            const auto at = rgba.begin() + static_cast<std::ptrdiff_t>((y * picture_width + x) * 4);
            rgb.insert(rgb.end(), at, at + 3);
        }
    std::error_code none;
    std::filesystem::create_directories(path.parent_path(), none);
    if (!none) (void)write_png(path, picture_width, picture_height, rgb);
}

// The scene at its start, without paths, sensor fields and names; without wires where they could tell an outcome.
Picture picture_of(const Snapshot& now, bool is_exercise, Theme theme) {
    const Rect all{0, 0, picture_width, picture_height};
    Picture picture;
    picture.theme = theme;
    picture.quality = Quality::high;
    picture.settings.camera.elevation = picture_elevation;
    picture.settings.sensors = picture.settings.overlays.labels = picture.settings.overlays.trails = false;
    for (const Kind& kind : now.scene->kinds) picture.hidden_brains.push_back(kind.hidden);
    if (is_exercise) picture.hidden_brains.assign(now.scene->kinds.size(), true);
    picture.reduce_motion = true;
    Framing framing;
    const FloorBox box = framing.follow(now, {.camera = picture.settings.camera,
                                              .selected = now.vehicles.empty() ? no_vehicle : now.vehicles.front().id,
                                              .window = all,
                                              .free_area = all,
                                              .least_share = least_vehicle});
    picture.settings.camera = framing.raised(picture.settings.camera);
    picture.camera_view = look(picture.settings.camera, now.scene->arena, nullptr, all, all, &box);
    return picture;
}

}  // namespace

std::string cached_picture_name(std::string_view content, std::string_view version, Theme theme) {
    constexpr std::string_view format = "3";  // changes with the constants of this file and with the framing
    std::uint64_t hash = maths::fnv_start;
    for (const std::string_view text : {content, version, format}) hash = maths::fnv(text, hash);
    return fmt::format("{:016x}-{}.png", hash, word(theme));
}

bool Gallery::make_next(render::Renderer& renderer, const std::vector<std::string>& files, Theme theme) {
    if (theme != theme_) stills_.clear(), pictures_.clear(), theme_ = theme;
    const auto next =
        std::find_if(files.begin(), files.end(), [&](const auto& file) { return !pictures_.contains(file); });
    if (next == files.end()) return false;
    pictures_[*next] = 0;
    make(renderer, *next);
    return true;
}

void Gallery::make(render::Renderer& renderer, const std::string& file) {
    const auto content = read_text(file);
    if (!content) return;
    const auto cached =
        cache_.empty() ? cache_ : cache_ / "pictures" / cached_picture_name(*content, version_text(), theme_);
    const auto keep = [&](render::Still still) {
        pictures_[file] = still.texture();
        stills_.emplace(file, std::move(still));
    };
    render::Still still(picture_width, picture_height);
    if (const auto pixels = cached.empty() ? std::vector<std::uint8_t>{} : read_picture(cached); !pixels.empty()) {
        still.fill(pixels);
        return keep(std::move(still));
    }
    const auto document = open_document(file, std::nullopt, {});
    if (!document) return;
    const Snapshot& now = document->session.snapshot();
    if (!still.draw(renderer, now, picture_of(now, document->lesson.has_value(), theme_))) return;
    if (!cached.empty()) write_picture(cached, still.pixels());
    keep(std::move(still));
}

}  // namespace braitenlab
