// In the smallest supported window, no text of any language is clipped, leaves the window or overlaps other text.
#include <functional>
#include <regex>

#include "breeding_on_desk.h"
#include "core/brain/presets.h"
#include "core/insight/study.h"
#include "core/scene/file_kind.h"
#include "desk.h"
#include "ui/widgets/paint.h"

namespace braitenlab::tests::words_fit_test {

using namespace ui;

namespace {

struct Screen {
    const char* name;
    std::function<void(Desk&)> set;
};

void with_lesson(Desk& desk) { desk.open_exercise(); }

// As the check of an exercise of one's own and the reader of a broken file find them.
void with_findings(Desk& desk) {
    static const std::vector<Finding> found = [] {
        const std::string file = "/home/student/braitenlab/exercises/a strike of mine.toml";
        std::vector<Finding> all(3);
        all[0].said = {NoticeKind::failure, "findings.not_offered", "LR"};
        all[1].said = {NoticeKind::failure, "findings.start_fails", "3", "1. It touches the lamp"};
        all[1].measures = {{.value = 1.25f, .needed = 0.6f, .unit = "m", .at_most = true, .best = true}};
        const Error outside{"'lamp' is at (30, 0), outside the arena of 12 × 12 m; move it inside", file, 41};
        all[2].said = {.kind = NoticeKind::notice, .words = outside.text(), .error = outside};
        return all;
    }();
    with_lesson(desk);
    desk.view.findings = &found;
}

void late_in_lesson(Desk& desk) {
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true;
    desk.lesson.attempt.answers.prediction = 1;
    desk.lesson.attempt.answers.hints_shown = 3;
    desk.panels.exercise.why_open = true;
    desk.lesson.grade = graded({true, false, true, true, true, true, true, true, true, true}, true);
    for (Verdict& verdict : desk.lesson.verdicts) verdict.done = true;
}

// A lamp, a box and a triangle in a scene for the mouse.
void with_objects(Desk& desk) {
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    Obstacle triangle;
    triangle.corners = {{-1, -1}, {1, -1}, {0, 1}};
    scene->sources.resize(1), scene->obstacles = {Obstacle{}, triangle};
    scene->zones = {Zone{.surface = Surface::tape}, Zone{.corners = triangle.corners}};
    desk.now.scene = scene;
    desk.now.sources.resize(1);
    for (const Kind& kind : scene->kinds) desk.now.kind_brains.push_back(std::make_shared<BrainGraph>(kind.brain));
    static CameraView camera_view;
    camera_view = look(Camera{}, scene->arena, nullptr, desk.layout.window, desk.layout.scene);
    desk.view.camera_view = &camera_view;
}

void with_menu(Desk& desk, SceneObject object, MenuPage page) {
    with_objects(desk);
    SceneInputMenu& menu = desk.panels.scene_input.menu;
    menu.open = true;
    menu.object = object;
    menu.page = page;
    menu.at = {9999, 9999};  // in the corner with the least space
}

// The card of the kinds with every part unfolded.
void with_kinds(Desk& desk) {
    desk.view.settings.values = true;
    ValuesState& values = desk.panels.values;
    values.kinds = values.body_open = values.realism_open = values.memory_open = values.lamps_open = values.path_open =
        true;
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds[0].waypoints = {{1, 2}, {-3.25f, 4}};
    scene->kinds[0].lamps.resize(1);
    desk.now.scene = scene;
}

const CatalogueEntry catalogue_entries[]{
    {"05-aggressor", "5.toml", "Aggressor", "", 5},
    {"predator-prey", "p.toml", "Predators and prey", "Drag a weight and the hunt changes."}};

void with_slots(Desk& d) {
    static const insight::Design design;
    static const insight::CompareNumbers a{0.4f, 5.3f, 0.5f, 27.4f, 13}, b{13.1f, INFINITY, 19.5f, 112.2f, NAN};
    d.view.features.slots.seconds = 30;
    for (SlotView& slot : d.view.features.slots.slots) slot.design = &design, slot.character = Character::aggressor;
    d.view.features.slots.slots[0].numbers = &a, d.view.features.slots.slots[1].numbers = &b;
}

void with_chart(Desk& desk, Chart chart) {
    desk.now.tick = 600, desk.now.seconds = 10;
    desk.panels.charts.open = true;
    desk.panels.charts.shown = chart;
}

// The sheet that saves the scene as an exercise.
void with_author(Desk& desk, AuthorPage page);
void with_robot(Desk& desk, const char* robot);

const RecoveryOffer offer{
    "Predator and prey",
    "/home/student/Documents/braitenlab/experiments/second-series/winter/predator-prey-second.toml",
    "2026-03-01 10:42:05"};

FilesView files;
void with_files(Desk& desk) {
    files = {};
    files.listing = {
        "/home/student/Braitenberg", {{"pictures", true}, {"a hunt of mine.toml", false, FileKind::scene, true}}, ""};
    files.suggested = "2a-coward";
    desk.view.documents.files = &files;
}

std::vector<Screen> screens() {
    return {
        {"hunt", [](Desk&) {}},
        {"hunt, playing", [](Desk& d) { d.view.mode = Mode::playing; }},
        {"hunt, following",
         [](Desk& d) { d.view.mode = Mode::playing, d.view.settings.camera.mode = CameraMode::follow; }},
        {"no vehicle selected", [](Desk& d) { d.view.settings.selection.vehicle = no_vehicle; }},
        {"hunt, wiring", [](Desk& d) { d.view.mode = Mode::wiring; }},
        {"keys", [](Desk& d) { d.key({key::f1}); }},
        {"settings",
         [](Desk& d) {
             d.key({',', true});
         }},
        {"exercise, fresh", with_lesson},
        {"exercise, late", late_in_lesson},
        {"exercise, wiring", [](Desk& d) { with_lesson(d), d.view.mode = Mode::wiring; }},
        {"what can be opened",
         [](Desk& d) {
             static const std::vector<CatalogueEntry> catalogue(std::begin(catalogue_entries),
                                                                std::end(catalogue_entries));
             d.view.documents.catalogue = &catalogue, d.key({'O', true});
         }},
        {"presets", [](Desk& d) { d.click("button.presets"); }},
        {"a lamp",
         [](Desk& d) {
             with_objects(d), d.view.settings.selection.object = {SceneObjectKind::source, 0};
         }},
        {"a box",
         [](Desk& d) {
             with_objects(d), d.view.settings.selection.object = {SceneObjectKind::obstacle, 0};
         }},
        {"a triangle",
         [](Desk& d) {
             with_objects(d), d.view.settings.selection.object = {SceneObjectKind::obstacle, 1};
         }},
        {"a zone",
         [](Desk& d) {
             with_objects(d), d.view.settings.selection.object = {SceneObjectKind::zone, 0};
         }},
        {"a polygon of a zone",
         [](Desk& d) {
             with_objects(d), d.view.settings.selection.object = {SceneObjectKind::zone, 1};
         }},
        {"several objects",
         [](Desk& d) {
             with_objects(d), d.view.settings.selection.object = {SceneObjectKind::zone, 0};
             d.view.settings.selection.more = {{SceneObjectKind::source, 0}, vehicle_object(0)};
         }},
        {"menu of a zone",
         [](Desk& d) {
             with_menu(d, {SceneObjectKind::zone, 0}, MenuPage::top);
         }},
        {"menu of the floor", [](Desk& d) { with_menu(d, {}, MenuPage::top); }},
        {"menu of a vehicle", [](Desk& d) { with_menu(d, vehicle_object(0), MenuPage::top); }},
        {"menu of brains", [](Desk& d) { with_menu(d, vehicle_object(0), MenuPage::brains); }},
        {"file menu", [](Desk& d) { with_files(d), d.panels.menu_bar.open = "file"; }},
        {"edit menu", [](Desk& d) { d.panels.menu_bar.open = "edit"; }},
        {"view menu", [](Desk& d) { d.key({'E'}); }},
        {"simulation menu", [](Desk& d) { d.panels.menu_bar.open = "simulation"; }},
        {"exercises menu",
         [](Desk& d) {
             static const std::vector<CatalogueEntry> catalogue(std::begin(catalogue_entries),
                                                                std::end(catalogue_entries));
             d.view.documents.catalogue = &catalogue, d.panels.menu_bar.open = "exercises";
         }},
        {"lecture menu", [](Desk& d) { d.panels.menu_bar.open = "lecture"; }},
        {"help menu", [](Desk& d) { d.panels.menu_bar.open = "help"; }},
        {"about", [](Desk& d) { d.view.program.version = "0.1.0", d.panels.sheet = Sheet::about; }},
        {"glossary", [](Desk& d) { d.panels.sheet = Sheet::glossary; }},
        {"a term of the glossary",
         [](Desk& d) {
             const std::string_view forms = d.strings.find("glossary.curve.forms", "");
             with_lesson(d), d.opened.goal = forms.substr(0, forms.find(','));
             d.frame(2), d.click("term.curve");
         }},
        {"children",
         [](Desk& d) {
             with_lesson(d), d.lesson.attempt.answers.prediction = 0;
             const StartResult run{1, false, {}, {{0, 0}, {1, 1}}, 12.5f};
             d.lesson.selection = SelectionView{.generation = 12, .parent = run, .children = {9, run}};
             d.panels.sheet = Sheet::children;
         }},
        {"study",
         [](Desk& d) {
             static const std::filesystem::path folder = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises";
             static const auto path = folder / "studies" / "weight-and-mismatch.toml";
             static const std::vector<insight::Study> studies{*insight::parse_study(*read_text(path), path.string())};
             static const std::vector<insight::StudyRow> rows(300, {12.5, 0.65});
             d.view.features.study.shipped = &studies, d.view.features.study.rows = &rows;
             d.view.features.study.base = *insight::StudyBase::create(
                 studies.front(), *read_text(folder / "scenes" / "2b-aggressor.toml"), "scene");
             d.panels.sheet = Sheet::study;
         }},
        {"breeding",
         [](Desk& d) {
             static BredOnDesk bred(41, 2);
             bred.show(d), bred.watch(d, {38, 36}, {40, 0});
         }},
        {"breeding, not begun",
         [](Desk& d) {
             static BredOnDesk bred(0);
             bred.show(d), d.view.features.breeding.runs = true;
         }},
        {"a picture to save", [](Desk& d) { d.panels.sheet = Sheet::take; }},
        {"a clip to save",
         [](Desk& d) {
             d.panels.sheet = Sheet::take, d.panels.sheets.take.page = TakePage::clip, d.view.timeline.latest = 900;
         }},
        {"no clip to save",
         [](Desk& d) {
             d.panels.sheet = Sheet::take, d.panels.sheets.take.page = TakePage::clip, d.view.timeline = {};
         }},
        {"a clip that is written", [](Desk& d) { d.panels.sheet = Sheet::take, d.view.program.clip_progress = 0.99f; }},
        {"exercise, not from every start",
         [](Desk& d) {
             late_in_lesson(d);
             d.lesson.grade = graded({true, false, false}, false);
         }},
        {"exercise, graded now",
         [](Desk& d) { late_in_lesson(d), d.lesson.grade.reset(), d.lesson.standing.starts_tested = 4; }},
        {"exercise, on the way",
         [](Desk& d) {
             with_lesson(d), d.lesson.attempt.work.has_run = true, d.lesson.attempt.answers.prediction = 0,
                             d.now.seconds = 90;
         }},
        {"mystery brain", [](Desk& d) { d.view.features.mystery.rebuilt = 0, d.panels.sheet = Sheet::mystery; }},
        {"mystery brain, score",
         [](Desk& d) {
             static const insight::MysteryScore score{
                 .score = 100, .gap = 10.25f, .random_gap = 12.15f, .starts = {10, insight::MysteryStart{}}};
             d.view.features.mystery = {.hidden = 1, .rebuilt = 0, .score = &score, .scene = d.now.scene.get()};
             d.panels.sheet = Sheet::mystery;
         }},
        {"slots A and B", with_slots},
        {"slots A and B in a lecture", [](Desk& d) { with_slots(d), d.view.lecture = true; }},
        {"sensors", [](Desk& d) { d.panels.card(Card::sensors).folded = false, d.panels.sensors.quality_open = true; }},
        {"values of the arena", [](Desk& d) { d.view.settings.values = true; }},
        {"values of the arena in an exercise", [](Desk& d) { with_lesson(d), d.view.settings.values = true; }},
        {"values of the kinds", with_kinds},
        {"values of the kinds, further down",
         [](Desk& d) {
             with_kinds(d);
             d.panels.values.body_open = d.panels.values.realism_open = d.panels.values.memory_open = false;
         }},
        {"signals", [](Desk& d) { with_chart(d, Chart::signals); }},
        {"population", [](Desk& d) { with_chart(d, Chart::population); }},
        {"energy", [](Desk& d) { with_chart(d, Chart::energy); }},
        {"neurons", [](Desk& d) { with_chart(d, Chart::all); }},
        {"chosen signals",
         [](Desk& d) {
             with_chart(d, Chart::chosen), d.panels.charts.strips = {"SL", "MR"};
         }},
        {"no chosen signals", [](Desk& d) { with_chart(d, Chart::chosen); }},
        {"everybody's energy", [](Desk& d) { with_chart(d, Chart::bars); }},
        {"driven by hand", [](Desk& d) { d.now.vehicles[0].driver = Driver::manual; }},
        {"on a path", [](Desk& d) { d.now.vehicles[0].driver = Driver::path; }},
        {"wandering", [](Desk& d) { d.now.vehicles[0].driver = Driver::wander; }},
        {"findings of a check", with_findings},
        {"lecture on a hunt", [](Desk& d) { d.view.lecture = true; }},
        {"lecture on an exercise", [](Desk& d) { with_lesson(d), d.view.lecture = true; }},
        {"after a crash", [](Desk& d) { d.view.documents.recovery = &offer; }},
        {"saving",
         [](Desk& d) {
             with_files(d), d.key({'S', true, true});
         }},
        {"replacing",
         [](Desk& d) {
             with_files(d), d.key({'S', true, true}), d.frame(2);
             d.panels.sheets.files.typed.text = d.panels.sheets.files.replacing = "a hunt of mine.toml";
         }},
        {"creating a folder",
         [](Desk& d) {
             with_files(d), d.key({'S', true, true}), d.frame(2);
             d.panels.sheets.files.typed.text = d.panels.sheets.files.creating = "new/mine.toml";
             d.panels.sheets.files.asked = true, files.new_folder = "/home/student/braitenlab/experiments/new";
         }},
        {"settings in a small window",
         [](Desk& d) {
             d.view.program.preferences.type_size = 2, d.view.program.type_size = 1.125f;
             d.key({',', true});
         }},
        {"no vehicle to follow",
         [](Desk& d) {
             d.view.notice = {NoticeKind::failure, "notice.no_vehicle"};
         }},
        {"a death without a successor",
         [](Desk& d) {
             d.view.notice = {NoticeKind::notice, "notice.starved_none_alone", "20000"};
         }},
        {"a folder",
         [](Desk& d) {
             with_files(d), d.key({'O', true}), d.panels.sheets.files.place = FilesPlace::folder;
         }},
        {"opened lately",
         [](Desk& d) {
             with_files(d), d.key({'O', true}), d.panels.sheets.files.place = FilesPlace::recent;
         }},
        {"unsaved, opening",
         [](Desk& d) {
             with_files(d), files.leaving = Leaving{"Vehicle 2a: Coward", "/y/mine.toml", "Predator and prey"};
         }},
        {"author, texts", [](Desk& d) { with_author(d, AuthorPage::texts); }},
        {"author, controls", [](Desk& d) { with_author(d, AuthorPage::controls); }},
        {"author, steps", [](Desk& d) { with_author(d, AuthorPage::steps); }},
        {"author, goals", [](Desk& d) { with_author(d, AuthorPage::steps), d.panels.sheets.author.goals_open = true; }},
        {"author, prediction", [](Desk& d) { with_author(d, AuthorPage::prediction); }},
        {"robot", [](Desk& d) { with_robot(d, "tt2wd-ldr"); }},
        {"robot, refused", [](Desk& d) { with_robot(d, "lm324"); }},
        {"unsaved, leaving", [](Desk& d) { with_files(d), files.leaving = Leaving{"Vehicle 2a: Coward"}; }},
    };
}

void with_author(Desk& desk, AuthorPage page) {
    with_files(desk);
    desk.now = shipped_scene("2a-coward");
    begin_author(desk.view, desk.panels.sheets.author);
    desk.panels.sheets.author.page = page;
    desk.panels.sheet = Sheet::author;
}

void with_robot(Desk& desk, const char* robot) {
    with_files(desk);
    desk.now = shipped_scene("4b-decision");
    desk.panels.sheets.robot.robot = robots::find_robot(robot);
    desk.panels.sheet = Sheet::robot;
}

bool is_icon(const std::string& words) { return !words.empty() && static_cast<unsigned char>(words[0]) == 0xEF; }

float overlap_along(float a, float a_size, float b, float b_size) {
    return std::min(a + a_size, b + b_size) - std::max(a, b);
}

// Letters use the middle of their line: lines may touch, letters may not.
bool collide(const Written& a, const Written& b) {
    if (a.sheet != b.sheet) return false;
    const float across = overlap_along(a.rect.x, a.rect.w, b.rect.x, b.rect.w);
    const float down = overlap_along(a.rect.y, a.rect.h, b.rect.y, b.rect.h);
    return across > -2.5f && down > 0.4f * std::min(a.rect.h, b.rect.h);
}

bool cut_across(const Written& w) {
    return w.rect.x < w.clip.x - 0.75f || w.rect.x + w.rect.w > w.clip.x + w.clip.w + 0.75f;
}

void expect_words_to_fit(const Desk& desk, const std::string& where) {
    for (std::size_t i = 0; i < desk.written.size(); ++i) {
        const Written& w = desk.written[i];
        if (is_icon(w.words)) continue;
        EXPECT_FALSE(cut_across(w)) << where << ": '" << w.words << "' is cut";
        EXPECT_TRUE(w.rect.x >= 0 && w.rect.x + w.rect.w <= desk.layout.window.w + 0.75f)
            << where << ": '" << w.words << "' leaves the window";
        for (std::size_t j = 0; j < i; ++j) {
            if (is_icon(desk.written[j].words)) continue;
            EXPECT_FALSE(collide(w, desk.written[j]))
                << where << ": '" << w.words << "' overlaps '" << desk.written[j].words << "'";
        }
    }
}

}  // namespace

class EveryLanguage : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryLanguage, FitsTheSmallestWindow) {
    for (const auto& [width, height] : {std::pair{1024, 768}, std::pair{800, 600}})
        for (const Screen& screen : screens()) {
            Desk desk(static_cast<float>(width), static_cast<float>(height), 1, true);
            desk.strings = speaking(GetParam());
            desk.frame(3);
            screen.set(desk);
            desk.frame(5);
            EXPECT_GT(desk.written.size(), 8u) << "the frame has text";
            expect_words_to_fit(desk, screen.name + std::string(" at ") + std::to_string(width));
        }
}

