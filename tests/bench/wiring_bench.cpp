// Time of the wiring canvas per frame, from reading the brain to Dear ImGui's draw list.
#include <benchmark/benchmark.h>
#include <imgui.h>

#include "tests/ui/large_brain.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/canvas.h"
#include "ui/words/strings.h"

namespace braitenlab {
namespace {

class Easel {
public:
    explicit Easel(const BrainGraph& graph) : now_(tests::snapshot_with(graph)) {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1280, 800};
        io.DeltaTime = 1.0f / 60;
        if (sizeof(ImDrawIdx) == 2) io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // as the window has
        const std::string noto = "/usr/share/fonts/truetype/noto/";
        fonts_ =
            ui::load_fonts(*io.Fonts, 1, {noto + "NotoSans-Regular.ttf", noto + "NotoSans-Bold.ttf", "", {}}).fonts;
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
        ui::apply_theme(Theme::dark, 1);
        view_.now = &now_;
        view_.mode = Mode::wiring;
        view_.settings.selection.vehicle = 0;
    }
    ~Easel() { ImGui::DestroyContext(); }
    Easel(const Easel&) = delete;
    Easel& operator=(const Easel&) = delete;

    void frame() {
        ImGui::NewFrame();
        anchors_.begin();
        outbox_.clear();
        ui::Ui ui{strings_, palette(Theme::dark), fonts_, 1, anchors_, outbox_, {}};
        wiring::draw_canvas(view_, state_, ui, area_);
        ImGui::Render();
    }
    void forget_layout() { state_.layout = {}; }
    void zoom(float to) { state_.camera.zoom = to, state_.camera.by_user = true; }
    int vertices() const { return ImGui::GetDrawData()->TotalVtxCount; }
    float shown_at() const { return state_.camera.zoom; }

private:
    const Rect area_{16, 64, 900, 600};
    Snapshot now_;
    Strings strings_;
    ui::Anchors anchors_;
    Outbox outbox_;
    LabView view_;
    ui::Fonts fonts_;
    wiring::CanvasState state_;
};

void report(benchmark::State& state, const Easel& easel) {
    state.counters["vertices"] = easel.vertices();
    state.counters["zoom"] = static_cast<double>(easel.shown_at());
}

// The whole brain is visible.
void BM_WiringCanvas(benchmark::State& state) {
    Easel easel(tests::large_brain(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
    for (int i = 0; i < 3; ++i) easel.frame();
    for (auto _ : state) easel.frame();
    report(state, easel);
}
BENCHMARK(BM_WiringCanvas)->Args({4, 4})->Args({30, 100})->Args({200, 800})->Unit(benchmark::kMicrosecond);

// A corner of the brain at zoom 1: most of it is not visible.
void BM_WiringCanvasNear(benchmark::State& state) {
    Easel easel(tests::large_brain(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
    for (int i = 0; i < 3; ++i) easel.frame();
    easel.zoom(1);
    for (auto _ : state) easel.frame();
    report(state, easel);
}
BENCHMARK(BM_WiringCanvasNear)->Args({200, 800})->Unit(benchmark::kMicrosecond);

// A frame after an edit or a moved node: a new layout.
void BM_WiringCanvasEdited(benchmark::State& state) {
    Easel easel(tests::large_brain(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
    for (int i = 0; i < 3; ++i) easel.frame();
    for (auto _ : state) {
        easel.forget_layout();
        easel.frame();
    }
    report(state, easel);
}
BENCHMARK(BM_WiringCanvasEdited)->Args({200, 800})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace braitenlab
