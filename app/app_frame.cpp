// App: one frame.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

#include <imgui.h>

#include "app/app.h"
#include "app/applied_theme.h"
#include "app/course/lab_lecture.h"
#include "app/files/data.h"
#include "app/imgui_opengl.h"
#include "app/lab_edits.h"
#include "app/lab_requests.h"
#include "app/platform/page.h"
#include "app/platform/platform.h"
#include "app/remembered.h"
#include "app/title.h"
#include "render/view/between.h"
#include "ui/panels/cards.h"
#include "ui/panels/exercise_names.h"
#include "ui/panels/panels.h"
#include "ui/panels/prompts.h"
#include "ui/widgets/drawn.h"
#include "ui/window_keys.h"

namespace braitenlab {

namespace {

// A widget pulses for this time after the last change; then its ring stays, so that a window left alone is not drawn.
constexpr double pulse_seconds = 20;

// The camera leaves room below and beside the arena for metre labels at scale 1. This leaves the additional room at
// larger scales.
Rect without_metre_labels(Rect scene, float scale) {
    constexpr float below = 16, beside = 24;  // layout pixels
    const float w = std::max(0.5f * scene.w, scene.w - 2 * beside * (scale - 1));
    return {scene.x + (scene.w - w) / 2, scene.y, w, std::max(0.5f * scene.h, scene.h - below * (scale - 1))};
}

// A title may tell the outcome of an exercise, or what a lecture asks first: until it is known, the page has the
// program's.
DocumentOnPage document_on_page(const Lab& lab, const LabView& view, const Strings& strings) {
    const Document& open = lab.document;
    DocumentOnPage on_page{.document = open.path.empty() ? "#" + std::to_string(open.run_id) : open.path.string()};
    if (lab.pages) {
        on_page.lecture = lab.pages->lecture->path.string();
        on_page.page = lab.pages->page + 1, on_page.revealed = lab.pages->step;
    }
    const bool is_hidden = hides_outcome(view) || ui::hides_titles(view);
    if (view.program.title_page || (!lab.pages && is_hidden)) return on_page;
    const std::string title = lab.pages ? lab.pages->lecture->title : title_of(lab.document);
    on_page.title = strings.find(title, title);
    return on_page;
}

// True if the user does something in this frame with the keyboard or the mouse. Call between ImGui's NewFrame and
// Render.
bool has_input(const ui::KeysOfAFrame& keys, const ImGuiIO& io) {
    if (!keys.presses.empty() || !keys.characters.empty() || keys.stroke) return true;
    if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0 || io.MouseWheelH != 0) return true;
    return std::any_of(std::begin(io.MouseDown), std::end(io.MouseDown), [](bool down) { return down; });
}

// Of an edit by keys of this frame or a moment ago, of a slider or of an object in the scene; 0: none.
std::uint64_t gesture_by_keys(const ui::PanelState& panels, double now) {
    const std::uint64_t of_slider = ui::gesture_by_keys(panels.sliders, now);
    return of_slider != 0 ? of_slider : ui::gesture_by_keys(panels.scene_input, now);
}

std::string typed_text(const ui::PanelState& panels) {
    if (!panels.sliders.typed.empty()) return panels.sliders.text;
    for (const ui::TextField* field : {&panels.sheets.files.typed, &panels.sheets.files.title,
                                       &panels.sheets.files.story, &panels.sheets.student_name, &panels.exercise.note})
        if (field->active) return field->text;
    return {};
}

}  // namespace

float App::preferred_scale() const {
    const float type = lab_.preferences.type_size;
    const float scale =
        options_.scale ? *options_.scale * type / settings_.at_start.type_size : window_.content_scale() * type;
    return frame_.magnified * scale;
}

float App::unlimited_scale() const {
    const float preferred = preferred_scale();
    if (!lab_.before_lecture) return preferred;
    return preferred * lecture_growth(window_.area(), preferred / lab_.preferences.type_size);
}

float App::wanted_scale() const {
    return ui::fitting_scale(unlimited_scale(), window_.area(), lab_.before_lecture.has_value(), window_.is_touched());
}

float App::largest_type_size_of_window() const {
    constexpr float without_limit = 1000;
    const float largest =
        ui::fitting_scale(without_limit, window_.area(), lab_.before_lecture.has_value(), window_.is_touched());
    return lab_.preferences.type_size * largest / unlimited_scale();
}

float App::reduced_type_size() const {
    const float preferred = preferred_scale();
    return theme_.scale() < preferred ? lab_.preferences.type_size * theme_.scale() / preferred : 0;
}

