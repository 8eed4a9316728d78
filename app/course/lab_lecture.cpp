#include "app/course/lab_lecture.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "app/files/data.h"
#include "app/lab_reset.h"
#include "app/lab_selection.h"
#include "core/world/snapshot.h"

namespace braitenlab {

namespace {

constexpr int most_hands = 999;
constexpr std::string_view lecture_left = "notice.lecture_left";

// An open lecture without hands, and lecture mode.
void begin_pages(Lab& lab, std::shared_ptr<const Lecture> lecture) {
    if (!lab.before_lecture) begin_lecture(lab);
    std::vector<std::vector<int>> hands;
    for (const LecturePage& page : lecture->pages) hands.emplace_back(page.question.options.size(), 0);
    lab.pages = LectureView{.lecture = std::move(lecture), .hands = std::move(hands)};
    lab.lectures.left.reset(), lab.lectures.tally.reset();
    if (lab.notice.key == lecture_left) lab.notice = {};
}

// Applies the parts that are settings of the view. Panels read the others from LectureView.
void show_part(Lab& lab, PagePart part, bool shown) {
    switch (part) {
        case PagePart::trails:
            lab.view.overlays.trails = shown;
            break;
        case PagePart::sensors:
            lab.view.sensors = shown;
            break;
        case PagePart::labels:
            lab.view.overlays.labels = shown;
            break;
        case PagePart::wiring:
            lab.view.watching = shown;
            break;
        case PagePart::title:
            lab.view.revealed.title = shown;
            break;
        case PagePart::character:
            lab.view.revealed.character = shown;
            break;
        case PagePart::brain:
            lab.view.revealed.brain = shown;
            break;
        case PagePart::field: {
            const auto channels = channels_with_intensity(lab.document.session.snapshot());
            lab.view.overlays.field = shown && !channels.empty() ? std::optional(channels.front()) : std::nullopt;
            break;
        }
        default:
            break;
    }
}

// Applies the parts whose state differs between the two numbers of steps, so that others stay as the lecturer has set
// them.
void go_to_step(Lab& lab, int step) {
    const int before = std::exchange(lab.pages->step, step);
    for (const PagePartTraits& part : page_part_table) {
        const bool shown = lab.pages->shows(part.value);
        if (shown != shows(lab.pages->current(), part.value, before)) show_part(lab, part.value, shown);
    }
}

void select_vehicle(Lab& lab, const LecturePage& page) {
    if (page.select == nothing_selected) return select_none(lab);
    lab.deselected = Deselected::no;
    if (page.select.empty()) return keep_selection(lab);
    const std::vector<Start>& starts = lab.document.session.snapshot().scene->starts;
    const std::vector<VehicleView>& vehicles = lab.document.session.snapshot().vehicles;
    for (std::size_t i = 0; i < std::min(starts.size(), vehicles.size()); ++i)
        if (starts[i].name == page.select) select(lab, vehicle_object(vehicles[i].id));
}

// Shows the open scene as this page does, with so many of its steps.
void look_at_page(Lab& lab, int page, int steps) {
    const LecturePage& next = lab.pages->lecture->pages[static_cast<std::size_t>(page)];
    lab.slots = {};
    lab.view.map = lab.view.reality = false;
    lab.pages->page = page;
    lab.pages->step = std::clamp(steps, 0, static_cast<int>(next.reveal.size()));
    lab.view.camera = home_camera(lab);
    select_vehicle(lab, next);
    for (const PagePartTraits& part : page_part_table) show_part(lab, part.value, lab.pages->shows(part.value));
}

bool have_the_same_scene(const LecturePage& a, const LecturePage& b) {
    const auto is_same = [](const Setting& x, const Setting& y) { return x.path == y.path && x.value == y.value; };
    return a.file == b.file && a.seed == b.seed &&
           std::equal(a.settings.begin(), a.settings.end(), b.settings.begin(), b.settings.end(), is_same);
}

// True if the step, the first is 0, starts the run.
bool starts_the_run(const LecturePage& page, int step) {
    return page.reveal[static_cast<std::size_t>(step)][static_cast<std::size_t>(PagePart::play)];
}

}  // namespace

float lecture_growth(Rect window, float display_scale) {
    constexpr float width = 1280, height = 800, steps = 8;  // a step is an eighth: each change loads the fonts again
    const float growth = std::min(window.w / width, window.h / height) / std::max(0.1f, display_scale);
    return std::max(1.0f, std::floor(growth * steps) / steps);
}

void begin_lecture(Lab& lab) {
    lab.before_lecture = SettingsBeforeLecture{lab.preferences.theme, lab.preferences.type_size, lab.view};
    if (lab.document.edits != lab.document.saved_edits) lab.before_lecture->run_with_work = lab.document.run_id;
    lab.lectures.slots_before = without_runs(lab.slots);
    lab.preferences.theme = lab.lectures.theme;
    lab.preferences.type_size *= lecture_type;
}

bool has_edits_to_keep(const Lab& lab) {
    if (lab.pages || lab.document.edits == lab.document.saved_edits) return false;
    return !lab.before_lecture || lab.before_lecture->run_with_work == lab.document.run_id;
}

void leave_pages(Lab& lab) {
    if (!lab.pages) return;
    lab.lectures.left = std::exchange(lab.pages, std::nullopt);
    lab.lectures.left_run = 0;
}

void end_lecture(Lab& lab) {
    end_comparison(lab.slots, lab);
    const bool is_edited = lab.document.edits != lab.document.saved_edits;
    const bool nothing_to_keep = lab.pages || (is_edited && !has_edits_to_keep(lab));
    if (lab.pages) {
        leave_pages(lab);
        lab.lectures.left_run = lab.document.run_id;
        say(lab, {NoticeKind::notice, std::string(lecture_left), std::to_string(lab.lectures.left->page + 1)});
    }
    if (nothing_to_keep) {
        lab.document.saved_edits = lab.document.edits;
        lab.document.saved_tick = lab.document.session.snapshot().tick;
    }
    lab.lectures.tally.reset();
    lab.lectures.theme = lab.preferences.theme;
    lab.preferences = own_preferences(lab);
    const Selection selection = lab.view.selection;
    lab.view = lab.before_lecture->view;
    lab.view.selection = selection;
    lab.slots = std::exchange(lab.lectures.slots_before, {});
    lab.before_lecture.reset();
}

Result<Lecture> read_whole_lecture(const std::filesystem::path& path) {
    auto lecture = read_lecture(path);
    if (!lecture) return lecture;
    if (const auto error = check_pages(*lecture)) return *error;
    lecture->path = absolute_path(path);
    return lecture;
}

void open_lecture(Lab& lab, std::shared_ptr<const Lecture> lecture) {
    begin_pages(lab, std::move(lecture));
    lab.lectures.began = lab.wall_seconds;
    show_page(lab, 0);
}

void resume_lecture(Lab& lab, std::shared_ptr<const Lecture> lecture) {
    const LectureView left = *lab.lectures.left;
    const bool is_open = lab.lectures.left_run == lab.document.run_id && lab.document.edits == lab.document.saved_edits;
    begin_pages(lab, std::move(lecture));
    lab.pages->notes = left.notes;
    const auto is_as_long = [](const std::vector<int>& a, const std::vector<int>& b) { return a.size() == b.size(); };
    if (std::equal(left.hands.begin(), left.hands.end(), lab.pages->hands.begin(), lab.pages->hands.end(), is_as_long))
        lab.pages->hands = left.hands;
    const auto& pages = lab.pages->lecture->pages;
    const auto page = static_cast<std::size_t>(left.page);
    if (is_open && page < pages.size() && have_the_same_scene(pages[page], left.current()))
        look_at_page(lab, left.page, left.step);
    else
        show_page(lab, left.page, left.step);
}

void request_left_lecture(Lab& lab, bool resume) {
    if (!lab.lectures.left) return say(lab, {NoticeKind::notice, "unavailable.no_lecture"});
    lab.window.files.push_back(OpenRequest{.path = lab.lectures.left->lecture->path.string(), .resume = resume});
}

void show_page(Lab& lab, int page, int steps) {
    const auto& pages = lab.pages->lecture->pages;
    page = std::clamp(page, 0, static_cast<int>(pages.size()) - 1);
    const LecturePage& next = pages[static_cast<std::size_t>(page)];
    auto document = open_document(next.file, next.seed > 0 ? std::optional(next.seed) : std::nullopt, next.settings);
    if (!document) return say(lab, document.error());
    replace_document(lab, std::move(*document));
    look_at_page(lab, page, steps);
    if (next.play || next.at_first[static_cast<std::size_t>(PagePart::play)]) set_mode(lab, Mode::playing);
}

void begin_pages_again(Lab& lab) {
    for (std::vector<int>& of_page : lab.pages->hands) of_page.assign(of_page.size(), 0);
    lab.lectures.began = lab.wall_seconds;
    show_page(lab, 0);
    say(lab, {NoticeKind::notice, "notice.lecture_again"});
}

void next_page(Lab& lab) {
    if (!lab.pages) return;
    const LecturePage& page = lab.pages->current();
    const int step = lab.pages->step;
    if (step < static_cast<int>(page.reveal.size())) {
        go_to_step(lab, step + 1);
        if (starts_the_run(page, step) && lab.playback.mode != Mode::playing) set_mode(lab, Mode::playing);
    } else if (lab.pages->page + 1 < static_cast<int>(lab.pages->lecture->pages.size())) {
        show_page(lab, lab.pages->page + 1);
    } else {
        say(lab, {NoticeKind::notice, "notice.lecture_end"});
    }
}

void previous_page(Lab& lab) {
    if (!lab.pages) return;
    if (const int step = lab.pages->step; step > 0) {
        go_to_step(lab, step - 1);
        if (starts_the_run(lab.pages->current(), step - 1)) set_mode(lab, Mode::paused), reset(lab);
        return;
    }
    if (lab.pages->page == 0) return say(lab, {NoticeKind::notice, "notice.lecture_begin"});
    const LecturePage& page = lab.pages->lecture->pages[static_cast<std::size_t>(lab.pages->page - 1)];
    show_page(lab, lab.pages->page - 1, static_cast<int>(page.reveal.size()));
}

void switch_tally(Lab& lab) {
    auto& tally = lab.lectures.tally;
    if (lab.pages) return say(lab, {NoticeKind::notice, "unavailable.tally"});
    if (!lab.before_lecture) return;
    const bool is_covered = lab.view.map || lab.view.reality || slots_of(lab.slots, lab).seconds > 0;
    if (is_covered) return say(lab, {NoticeKind::notice, "unavailable.tally_covered"});
    tally = tally ? std::nullopt : std::optional(empty_tally(lab.lectures.tally_options));
}

void change_tally(Lab& lab, const TallyRequest& request) {
    if (!lab.lectures.tally) return;
    const std::size_t options = std::clamp(request.options, least_tally_options, most_tally_options);
    const std::vector<int> counted = lab.lectures.tally->hands.front();
    lab.lectures.tally_options = options;
    lab.lectures.tally = empty_tally(options);
    std::copy_n(counted.begin(), std::min(counted.size(), options), lab.lectures.tally->hands.front().begin());
}

void count_hands(Lab& lab, const HandsRequest& request) {
    LectureView* page = lab.pages ? &*lab.pages : lab.lectures.tally ? &*lab.lectures.tally : nullptr;
    if (!page) return;
    auto& hands = page->hands[static_cast<std::size_t>(page->page)];
    if (request.option < 0 || static_cast<std::size_t>(request.option) >= hands.size()) return;
    hands[static_cast<std::size_t>(request.option)] = std::clamp(request.hands, 0, most_hands);
}

}  // namespace braitenlab