TEST_P(EveryLanguage, ShowsEveryPresetWholeInTheSmallestWindow) {
    Desk desk(800, 600, 1, true);
    desk.strings = speaking(GetParam());
    desk.frame(3);
    desk.click("button.presets");
    desk.frame(5);
    for (const Preset& preset : presets()) {
        const Rect row = desk.where("preset." + std::string(preset.name));
        EXPECT_TRUE(row.x >= 0 && row.x + row.w <= 800 && row.y >= 0 && row.y + row.h <= 600) << preset.name;
    }
    for (const char* button : {"preset.load", "preset.save"}) {
        const Rect at = desk.where(button);
        EXPECT_TRUE(at.x >= 0 && at.x + at.w <= 800 && at.y + at.h <= 600) << button;
    }
    expect_words_to_fit(desk, "presets");
}

TEST_P(EveryLanguage, FitsAtTwiceTheSize) {
    for (const Screen& screen : screens()) {
        Desk desk(2048, 1536, 2, true);
        desk.strings = speaking(GetParam());
        desk.frame(3);
        screen.set(desk);
        desk.frame(5);
        expect_words_to_fit(desk, screen.name);
    }
}

// The sheets of a study, of a breeding, of hidden brains and of a selection by hand have tables and pictures that are
// wider than a telephone, and a lecture is shown on a large display.
bool needs_a_tablet(std::string_view screen) {
    constexpr std::string_view wide[]{"study",    "breeding",   "mystery",
                                      "children", "lecture on", "slots A and B in a lecture"};
    return std::any_of(std::begin(wide), std::end(wide), [&](auto stem) { return screen.starts_with(stem); });
}