void App::follow_preferences() {
    if (const auto error = change_language(words_, lab_.preferences.language)) {
        lab_.preferences.language = words_.language;
        show_error(*error);
    }
    const std::tuple open{lab_.document.run_id, lab_.pages ? lab_.pages->lecture.get() : nullptr, words_.language};
    if (std::exchange(frame_.open, open) != open) leave_own_texts(words_, open_texts(lab_));
    if (theme_.apply(lab_.preferences.theme, wanted_scale())) window_.upload_fonts(), load_label_font();
}

void App::load_label_font() {
    const auto pixels = static_cast<int>(std::lround(label_em * theme_.scale()));
    auto [lettering, warning] = label_font(find_label_font, pixels, *theme_.fonts().small);
    renderer_.use_lettering(std::move(lettering));
    if (!warning.empty() && !frame_.reported_label_font) std::cerr << "braitenlab: " << warning << "\n";
    frame_.reported_label_font = true;
}

void App::follow_shaders() {
    if (seconds_since(times_.shaders_checked) < 0.5) return;
    times_.shaders_checked = Clock::now();
    if (const auto error = renderer_.follow_shaders()) complain(*error), show_error(*error);
}

LabView App::whole_view() {
    LabView view = view_of(lab_);
    view.documents.catalogue = &shipped_.scenes;
    view.documents.lectures = &shipped_.lectures;
    view.features.study.shipped = &shipped_.studies;
    view.features.breeding.shipped = &shipped_.breedings;
    view.program.languages = &words_.languages;
    view.program.native_language = settings_.native_language;
    view.program.type_size = reduced_type_size();
    view.program.largest_type_size = largest_type_size_of_window();
    view.program.quality = facts_.quality;
    view.documents.recent = &settings_.state.recent;
    view.documents.files = &files_;
    view.program.version = version_text();
    view.program.uploads = is_on_page();
    view.program.touch = window_.is_touched();
    view.program.finger = window_.finger();
    view.program.has_ffmpeg = can_write(ClipFormat::mp4);
    if (clip_) view.program.clip_progress = clip_->progress();
    if (autosave_.leftover() && autosave_.leftover()->offer.has_work)
        view.documents.recovery = &autosave_.leftover()->offer;
    view.documents.pictures = &gallery_.pictures();
    view.program.title_page = title_.has_value();
    view.camera_view = &viewport_.camera_view;
    return view;
}

