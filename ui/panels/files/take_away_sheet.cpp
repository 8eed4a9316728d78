// The sheet for a picture or a clip: what it shows, its size, of a clip its format and its part of the run.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float usual_clip = 10, longest_clip = 120;  // s
constexpr float ticks_of_a_second = 60;

struct PictureSize {
    int width, height;  // px; 0: as the window
};
constexpr std::array<PictureSize, 4> picture_sizes{{{0, 0}, {1920, 1080}, {2560, 1440}, {3840, 2160}}};
constexpr std::array<PictureSize, 3> clip_sizes{{{640, 400}, {960, 600}, {1280, 800}}};

template <std::size_t n>
PictureSize size_choice(Ui& ui, std::string_view id, const std::array<PictureSize, n>& sizes, std::size_t& chosen) {
    std::array<std::string, n> texts;
    std::array<std::string_view, n> words;
    for (std::size_t i = 0; i < n; ++i) {
        texts[i] = sizes[i].width == 0 ? std::string(ui.strings("take.as_window"))
                                       : fmt::format("{} × {}", sizes[i].width, sizes[i].height);
        words[i] = texts[i];
    }
    subheading(ui, ui.strings("take.size"));
    const int clicked = segments(ui, id, words, static_cast<int>(chosen), card_width(ui), ui.strings("take.size_how"));
    if (clicked >= 0) chosen = static_cast<std::size_t>(clicked);
    gap(ui, 8);
    return sizes[chosen];
}

// Why the diagram cannot be drawn; empty: it can.
std::string_view why_no_diagram(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle) return "unavailable.no_vehicle";
    return hides_brain(view, vehicle->kind) ? "take.hidden" : "";
}

std::string_view why_no_picture(const LabView& view, const TakeAwayState& state) {
    const TakeKind kind = pictures_to_take[state.picture];
    if (kind == TakeKind::wiring) return why_no_diagram(view);
    return kind == TakeKind::paths && view.now->tick == 0 ? "take.no_run" : "";
}

void reason(Ui& ui, std::string_view why) {
    if (why.empty()) return;
    paragraph(ui, ui.strings(why), legible(ui.palette.warning, ui.palette.panel, ui.palette.text), Face::small);
}

TakeAway picture_page(const LabView& view, TakeAwayState& state, Ui& ui) {
    const std::array<std::string_view, pictures_to_take.size()> words{
        ui.strings("take.scene"), ui.strings("take.window"), ui.strings("take.wiring"), ui.strings("take.paths")};
    subheading(ui, ui.strings("take.shows"));
    const int clicked = segments(ui, "take.shows", words, static_cast<int>(state.picture), card_width(ui),
                                 ui.strings("take.shows_how"));
    if (clicked >= 0) state.picture = static_cast<std::size_t>(clicked);
    gap(ui, 8);
    const TakeKind kind = pictures_to_take[state.picture];
    if (kind == TakeKind::scene || kind == TakeKind::window) {
        const PictureSize size = size_choice(ui, "take.size", picture_sizes, state.picture_size);
        return {kind, size.width, size.height};
    }
    reason(ui, why_no_picture(view, state));
    return {kind};
}

TakeKind format_choice(const LabView& view, TakeAwayState& state, Ui& ui) {
    std::vector<TakeKind> kinds;
    std::vector<std::string_view> words;
    for (const TakeKindTraits& row : take_kinds) {
        if (!row.is_clip || (row.by_ffmpeg && !view.program.has_ffmpeg)) continue;
        kinds.push_back(row.value);
        words.push_back(row.value == TakeKind::gif ? "GIF" : row.value == TakeKind::mp4 ? "MP4" : "WebM");
    }
    if (state.format >= kinds.size()) state.format = 0;
    subheading(ui, ui.strings("take.format"));
    const int clicked = segments(ui, "take.format", words, static_cast<int>(state.format), card_width(ui),
                                 ui.strings("take.format_how"));
    if (clicked >= 0) state.format = static_cast<std::size_t>(clicked);
    if (kinds.size() == 1 && !view.program.uploads)
        paragraph(ui, ui.strings("take.needs_ffmpeg"), ui.palette.second_text, Face::small);
    gap(ui, 8);
    return kinds[state.format];
}

// The recorded part of the run, s.
struct RecordedTime {
    float earliest, latest;
    explicit RecordedTime(const LabView& view)
        : earliest(static_cast<float>(view.timeline.earliest) / ticks_of_a_second),
          latest(static_cast<float>(view.timeline.latest) / ticks_of_a_second) {}
};

void time_slider(const LabView& view, PanelState& state, Ui& ui, std::string_view id, float& value, float home) {
    const RecordedTime time(view);
    const std::string_view words = ui.strings(id);
    const SliderLook look{.words = words,
                          .tooltip = ui.strings("take.time_how"),
                          .low = time.earliest,
                          .high = time.latest,
                          .home = home,
                          .step = 0.1f,
                          .decimals = 1,
                          .unit = " s",
                          .signed_number = false,
                          .meaning = false,
                          .words_width = 48,
                          .number_width = 64};
    if (const auto edit = slider(ui, state.sliders, id, value, card_width(ui), view.wall_seconds, look))
        value = edit->value;
}

