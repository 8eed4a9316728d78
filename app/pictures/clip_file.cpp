#include "app/pictures/clip_file.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "app/files/safe_file.h"
#include "app/pictures/gif.h"
#include "app/platform/platform.h"
#include "core/messages.h"
#include "core/plain_letters.h"

namespace braitenlab {

namespace fs = std::filesystem;

struct ClipFile::Writer {
    Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    virtual ~Writer() = default;
    virtual bool add(const std::vector<unsigned char>& rgb) = 0;
    virtual std::optional<Error> finish() = 0;
};

namespace {

constexpr const char* ffmpeg = "ffmpeg";
constexpr int second = static_cast<int>(clip_second);

struct GifFile final : ClipFile::Writer {
    GifFile(const fs::path& path, int width, int height, std::vector<Rgb> colours)
        : gif(width, height, std::move(colours), row_of(ClipFormat::gif).ticks * 100 / second), file(path) {
        file.write(gif.begin());
    }
    bool add(const std::vector<unsigned char>& rgb) override {
        file.write(gif.picture(rgb));
        return true;
    }
    std::optional<Error> finish() override {
        file.write(GifWriter::end());
        return file.commit();
    }
    GifWriter gif;
    FileWriter file;
};

// Sizes of both formats are even: a last row or column is added where they are not.
std::vector<std::string> ffmpeg_arguments(ClipFormat format, int width, int height, const fs::path& to) {
    std::vector<std::string> line{"-v",
                                  "error",
                                  "-nostdin",
                                  "-y",
                                  "-f",
                                  "rawvideo",
                                  "-pixel_format",
                                  "rgb24",
                                  "-video_size",
                                  fmt::format("{}x{}", width, height),
                                  "-framerate",
                                  std::to_string(second / row_of(format).ticks),
                                  "-i",
                                  "pipe:0",
                                  "-an",
                                  "-vf",
                                  "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv",
                                  "-pix_fmt",
                                  "yuv420p",
                                  "-colorspace",
                                  "bt709",
                                  "-color_primaries",
                                  "bt709",
                                  "-color_trc",
                                  "bt709"};
    const std::vector<std::string> of_format =
        format == ClipFormat::mp4
            ? std::vector<std::string>{"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4"}
            : std::vector<std::string>{"-c:v", "libvpx-vp9", "-crf", "28",      "-b:v", "0",  "-deadline",
                                       "good", "-cpu-used",  "5",    "-row-mt", "1",    "-f", "webm"};
    line.insert(line.end(), of_format.begin(), of_format.end());
    line.push_back("file:" + to.string());  // a name may begin with '-' or have a ':'
    return line;
}

struct FfmpegFile final : ClipFile::Writer {
    FfmpegFile(fs::path path, fs::path part, ProgramPipe program)
        : wanted(std::move(path)), beside(std::move(part)), pipe(std::move(program)) {}
    ~FfmpegFile() override {
        pipe.reset();
        std::error_code none;
        fs::remove(beside, none);
    }
    bool add(const std::vector<unsigned char>& rgb) override {
        return pipe && pipe->write({reinterpret_cast<const char*>(rgb.data()), rgb.size()});
    }
    std::optional<Error> finish() override {
        const auto problem = pipe->finish();
        pipe.reset();
        if (problem) return error_of(message_of("ffmpeg_failed", problem->empty() ? "?" : *problem), wanted.string());
        std::error_code failed;
        fs::rename(beside, wanted, failed);
        if (failed) return error_of(message_of("not_saved", failed.message()), wanted.string());
        return std::nullopt;
    }
    fs::path wanted, beside;
    std::optional<ProgramPipe> pipe;
};

}  // namespace

Result<ClipFormat> clip_format_of(const fs::path& path) {
    const std::string extension = lower_case(path.extension().string());
    for (const ClipFormatTraits& row : clip_formats)
        if (row.extension == extension) return row.value;
    return error_of(message_of("no_clip_format"), path.string());
}

bool can_write(ClipFormat format) {
    if (!row_of(format).by_ffmpeg) return true;
    static const bool is_installed = !find_program(ffmpeg).empty();
    return is_installed;
}

ClipFile::ClipFile(std::unique_ptr<Writer> writer) : writer_(std::move(writer)) {}
ClipFile::ClipFile(ClipFile&&) noexcept = default;
ClipFile::~ClipFile() = default;

Result<ClipFile> ClipFile::begin(const fs::path& path, ClipFormat format, int width, int height,
                                 std::vector<Rgb> colours) {
    if (auto error = FileWriter(path).problem()) return *error;
    if (!row_of(format).by_ffmpeg) return ClipFile(std::make_unique<GifFile>(path, width, height, std::move(colours)));
    const fs::path program = find_program(ffmpeg);
    if (program.empty()) return error_of(message_of("no_ffmpeg"), path.string());
    fs::path beside = path.parent_path() / fmt::format(".{}.{}.new", path.filename().string(), process_number());
    auto pipe = ProgramPipe::start(program, ffmpeg_arguments(format, width, height, beside));
    if (!pipe) return error_of(message_of("no_ffmpeg"), path.string());
    return ClipFile(std::make_unique<FfmpegFile>(path, std::move(beside), std::move(*pipe)));
}

bool ClipFile::add(const std::vector<unsigned char>& rgb) { return writer_->add(rgb); }
std::optional<Error> ClipFile::finish() { return writer_->finish(); }

}  // namespace braitenlab