void App::frame(float passed) {
    follow_preferences();
    follow_shaders();
    const ui::KeysOfAFrame keys = window_.take_keys(panels_.keyboard.text);
    window_.begin_frame(keys);
    make_pictures();
    LabView view = whole_view();
    if (is_on_page()) tell_page(document_on_page(lab_, view, words_.strings));
    take_reload_key(lab_.before_lecture.has_value());
    const Rect area = window_.area();
    const auto lay_out = [&] {
        return ui::lay_out(area.w, area.h, theme_.scale(), view, ui::open_cards(view, panels_));
    };
    ui::follow_lecture(view, panels_);  // another page folds cards: the layout is that of this page
    ui::WindowLayout layout = lay_out();
    const Rect arena = title_ ? title_area(area) : without_metre_labels(layout.scene, theme_.scale());
    constexpr float end_of_glide = 1000;  // s: the camera does not glide while the layout settles
    const float aimed = facts_.frames < frames_of_layout ? end_of_glide : passed;
    aim(viewport_, shown_lab(), area, arena, aimed, title_ ? SlotsView{} : view.features.slots, cards_of_lecture());
    frame_.outbox.clear();
    bool arrows_are_free = true;
    for (const KeyPress press : keys.presses) {
        if (!frame_.outbox.empty()) {  // a key acts on what the key before it in this frame has changed
            handle_all(lab_, std::exchange(frame_.outbox, {}));
            view = whole_view(), layout = lay_out();
        }
        arrows_are_free &= !press_key(view, panels_, press, frame_.outbox);
    }

    if (!frame_.held_back) std::swap(frame_.anchors, frame_.anchors_before);
    frame_.anchors.begin();
    frame_.written.clear(), frame_.opaque.clear();
    int shortened = 0;
    ui::Ui ui{.strings = words_.strings,
              .palette = palette(view.program.theme),
              .fonts = theme_.fonts(),
              .scale = theme_.scale(),
              .anchors = frame_.anchors,
              .outbox = frame_.outbox,
              .pulse = seconds_since(times_.change) < pulse_seconds ? ui::pulse(view) : 1,
              .written = reports_.state.wanted() ? &frame_.written : nullptr,
              .shortened = &shortened,
              .opaque = &frame_.opaque,
              .fill_clip = fill_clip_rectangle};
    ui::draw_window(view, panels_, ui, layout);
    if (bool& asked = panels_.sheets.unsaved.recovery_asked; asked && panels_.sheet != ui::Sheet::recovery)
        autosave_.pass_over(), asked = false;  // "Not now": the next one
    facts_.text = ui::text_facts(frame_.written, shortened);

    const bool keys_move_camera = view.mode != Mode::wiring && panels_.keyboard.focus.empty();
    const bool arrows_move_camera =
        arrows_are_free && !ui::takes_arrows(view, panels_.scene_input, ImGui::GetIO().KeyCtrl);
    CameraKeys held = keys_move_camera ? camera_keys(arrows_move_camera) : CameraKeys{};
    if (view.lecture) held.zoom = 0;  // Page Up and Page Down are the keys of a clicker
    if (steer_by_keys(lab_, held.turn, held.raise)) held.turn = held.raise = 0;
    window_.want_text(!ImGui::GetIO().WantTextInput ? ui::TextKind::none : ui::awaited_text(panels_));
    const float twist = window_.take_twist();
    if (twist != 0 && !title_ && !ImGui::GetIO().WantCaptureMouse && !rides(lab_.view.camera.mode))
        orbit(lab_.view.camera = viewport_.framing.raised(lab_.view.camera), -twist, 0);
    if (!title_) drive_camera(lab_, viewport_, panels_.scene_input, held, area, arena, passed);
    window_.bind();
    // The heights of cards and sheets are those of the frame before. Where they do not fit, the last frame stays.
    frame_.held_back = panels_.is_unsettled && !frame_.held_back && !options_.only_draws() && !lab_.window.screenshot;
    frame_.held_back ? ImGui::EndFrame() : ImGui::Render();
    frame_.is_drawn = !frame_.held_back;
    if (frame_.held_back || !draws_scene())
        renderer_.remember(shown_snapshot(shown_lab()));
    else
        frame_.is_drawn = draw_scene(title_ ? std::vector<bool>{} : hidden_brains(view));
    const ImGuiIO& io = ImGui::GetIO();
    frame_.got_input = has_input(keys, io) || held;
    ++facts_.frames;
    facts_.pictures += frame_.is_drawn;
    facts_.pointer = ImGui::IsMousePosValid() ? maths::vec2{io.MousePos.x, io.MousePos.y} : maths::vec2{-1, -1};
    facts_.pressed = io.MouseDown[0] ? 1 : io.MouseDown[2] ? 2 : io.MouseDown[1] ? 3 : 0;
    facts_.focus = panels_.keyboard.focus;
    facts_.menu = panels_.menu_bar.open;
    facts_.typed = typed_text(panels_);
    facts_.probes.assign(panels_.canvas.probes.begin(), panels_.canvas.probes.end());
    facts_.strips = panels_.charts.strips;
    window_.bind();
    if (frame_.is_drawn) window_.draw_widgets();
    note_press(lab_.predictions, lab_, io.MouseDown[0], gesture_by_keys(panels_, lab_.wall_seconds));
    lab_.predictions.what_if = panels_.brain.what_if;
    lab_.map.hovered = panels_.map.hovered;
    lab_.robots.hovered = panels_.reality.hovered;
    handle_all(lab_, frame_.outbox);
    if (std::exchange(lab_.window.begins, false)) begin();
}

void App::make_pictures() {
    frame_.makes_pictures = false;
    if (panels_.sheet != ui::Sheet::files || panels_.sheets.files.saving) return;
    std::vector<std::string> files;
    if (panels_.sheets.files.place == ui::FilesPlace::shipped)
        files = files_by_turns(shipped_.scenes);
    else if (panels_.sheets.files.place == ui::FilesPlace::recent)
        for (const RecentFile& file : settings_.state.recent) files.push_back(file.path);
    else
        for (const FileEntry& entry : files_.listing.entries)
            if (!entry.is_folder && !entry.broken &&
                (entry.kind == FileKind::scene || entry.kind == FileKind::exercise))
                files.push_back((std::filesystem::path(files_.listing.folder) / entry.name).string());
    frame_.makes_pictures = gallery_.make_next(renderer_, files, lab_.preferences.theme);
}

// Switches of the view outlast the program; a person who has not switched them off misses what they show.
void App::tell_what_is_off() {
    std::string names;
    for (const Action action : switched_off(lab_.view))
        names += (names.empty() ? "" : ", ") + std::string(words_.strings("action." + std::string(name(action))));
    if (!names.empty()) say(lab_, {NoticeKind::notice, "notice.switched_off", names});
}

void App::begin() {
    title_.reset();
    viewport_ = {};
    tell_what_is_off();
}