// With controls as high as a finger needs: on a tablet, and on an upright telephone with its smallest and largest type.
TEST_P(EveryLanguage, FitsAFinger) {
    struct Glass {
        float width, height, finger;
    };
    for (const Glass glass : {Glass{1024, 768, 44}, Glass{512, 1024, 56}, Glass{410, 820, 45}})
        for (const Screen& screen : screens()) {
            if (glass.width < 600 && needs_a_tablet(screen.name)) continue;
            Desk desk(glass.width, glass.height, 1, true);
            desk.strings = speaking(GetParam());
            desk.view.program.touch = true, desk.view.program.finger = glass.finger;
            desk.frame(3);
            screen.set(desk);
            desk.frame(5);
            expect_words_to_fit(desk, std::to_string(static_cast<int>(glass.width)) + " " + screen.name);
        }
}

TEST_P(EveryLanguage, FitsTheBrainCardInALecture) {
    for (const char* name : {"2b-aggressor", "3c-values"}) {
        Desk desk(1024, 1400, 1.4f, true);  // high, so that nothing of the card is scrolled away
        desk.strings = speaking(GetParam());
        desk.now = shipped_scene(name);
        desk.view.lecture = true;
        desk.frame(3);
        desk.panels.card(Card::brain).folded = false;
        desk.frame(5);
        ASSERT_TRUE(desk.anchors.find("brain.picture"));
        expect_words_to_fit(desk, name);
    }
}

