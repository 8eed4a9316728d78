#include "app/pictures/clip.h"

#include <algorithm>
#include <utility>

#include "app/viewport.h"
#include "core/messages.h"
#include "render/gl/offscreen.h"

namespace braitenlab {

namespace {

constexpr std::uint64_t colour_samples = 12;  // pictures from which the colours of a GIF are chosen
constexpr std::size_t most_colours = 255;

}  // namespace

CameraView view_of_look(const SceneLook& look_of, const Snapshot& now, int width, int height, const FloorBox& framed) {
    const ViewSettings& settings = look_of.picture.settings;
    const Rect all{0, 0, static_cast<float>(width), static_cast<float>(height)};
    const VehicleView* followed = rides(settings.camera.mode) ? find_vehicle(now, settings.selection.vehicle) : nullptr;
    return look(settings.camera, now.scene->arena, followed, all, all, look_of.framed ? &*look_of.framed : &framed,
                ride_scale(now, followed));
}

// Two passes over the run. The first one records the paths of the vehicles up to the clip; of a GIF it goes on to the
// end, for the colours and, where the look has none, for the framed part of the floor.
struct Clip::Parts {
    Recording recording;
    SceneLook look;
    ClipPlan plan;
    render::Renderer renderer;
    render::Offscreen canvas;
    Camera camera;  // at the beginning; the slow orbit turns that of the look
    RecordedRun run;
    bool prepares = true;
    std::uint64_t prepared_to;
    Framing framing;
    FloorBox framed;
    ColourCount colours;
    std::optional<ClipFile> file;
    std::optional<Error> error;

    Parts(Recording of, SceneLook with, ClipPlan wanted, render::Renderer draws, render::Offscreen on)
        : recording(std::move(of)),
          look(std::move(with)),
          plan(std::move(wanted)),
          renderer(std::move(draws)),
          canvas(std::move(on)),
          camera(look.picture.settings.camera),
          run(recording, recording.earliest()),
          prepared_to(plan.format == ClipFormat::gif || !look.framed ? plan.to : plan.from) {}

    std::uint64_t ticks() const { return static_cast<std::uint64_t>(row_of(plan.format).ticks); }

    std::vector<unsigned char> draw() {
        look.picture.camera_view = view_of_look(look, run.snapshot(), plan.width, plan.height, framed);
        canvas.bind();
        renderer.draw(run.snapshot(), look.picture);
        canvas.release();
        return canvas.pixels();
    }

    void frame_action() {
        if (look.framed) return;
        const Rect all{0, 0, static_cast<float>(plan.width), static_cast<float>(plan.height)};
        framed = framing.follow(
            run.snapshot(),
            {.camera = camera, .selected = look.picture.settings.selection.vehicle, .window = all, .free_area = all});
        look.picture.settings.camera = framing.raised(camera);
    }

    void prepare() {
        renderer.remember(run.snapshot());
        if (run.tick() >= plan.from) {
            frame_action();
            const std::uint64_t stride = std::max<std::uint64_t>(1, (plan.to - plan.from) / colour_samples);
            if (plan.format == ClipFormat::gif && (run.tick() - plan.from) % stride == 0) colours.add(draw());
        }
        if (run.tick() < prepared_to) return run.step();
        prepares = false;
        run = RecordedRun(recording, plan.from);
        auto begun = ClipFile::begin(plan.file, plan.format, plan.width, plan.height, colours.choose(most_colours));
        if (begun)
            file.emplace(std::move(*begun));
        else
            error = begun.error();
    }

    void add_picture() {
        const bool added = file->add(draw());
        const bool is_last = run.tick() + ticks() > plan.to;
        if (!added || is_last) {
            error = file->finish();
            file.reset();
            return;
        }
        for (std::uint64_t i = 0; i < ticks(); ++i) {
            run.step();
            renderer.remember(run.snapshot());
        }
        Camera& turned = look.picture.settings.camera;
        if (look.picture.settings.orbits && !look.picture.reduce_motion && !rides(turned.mode))
            orbit_slowly(turned, static_cast<float>(ticks()) / static_cast<float>(clip_second));
    }
};

Result<Clip> Clip::begin(Recording recording, SceneLook look, ClipPlan plan, const std::filesystem::path& shader_folder,
                         render::Lettering of_labels) {
    const std::string file = plan.file.string();
    if (plan.to <= plan.from) return error_of(message_of("no_clip_time"), file);
    if (plan.to - plan.from > longest_clip * clip_second)
        return error_of(message_of("clip_too_long", longest_clip), file);
    render::Offscreen canvas(plan.width, plan.height);
    if (!canvas.ready()) {
        const int most = render::Offscreen::largest();
        return error_of(message_of("picture_too_large", most, most), file);
    }
    auto renderer = render::Renderer::create(shader_folder);
    if (!renderer) return renderer.error();
    renderer->use_lettering(std::move(of_labels));
    return Clip(std::make_unique<Parts>(std::move(recording), std::move(look), std::move(plan), std::move(*renderer),
                                        std::move(canvas)));
}

Clip::Clip(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Clip::Clip(Clip&&) noexcept = default;
Clip::~Clip() = default;

bool Clip::work(std::chrono::milliseconds budget) {
    const auto until = std::chrono::steady_clock::now() + budget;
    Parts& p = *parts_;
    do {
        if (p.error || (!p.prepares && !p.file)) return true;
        p.prepares ? p.prepare() : p.add_picture();
    } while (std::chrono::steady_clock::now() < until);
    return p.error || (!p.prepares && !p.file);
}

float Clip::progress() const {
    constexpr float first_share = 0.15f;  // of the time, the first pass
    const Parts& p = *parts_;
    const auto part = [](std::uint64_t done, std::uint64_t all) {
        return static_cast<float>(done) / static_cast<float>(std::max<std::uint64_t>(1, all));
    };
    const std::uint64_t first = p.recording.earliest();
    if (p.prepares) return first_share * part(p.run.tick() - first, p.prepared_to - first);
    return first_share + (1 - first_share) * part(p.run.tick() - p.plan.from, p.plan.to - p.plan.from);
}

const std::optional<Error>& Clip::error() const { return parts_->error; }
const ClipPlan& Clip::plan() const { return parts_->plan; }

}  // namespace braitenlab