CameraKeys App::camera_keys(bool arrows_are_free) const {
    if (ImGui::GetIO().WantTextInput) return {};
    const auto held = [this](Action action) {
        for (const Shortcut& shortcut : shortcuts())
            if (shortcut.action == action && shortcut.press.shift == ImGui::GetIO().KeyShift &&
                window_.holds(shortcut.press.key))
                return 1.0f;
        return 0.0f;
    };
    CameraKeys keys{.zoom = held(Action::zoom_in) - held(Action::zoom_out)};
    if (!arrows_are_free) return keys;
    keys.turn = held(Action::turn_right) - held(Action::turn_left);
    keys.raise = held(Action::raise) - held(Action::lower);
    keys.pan = {held(Action::pan_right) - held(Action::pan_left), held(Action::pan_up) - held(Action::pan_down)};
    return keys;
}

Picture App::scene_picture(std::vector<bool> hidden_brains) const {
    const Lab& lab = shown_lab();
    Picture picture;
    picture.hidden_brains = std::move(hidden_brains);
    picture.theme = lab.preferences.theme;
    picture.quality = quality();
    picture.settings = lab.view;
    if (lab.together && lab.together->worlds.size() > 1)
        picture.settings.sensors = false;  // ten fields in one place would cover the vehicles
    picture.driver = lab.view.camera.mode == CameraMode::driver ? lab.view.selection.vehicle : no_vehicle;
    picture.reduce_motion = lab.preferences.reduce_motion;
    picture.pixel_scale = theme_.scale();
    picture.names = &words_.names;
    picture.decimal_mark = decimal_mark(words_.strings);
    return picture;
}

std::vector<Rect> App::cards_of_lecture() const {
    std::vector<Rect> places;
    if (!lab_.before_lecture || title_) return places;
    for (const ui::CardTraits& row : ui::cards())
        if (const Rect* card = frame_.anchors.find(row.anchor)) places.push_back(*card);
    return places;
}

bool App::may_stay() {
    const bool is_lost = window_.take_loss_of_picture(), is_redirected = window_.is_redirected();
    const auto widgets = moves() || is_redirected ? std::nullopt : ui::hash_of_drawn(*ImGui::GetDrawData());
    const auto before = std::exchange(frame_.widgets, widgets);
    return widgets && widgets == before && !is_lost && !options_.only_draws() && !lab_.window.screenshot;
}

bool App::draw_scene(std::vector<bool> hidden_brains) {
    const Lab& lab = shown_lab();
    Picture picture = scene_picture(std::move(hidden_brains));
    picture.may_stay = may_stay();
    picture.camera_view = viewport_.camera_view;
    picture.camera_view.window = window_.area();
    if (!title_) {
        picture.covered = frame_.opaque;
        const auto& labels = panels_.scene_input.labels.labels();
        picture.covered.insert(picture.covered.end(), labels.begin(), labels.end());
        picture.opaque = frame_.opaque;
    }
    const SceneObject& hovered = panels_.scene_input.hovered.object;
    picture.resolution = resolution();
    picture.coarse_ground = picture.quality == Quality::low && !repeatable() && !window_.is_redirected();
    picture.hovered = hovered.kind == SceneObjectKind::vehicle ? hovered.index : no_vehicle;
    frame_.shown = shown_snapshot(lab);
    if (!repeatable()) render::stand_between(frame_.shown, lab.playback.previous, between_ticks(lab));
    const bool is_drawn = draw_measured(std::move(picture));
    facts_.draw_calls = renderer_.draw_calls();
    facts_.camera_view = viewport_.camera_view;
    facts_.hand = ImGui::GetMouseCursor() == ImGuiMouseCursor_Hand;
    facts_.graphics_watched = window_.watches_graphics();
    facts_.graphics_errors = window_.graphics_errors();
    return is_drawn;
}

Quality App::quality() const { return lab_.preferences.quality.value_or(quality_.choice.level()); }

float App::resolution() const {
    return lab_.preferences.quality || window_.is_redirected() ? 1 : quality_.choice.resolution();
}

bool App::draw_measured(Picture picture) {
    if (quality_.of != shown_lab().document.name) quality_.choice.start_over(), quality_.of = shown_lab().document.name;
    const bool due = !lab_.preferences.quality && quality_.choice.measures(facts_.frames, renderer_.reused());
    picture.copied_at_rest = !repeatable() && !due;
    if (due) renderer_.finish();  // what is still to be drawn is not part of the measurement
    const auto began = Clock::now();
    const bool is_drawn = renderer_.draw(frame_.shown, picture);
    if (due) renderer_.finish(), quality_.choice.add(seconds_since(began));
    facts_.quality = picture.quality, facts_.resolution = renderer_.resolution();
    return is_drawn;
}

}  // namespace braitenlab
