// The file of a clip: pictures of one size, as GIF or, by the program ffmpeg, as MP4 or WebM.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "app/pictures/colour_table.h"
#include "core/enum_table.h"
#include "core/result.h"

namespace braitenlab {

enum class ClipFormat { gif, mp4, webm };

inline constexpr std::uint64_t clip_second = 60;  // ticks

struct ClipFormatTraits {
    ClipFormat value;
    std::string_view extension;  // with its dot
    int ticks;                   // of the simulation, 1/60 s, between two pictures
    bool by_ffmpeg;
};
// A GIF counts in hundredths of a second: of the rates that it can have, 20 per second alone is a whole number of
// ticks.
inline constexpr std::array<ClipFormatTraits, 3> clip_formats{{
    {ClipFormat::gif, ".gif", 3, false},
    {ClipFormat::mp4, ".mp4", 2, true},
    {ClipFormat::webm, ".webm", 2, true},
}};
static_assert(has_enumerators<ClipFormat, clip_formats.size()>());
constexpr const ClipFormatTraits& row_of(ClipFormat format) { return clip_formats[static_cast<std::size_t>(format)]; }

// The format of a file by the extension of its name, in capitals too; else an error that names the extensions.
Result<ClipFormat> clip_format_of(const std::filesystem::path&);

// True if the format can be written on this computer: MP4 and WebM where ffmpeg is installed.
bool can_write(ClipFormat);

// Writes a file beside it first; only finish() gives it its name. Without finish(), the old file stays as it was.
class ClipFile {
public:
    // `colours` of a GIF: at most 255. Fails if the folder does not exist or may not be written to, and where
    // ffmpeg is needed and missing.
    static Result<ClipFile> begin(const std::filesystem::path&, ClipFormat, int width, int height,
                                  std::vector<Rgb> colours);
    ClipFile(ClipFile&&) noexcept;
    ~ClipFile();

    // Three bytes per pixel, rows from the top. False if the file cannot be written any more; finish() says why.
    bool add(const std::vector<unsigned char>& rgb);

    std::optional<Error> finish();

    struct Writer;  // of one kind of file

private:
    explicit ClipFile(std::unique_ptr<Writer>);
    std::unique_ptr<Writer> writer_;
};

}  // namespace braitenlab
