// The time of a frame of the window's panels, compared with a tick and a picture of the same 50 vehicles, and the
// number of allocations. Dear ImGui uses another allocator, which is not counted.
#include <cstdint>
#include <optional>

#include <GL/glew.h>
#include <benchmark/benchmark.h>
#include <imgui.h>

#include "app/lab_requests.h"
#include "app/playback.h"
#include "render/gl/renderer.h"
#include "tests/bench/own_memory.h"
#include "tests/render/stage.h"
#include "ui/panels/prompts.h"
#include "ui/widgets/theme.h"
#include "ui/window.h"
#include "ui/words/strings.h"

namespace braitenlab {
namespace {

using namespace render;

constexpr int width = 1280, height = 800;

Result<Lab> hunt(int vehicles) {
    auto lab = open_lab(BRAITENLAB_SOURCE "/exercises/scenes/predator-prey.toml", 1, {});
    while (lab && static_cast<int>(lab->document.session.snapshot().vehicles.size()) < vehicles)
        if (lab->document.session.apply(AddVehicle{})) break;
    return lab;
}

// The window's panels without a window.
class Panels {
public:
    Panels() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {width, height};
        io.DeltaTime = 1.0f / 60;
        const std::string noto = "/usr/share/fonts/truetype/noto/";
        loaded_ = ui::load_fonts(*io.Fonts, 1,
                                 {noto + "NotoSans-Regular.ttf",
                                  noto + "NotoSans-Bold.ttf",
                                  "/usr/share/fonts/truetype/fork-awesome/forkawesome-webfont.ttf",
                                  {}});
        unsigned char* pixels = nullptr;
        int w = 0, h = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &w, &h);
        ui::apply_theme(Theme::dark, 1);
    }
    ~Panels() { ImGui::DestroyContext(); }

    // One pass over all panels; returns the number of triangles.
    int frame(const LabView& view, const Strings& strings) {
        ImGui::NewFrame();
        outbox_.clear();
        anchors_.begin();
        ui::Ui ui{.strings = strings,
                  .palette = palette(Theme::dark),
                  .fonts = loaded_.fonts,
                  .anchors = anchors_,
                  .outbox = outbox_,
                  .pulse = ui::pulse(view)};
        ui::draw_window(view, state_, ui, ui::lay_out(width, height, 1, view));
        ImGui::Render();
        return ImGui::GetDrawData()->TotalIdxCount / 3;
    }

private:
    ui::LoadedFonts loaded_;
    ui::PanelState state_;
    ui::Anchors anchors_;
    Outbox outbox_;
};

void BM_UiPass(benchmark::State& state) {
    auto lab = hunt(static_cast<int>(state.range(0)));
    const auto strings = load_language(BRAITENLAB_SOURCE "/ui/strings", "en");
    if (!lab || !strings) return state.SkipWithError("the hunt or the words cannot be read");
    handle(*lab, Action::play_pause);
    Panels panels;
    int triangles = 0;
    for (int i = 0; i < 600; ++i) tick(*lab), lab->wall_seconds += 1.0 / 60, panels.frame(view_of(*lab), *strings);
    std::int64_t asked = 0, frames = 0;
    for (auto _ : state) {
        state.PauseTiming();
        tick(*lab);
        lab->wall_seconds += 1.0 / 60;
        const LabView view = view_of(*lab);
        const std::int64_t before = bench::allocations();
        state.ResumeTiming();
        triangles = panels.frame(view, *strings);
        asked += bench::allocations() - before;
        ++frames;
    }
    state.counters["triangles"] = triangles;
    state.counters["allocations_a_frame"] = static_cast<double>(asked) / static_cast<double>(frames);
}

// The limit for the pass above: one tick and one picture, to glFinish.
void BM_StepAndDraw(benchmark::State& state) {
    auto lab = hunt(static_cast<int>(state.range(0)));
    Stage stage(width, height);
    if (!stage.ready()) return state.SkipWithError(stage.problem().c_str());
    auto renderer = Renderer::create(BRAITENLAB_SOURCE "/shaders", SectorPath::automatic);
    if (!lab || !renderer) return state.SkipWithError("the hunt or the shaders cannot be read");
    const Rect window{0, 0, width, height};
    Picture picture;
    picture.camera_view = look(Camera{}, lab->document.session.scene().arena, nullptr, window, window);
    for (auto _ : state) {
        tick(*lab);
        renderer->draw(lab->document.session.snapshot(), picture);
        glFinish();
    }
}

BENCHMARK(BM_UiPass)->Arg(50)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_StepAndDraw)->Arg(50)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace braitenlab