// Numbers have the decimal mark of the language. Names of files and the version are no numbers.
TEST_P(EveryLanguage, ShowsNumbersWithItsDecimalMark) {
    const bool has_comma = GetParam() != "en";
    const std::regex with_point("[0-9]\\.[0-9]"), with_comma("[0-9],[0-9]");
    int numbers = 0;
    for (const Screen& screen : screens()) {
        Desk desk(1280, 1200, 1, true);
        desk.strings = speaking(GetParam());
        desk.frame(3);
        screen.set(desk);
        desk.view.program.version = {};
        desk.now.inactivity_left = 12.5f;
        desk.frame(5);
        for (const Written& w : desk.written) {
            if (screen.name == std::string("about")) continue;
            EXPECT_FALSE(std::regex_search(w.words, has_comma ? with_point : with_comma))
                << screen.name << ": " << w.words;
            numbers += std::regex_search(w.words, has_comma ? with_comma : with_point);
        }
    }
    EXPECT_GT(numbers, 200);
}

// All texts of prompts, modes, tools and notices in the bar below the scene: whole, in one line or two.
TEST_P(EveryLanguage, ShowsEveryMessageOfTheBarWhole) {
    Desk desk(800, 600, 1, true);
    desk.strings = speaking(GetParam());
    desk.frame(3);
    const auto expect_whole = [&](const std::string& key) {
        expect_words_to_fit(desk, key);
        EXPECT_FALSE(desk.anchors.find("hint.whole") || desk.anchors.find("hint.notice")) << key << " is cut";
        const Rect bar = desk.layout.hint_bar;
        for (const Written& w : desk.written)
            EXPECT_TRUE(w.rect.y >= bar.y - 1 && w.rect.y + w.rect.h <= bar.y + bar.h + 1) << key << ": " << w.words;
    };
    int hints = 0, notices = 0;
    for (const auto& [key, words] : desk.strings.all()) {
        if (!key.starts_with("hint.") && !(key.starts_with("tools.") && key.ends_with("_how"))) continue;
        ++hints;
        desk.show_hint(key);
        expect_whole(key);
    }
    for (const auto& [key, words] : desk.strings.all()) {
        if (!key.starts_with("notice.")) continue;
        ++notices;
        desk.view.notice = {NoticeKind::notice, key, "a hunt of mine.toml", "12.5"};
        desk.show_hint("");
        expect_whole(key);
    }
    EXPECT_GT(hints, 30);
    EXPECT_GT(notices, 50);
}