// Why there can be no clip; empty: there can be one.
std::string_view why_no_clip(const LabView& view, const TakeAwayState& state) {
    if (view.lesson && view.lesson->together) return "take.together";
    if (view.timeline.latest <= view.timeline.earliest) return "take.no_run";
    if (state.to <= state.from) return "take.no_time";
    if (state.to - state.from > longest_clip) return "take.too_long";
    return {};
}

TakeAway clip_page(const LabView& view, PanelState& panels, Ui& ui) {
    TakeAwayState& state = panels.sheets.take;
    const RecordedTime time(view);
    TakeAway wanted{format_choice(view, state, ui)};
    const PictureSize size = size_choice(ui, "take.size", clip_sizes, state.clip_size);
    wanted.width = size.width, wanted.height = size.height;
    subheading(ui, ui.strings("take.part"));
    if (time.latest > time.earliest) {
        time_slider(view, panels, ui, "take.from", state.from, std::max(time.earliest, time.latest - usual_clip));
        time_slider(view, panels, ui, "take.to", state.to, time.latest);
    }
    reason(ui, why_no_clip(view, state));
    const auto tick = [](float seconds) {
        return static_cast<std::uint64_t>(std::lround(seconds * ticks_of_a_second));
    };
    wanted.from = tick(state.from), wanted.to = std::min(tick(state.to), view.timeline.latest);
    return wanted;
}

void clip_progress(float progress, Ui& ui) {
    const std::string percent = std::to_string(static_cast<int>(std::floor(100 * progress)));
    paragraph(ui, fill(ui.strings("take.progress"), {percent}), ui.palette.text);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect bar{at.x, at.y, card_width(ui), ui.px(6)};
    fill_box(ui, bar, ui.palette.raised, Corner::round);
    fill_box(ui, {bar.x, bar.y, bar.w * progress, bar.h}, ui.palette.accent, Corner::round);
    ImGui::Dummy({bar.w, bar.h + ui.px(spacing::small)});
}

// The last ten seconds, each time that the sheet opens.
void begin_take(const LabView& view, TakeAwayState& state) {
    const RecordedTime time(view);
    state.open = true;
    state.to = time.latest;
    state.from = std::max(time.earliest, time.latest - usual_clip);
}

}  // namespace

void follow_take_away(const LabView& view, PanelState& panels, Ui& ui) {
    TakeAwayState& state = panels.sheets.take;
    const bool is_written = std::exchange(state.writes, view.program.clip_progress.has_value()) && !state.writes;
    if (panels.sheet == Sheet::take && is_written) panels.sheet = Sheet::none;
    if (panels.sheet != Sheet::take && std::exchange(state.open, false) && view.program.clip_progress)
        ui.outbox.emplace_back(CancelClipRequest{});
}

void take_away_sheet(const LabView& view, PanelState& panels, Ui& ui, Rect window) {
    TakeAwayState& state = panels.sheets.take;
    if (!state.open) begin_take(view, state);
    SheetState& sheet = open_sheet(panels, ui, Sheet::take, window);
    TakeAway wanted;
    if (view.program.clip_progress) {
        clip_progress(*view.program.clip_progress, ui);
    } else {
        const std::array<std::string_view, 2> pages{ui.strings("take.picture"), ui.strings("take.clip")};
        const int clicked = segments(ui, "take.page", pages, static_cast<int>(state.page), card_width(ui));
        if (clicked >= 0) state.page = static_cast<TakePage>(clicked);
        gap(ui, 12);
        wanted = state.page == TakePage::picture ? picture_page(view, state, ui) : clip_page(view, panels, ui);
    }
    sheet_buttons(ui, sheet);
    if (!view.program.clip_progress) {
        ButtonLook look{icon::save, ui.strings("take.save"), Emphasis::primary};
        look.enabled =
            (state.page == TakePage::picture ? why_no_picture(view, state) : why_no_clip(view, state)).empty();
        if (push_button(ui, "button.clip", look,
                        ui.strings(view.program.uploads ? "take.save_page_how" : "take.save_how"))) {
            ui.outbox.emplace_back(TakeAwayRequest{wanted});
            if (!row_of(wanted.kind).is_clip) panels.sheet = Sheet::none;
        }
        ImGui::SameLine(0, ui.px(spacing::small));
    }
    const bool cancel = push_button(ui, "take.cancel", {{}, ui.strings("files.cancel"), Emphasis::quiet},
                                    ui.strings("take.cancel_how"), key_name({key::escape}, ui.strings));
    const bool beside = end_sheet(sheet);
    if (cancel || (beside && !view.program.clip_progress)) panels.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