TEST_P(EveryLanguage, ShowsTheLabelOfEachFieldBesideItsSlider) {
    Desk desk(1024, 768, 1, true);
    desk.frame();
    const Strings strings = speaking(GetParam());
    Ui ui{strings, palette(Theme::dark), test_fonts(1).loaded.fonts, 1, desk.anchors, desk.asked, {}, 1};
    FieldsState fields;
    SliderState sliders;
    const float room = FieldRows{ui, fields, sliders}.words_width;
    int labels = 0;
    for (const auto& [key, words] : strings.all()) {
        if (!key.starts_with("field.") || !strings.all().count(key + "_how")) continue;
        ++labels;
        EXPECT_LT(text_width(ui, Face::text, words), room) << key << " = " << words;
    }
    EXPECT_GT(labels, 30);
}

INSTANTIATE_TEST_SUITE_P(Languages, EveryLanguage, ::testing::ValuesIn(shipped_codes()),
                         [](const auto& given) { return given.param; });

TEST(WordsFit, DetectsTextThatDoesNotFit) {
    Desk desk(1024, 768, 1, true);
    std::string words;
    for (int i = 0; i < 100; ++i) words += "WW ";
    auto endless = Strings::parse("format = 1\n[hint]\npress_play = \"" + words + "\"\n", "test.toml");
    ASSERT_TRUE(endless);
    endless->fall_back_on(english());
    desk.strings = *endless;
    desk.frame(3);
    const auto hint = std::find_if(desk.written.begin(), desk.written.end(),
                                   [](const Written& w) { return w.words.starts_with("WW"); });
    ASSERT_NE(hint, desk.written.end());
    EXPECT_FALSE(cut_across(*hint)) << "the hint bar leaves out what does not fit";
    Written whole = *hint;
    whole.rect.w = 200 * whole.size;
    EXPECT_TRUE(cut_across(whole));
}

}  // namespace braitenlab::tests::words_fit_test
