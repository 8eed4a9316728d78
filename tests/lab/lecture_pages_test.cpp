// Lecture files in the lab: every shipped page opens and shows its steps; pages begin anew; nothing is asked to be
// saved.
#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include <gtest/gtest.h>

#include "app/course/lab_lecture.h"
#include "app/course/lesson_view.h"
#include "app/files/data.h"
#include "app/files/file_commands.h"
#include "app/lab_requests.h"
#include "app/playback.h"
#include "core/maths/angle.h"
#include "opened_lab.h"
#include "tests/folder.h"
#include "ui/panels/actions.h"
#include "ui/window.h"
#include "ui/window_keys.h"

namespace braitenlab::tests::lecture_pages_test {
namespace {

struct LabLecturePages : testing::Test {
    Folder folder;
    FilesView files;
    StoredState state;
    UserFolders folders{.home = folder.path, .pictures = folder / "Pictures"};
    Lab lab = opened_lab("2a-coward");

    void ask(const Request& request) {
        handle(lab, request);
        execute_file_requests(lab, files, state, folders);
    }
    void open(const char* name) { ask(OpenRequest{find_shipped(name)->string()}); }
    void press(KeyPress key) {
        ui::PanelState panels;
        Outbox outbox;
        ui::press_key(view_of(lab), panels, key, outbox);
        for (const Request& request : outbox) handle(lab, request);
    }
    static std::size_t opened_pages(const char* name) { return read_whole_lecture(*find_shipped(name))->pages.size(); }
    // The first Esc says that a second one leaves.
    void leave_by(int leave) {
        press({leave});
        if (leave == key::escape) press({leave});
    }
};

TEST_F(LabLecturePages, EveryShippedLectureGoesThroughAllPagesAndSteps) {
    ASSERT_EQ(shipped_lectures().size(), 3u);
    for (const auto& path : shipped_lectures()) {
        SCOPED_TRACE(path.string());
        ask(OpenRequest{path.string()});
        ASSERT_TRUE(lab.pages);
        EXPECT_EQ(lab.pages->page, 0);
        const auto lecture = lab.pages->lecture;
        for (std::size_t i = 0; i < lecture->pages.size(); ++i) {
            const LecturePage& page = lecture->pages[i];
            SCOPED_TRACE(page.caption);
            ASSERT_EQ(lab.pages->page, static_cast<int>(i));
            EXPECT_EQ(lab.document.path, absolute_path(page.file));
            EXPECT_EQ(lab.document.session.snapshot().tick, 0u) << "each page begins anew";
            EXPECT_EQ(lab.playback.mode == Mode::playing, page.play);
            for (std::size_t step = 0; step < page.reveal.size(); ++step) {
                press({key::page_down});
                ASSERT_EQ(lab.pages->step, static_cast<int>(step) + 1);
                for (int tick_count = 0; tick_count < 30; ++tick_count) tick(lab);
            }
            for (std::size_t part = 0; part < page_part_table.size(); ++part)
                for (const PageParts& revealed : page.reveal)
                    EXPECT_TRUE(!revealed[part] || lab.pages->shows(static_cast<PagePart>(part)));
            EXPECT_TRUE(lab.notice.empty()) << lab.notice.words << lab.notice.key;
            press({key::page_down});
        }
        EXPECT_EQ(lab.pages->page, static_cast<int>(lecture->pages.size()) - 1) << "the last page stays";
    }
}

TEST_F(LabLecturePages, AStepStartsTheRunAndShowsOverlaysOnce) {
    open("four-numbers");
    press({key::page_down});
    ASSERT_EQ(lab.pages->page, 1);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    EXPECT_FALSE(lab.view.sensors);
    EXPECT_TRUE(hides_brain(view_of(lab), 0));
    EXPECT_EQ(hidden_brains(view_of(lab)), std::vector{true});
    press({key::page_down});
    EXPECT_EQ(lab.playback.mode, Mode::playing);
    EXPECT_FALSE(lab.pages->shows(PagePart::answer));
    lab.view.sensors = true;  // by the lecturer
    press({key::page_down});
    EXPECT_TRUE(lab.pages->shows(PagePart::answer));
    EXPECT_TRUE(lab.view.sensors) << "a step changes only the parts that it names";
    press({key::page_down});
    press({key::page_down});
    EXPECT_TRUE(lab.view.watching);
    EXPECT_FALSE(hides_brain(view_of(lab), 0));
}

TEST_F(LabLecturePages, APageWhoseQuestionARingWouldAnswerSelectsNoVehicle) {
    open("four-numbers");
    EXPECT_EQ(lab.view.selection.vehicle, no_vehicle);
    for (int frame = 0; frame < 50; ++frame) advance(lab, 0.02);
    EXPECT_EQ(lab.view.selection.vehicle, no_vehicle);
    press({key::page_down});
    press({key::page_up});
    EXPECT_EQ(lab.view.selection.vehicle, no_vehicle);
    press({key::page_down});
    EXPECT_NE(lab.view.selection.vehicle, no_vehicle) << "the first of the next page";
}

TEST_F(LabLecturePages, HomeRestoresTheCameraOfThePage) {
    open("four-numbers");
    auto lecture = std::make_shared<Lecture>(*lab.pages->lecture);
    lecture->pages[0].azimuth = 0.5f;
    lab.pages->lecture = lecture;
    show_page(lab, 0);
    EXPECT_FALSE(view_of(lab).has_moved_camera);
    lab.view.camera.azimuth = 2;
    EXPECT_TRUE(view_of(lab).has_moved_camera);
    press({key::home});
    EXPECT_EQ(lab.view.camera.azimuth, 0.5f);
    EXPECT_FALSE(view_of(lab).has_moved_camera);
}

TEST_F(LabLecturePages, ARunPausesAtTheMomentThatItsPageNames) {
    open("four-numbers");
    show_page(lab, 2, 2);
    const float pause = lab.pages->current().pause;
    ASSERT_GT(pause, 0);
    for (int run = 0; run < 2; ++run) {
        set_mode(lab, Mode::playing);
        for (int frame = 0; frame < 200 && lab.playback.mode == Mode::playing; ++frame) advance(lab, 0.02);
        EXPECT_EQ(lab.playback.mode, Mode::paused);
        EXPECT_EQ(lab.notice.key, "notice.page_pauses");
        EXPECT_EQ(lab.document.session.snapshot().tick, static_cast<std::uint64_t>(std::lround(pause * 60)));
        const VehicleView& vehicle = lab.document.session.snapshot().vehicles.front();
        EXPECT_GT(vehicle.motor[0], vehicle.motor[1] + 0.1f) << "the numbers show why it turns";
        handle(lab, Action::reset);  // a second run pauses, too
    }
    show_page(lab, 2, 2);
    set_mode(lab, Mode::playing);
    for (int frame = 0; frame < 200 && lab.playback.mode == Mode::playing; ++frame) advance(lab, 0.02);
    set_mode(lab, Mode::playing);
    for (int frame = 0; frame < 50; ++frame) advance(lab, 0.02);
    EXPECT_EQ(lab.playback.mode, Mode::playing) << "it goes on";
}

TEST_F(LabLecturePages, APauseBesideTheAnswerIsNotNews) {
    open("wheels-to-neurons");
    constexpr int turns_left = 4;  // page with the steps play, answer, wiring
    for (const int steps : {1, 2, 3}) {
        show_page(lab, turns_left, 1);
        set_mode(lab, Mode::playing);
        advance(lab, 0.02);
        while (lab.pages->step < steps) next_page(lab);
        for (int frame = 0; frame < 200 && lab.playback.mode == Mode::playing; ++frame) advance(lab, 0.02);
        EXPECT_EQ(lab.playback.mode, Mode::paused);
        EXPECT_EQ(lab.notice.key == "notice.page_pauses", steps == 1) << steps;
    }
}

TEST_F(LabLecturePages, ThePageAtWhichARunPausesShowsTheNumbersOfATurn) {
    open("four-numbers");
    show_page(lab, 5, 1);
    set_mode(lab, Mode::playing);
    for (int frame = 0; frame < 400 && lab.playback.mode == Mode::playing; ++frame) advance(lab, 0.02);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    EXPECT_FALSE(lab.pages->shows(PagePart::values)) << "no numbers beside a hidden brain";
    press({key::page_down});
    EXPECT_TRUE(lab.pages->shows(PagePart::values));
    EXPECT_TRUE(lab.pages->shows(PagePart::brain));
    const VehicleView& vehicle = lab.document.session.snapshot().vehicles.front();
    EXPECT_GT(vehicle.motor[0], vehicle.motor[1] + 0.1f) << "it turns away from the lamp on its left";
}

TEST_F(LabLecturePages, ARunPausesWhileItsNumbersShowTheAnswer) {
    open("wheels-to-neurons");
    const auto motors_at_pause = [&](int page) {
        show_page(lab, page, 1);
        set_mode(lab, Mode::playing);
        for (int frame = 0; frame < 800 && lab.playback.mode == Mode::playing; ++frame) advance(lab, 0.02);
        EXPECT_EQ(lab.playback.mode, Mode::paused) << page + 1;
        return lab.document.session.snapshot().vehicles.front().motor;
    };
    for (const int turns_left : {4, 5}) {
        const auto motor = motors_at_pause(turns_left);
        EXPECT_GT(motor[1], motor[0] + 0.1f) << "the right wheel is faster on page " << turns_left + 1;
    }
    const auto beside_red = motors_at_pause(7), one_lamp = motors_at_pause(10), two_lamps = motors_at_pause(11);
    EXPECT_NEAR(beside_red[0], beside_red[1], 0.02f) << "it drives straight";
    EXPECT_GT(one_lamp[0], 0.1f) << "one lamp is enough";
    EXPECT_NEAR(two_lamps[0], one_lamp[0], 0.01f) << "two lamps do not change it";
}

TEST_F(LabLecturePages, TheVehicleThatABrakeTurnsPausesWhenItFacesTheLamp) {
    open("wheels-to-neurons");
    show_page(lab, 6, 1);
    const auto degrees_to_lamp = [&] {
        const Snapshot& now = lab.document.session.snapshot();
        const VehicleView& vehicle = now.vehicles.front();
        const maths::vec2 way{now.sources.front().x - vehicle.x, now.sources.front().y - vehicle.y};
        return maths::degrees(maths::wrap_angle(maths::to_polar(way).angle - vehicle.heading));
    };
    EXPECT_LT(degrees_to_lamp(), -45) << "it is clearly on the right";
    set_mode(lab, Mode::playing);
    for (int frame = 0; frame < 400 && lab.playback.mode == Mode::playing; ++frame) advance(lab, 0.02);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    EXPECT_NEAR(degrees_to_lamp(), 0, 5) << "as the marked answer says";
}

TEST_F(LabLecturePages, ANoticeLeavesTheBarOfALectureSoon) {
    handle(lab, Action::lecture);
    ASSERT_EQ(lab.notice.key, "notice.projector_view");
    advance(lab, 5.1);
    EXPECT_TRUE(lab.notice.empty()) << "the title is shown again";
}

TEST_F(LabLecturePages, PageDownOnTheLastPageSaysThatItIsTheLastOne) {
    open("four-numbers");
    show_page(lab, 99, 99);
    const int last = lab.pages->page;
    EXPECT_TRUE(lab.notice.empty());
    press({key::page_down});
    EXPECT_EQ(lab.pages->page, last);
    EXPECT_EQ(lab.notice.key, "notice.lecture_end");
}

TEST_F(LabLecturePages, APageHidesAndRevealsTitleCharacterAndBrain) {
    const auto lecture = parse_lecture(R"(
format = 1
title = "T"
minutes = 1
[[page]]
scene = "2a-coward"
minutes = 1
hide = ["title"]
steps = ["character", "brain"]
)",
                                       folder / "t.toml", shipped_scenes().front().parent_path().parent_path());
    ASSERT_TRUE(lecture) << lecture.error().text();
    open_lecture(lab, std::make_shared<const Lecture>(*lecture));
    EXPECT_EQ(lab.view.revealed, (Revealed{false, false, false}));
    press({key::page_down});
    EXPECT_EQ(lab.view.revealed, (Revealed{false, true, false}));
    handle(lab, Action::hide_title);
    press({key::page_down});
    EXPECT_EQ(lab.view.revealed, Revealed{}) << "what the lecturer has revealed stays";
}

TEST_F(LabLecturePages, PageUpHidesTheLastStepThenGoesBackToTheWholePage) {
    open("four-numbers");
    for (int i = 0; i < 3; ++i) press({key::page_down});
    ASSERT_EQ(lab.pages->page, 1);
    ASSERT_EQ(lab.pages->step, 2);
    press({key::page_up});
    EXPECT_FALSE(lab.pages->shows(PagePart::answer));
    for (int i = 0; i < 2; ++i) press({key::page_down});
    ASSERT_EQ(lab.pages->page, 2);
    press({key::page_up});
    EXPECT_EQ(lab.pages->page, 1);
    EXPECT_TRUE(lab.pages->shows(PagePart::answer));
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
}

TEST_F(LabLecturePages, EditsOfAPageAreNotAskedToBeSavedAndThoseBeforeAre) {
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1}});
    open("four-numbers");
    ASSERT_TRUE(files.leaving) << "work from before the lecture";
    EXPECT_FALSE(lab.pages);
    EXPECT_EQ(files.leaving->next_title, "Four numbers that look alive");
    ask(LeaveRequest{Leave::discard});
    ASSERT_TRUE(lab.pages);
    press({key::page_down});
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1}});
    EXPECT_FALSE(has_unsaved_edits(lab));
    leave_by(key::escape);
    EXPECT_FALSE(lab.pages);
    EXPECT_FALSE(has_unsaved_edits(lab)) << "edits made in the lecture";
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 0.5f}});
    EXPECT_TRUE(has_unsaved_edits(lab));
}

TEST_F(LabLecturePages, EscapeAndF9RestoreTheViewSettings) {
    for (const int leave : {key::escape, key::f9}) {
        lab.preferences = {Theme::dark, "es", 1.25f, true};
        lab.view.outlines = true, lab.view.overlays.labels = true, lab.view.watching = false;
        const ViewSettings before = lab.view;
        const Preferences mine = lab.preferences;
        open("four-numbers");
        ASSERT_TRUE(view_of(lab).lecture);
        for (int i = 0; i < 5; ++i) press({key::page_down});
        ASSERT_NE(lab.view.overlays, before.overlays);
        leave_by(leave);
        EXPECT_FALSE(view_of(lab).lecture);
        EXPECT_EQ(view_of(lab).pages, nullptr);
        EXPECT_EQ(lab.preferences, mine);
        EXPECT_EQ(lab.view.overlays, before.overlays);
        EXPECT_EQ(lab.view.watching, before.watching);
        EXPECT_EQ(lab.view.outlines, before.outlines);
    }
}

TEST_F(LabLecturePages, StoredBrainsAndTheirCardsEndWithThePage) {
    handle(lab, Action::slot);
    lab.view.map = true;
    ASSERT_TRUE(view_of(lab).features.slots.has_any());
    for (const int leave : {key::escape, key::f9}) {
        open("four-numbers");
        EXPECT_FALSE(view_of(lab).features.slots.has_any()) << "those of the lecturer";
        EXPECT_FALSE(lab.view.map);
        show_page(lab, 6);
        handle(lab, Action::slot);
        handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1}});
        handle(lab, Action::slot);
        handle(lab, Action::compare);
        lab.view.map = lab.view.reality = true;
        ASSERT_TRUE(lab.slots.runs.question());
        show_page(lab, 7);
        EXPECT_FALSE(view_of(lab).features.slots.has_any());
        EXPECT_FALSE(lab.slots.runs.question());
        EXPECT_FALSE(lab.view.map || lab.view.reality);
        leave_by(leave);
        EXPECT_TRUE(view_of(lab).features.slots.slots[0].design) << "what was stored before the lecture";
        EXPECT_FALSE(view_of(lab).features.slots.slots[1].design);
        EXPECT_TRUE(lab.view.map);
    }
}

TEST_F(LabLecturePages, StoredBrainsAreAsBeforeTheLectureOnceItHasEnded) {
    const auto stored = [&] {
        const SlotsView slots = view_of(lab).features.slots;
        return std::pair(slots.slots[0].design != nullptr, slots.slots[1].design != nullptr);
    };
    const std::pair none(false, false), first(true, false);
    handle(lab, Action::slot);
    open("four-numbers");
    EXPECT_EQ(stored(), none);
    open("2a-coward");  // improvised, in lecture mode
    ASSERT_FALSE(lab.pages);
    EXPECT_EQ(stored(), none) << "those of the lecturer stay hidden";
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1}});
    handle(lab, Action::slot);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 0.5f}});
    handle(lab, Action::slot);
    EXPECT_EQ(stored(), std::pair(true, true));
    handle(lab, Action::lecture);
    ASSERT_FALSE(view_of(lab).lecture);
    EXPECT_EQ(stored(), first) << "what was stored in the lecture ends with it";
    handle(lab, Action::lecture);  // without a file: a large view of the scene
    EXPECT_EQ(stored(), first) << "to show a comparison that was prepared";
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.5f}});
    handle(lab, Action::slot);
    handle(lab, Action::lecture);
    EXPECT_EQ(stored(), first);
}

TEST_F(LabLecturePages, F9GoesBackToThePageThatWasLeft) {
    for (const int leave : {key::escape, key::f9}) {
        open("four-numbers");
        for (int i = 0; i < 3; ++i) press({key::page_down});
        handle(lab, HandsRequest{1, 12});
        leave_by(leave);
        ASSERT_FALSE(lab.pages);
        EXPECT_EQ(lab.notice.key, "notice.lecture_left");
        EXPECT_EQ(lab.notice.words, "2");
        press({key::f9});
        execute_file_requests(lab, files, state, folders);
        ASSERT_TRUE(lab.pages);
        EXPECT_TRUE(view_of(lab).lecture);
        EXPECT_EQ(lab.pages->page, 1);
        EXPECT_EQ(lab.pages->step, 2);
        EXPECT_EQ(lab.pages->hands[1], (std::vector{0, 12, 0}));
        EXPECT_FALSE(lab.lectures.left);
        EXPECT_TRUE(lab.notice.empty()) << "it said that the lecture was left";
    }
}

TEST_F(LabLecturePages, F9GoesOnWithTheRunAndTheWeightsOfThePageThatWasLeft) {
    open("four-numbers");
    for (int i = 0; i < 2; ++i) press({key::page_down});
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    set_mode(lab, Mode::playing);
    for (int frame = 0; frame < 20; ++frame) advance(lab, 0.02);
    leave_by(key::escape);
    const std::uint64_t tick = lab.document.session.snapshot().tick;
    const Scene edited = lab.document.session.edited_scene();
    ASSERT_GT(tick, 10u);
    ASSERT_NE(edited, *lab.document.file);
    press({key::f9});
    execute_file_requests(lab, files, state, folders);
    ASSERT_TRUE(lab.pages);
    EXPECT_FALSE(files.leaving) << "edits of the lecture are not asked to be saved";
    EXPECT_EQ(lab.document.session.snapshot().tick, tick);
    EXPECT_EQ(lab.document.session.edited_scene(), edited);
    EXPECT_EQ(lab.view.overlays.labels, lab.pages->shows(PagePart::labels)) << "it looks as the page does";
    show_page(lab, lab.pages->page);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u) << "a page is opened anew otherwise";
}

TEST_F(LabLecturePages, PageUpOverTheStepThatStartsTheRunReturnsToItsStart) {
    open("four-numbers");
    while (lab.pages->page < 1) press({key::page_down});
    const LecturePage& page = lab.pages->current();
    ASSERT_TRUE(page.reveal[0][static_cast<std::size_t>(PagePart::play)]);
    press({key::page_down});
    ASSERT_EQ(lab.playback.mode, Mode::playing);
    for (int frame = 0; frame < 20; ++frame) advance(lab, 0.02);
    ASSERT_GT(lab.document.session.snapshot().tick, 10u);
    press({key::page_up});
    EXPECT_EQ(lab.pages->step, 0);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
}

TEST_F(LabLecturePages, F9AsksAboutEditsMadeSinceTheLectureWasLeft) {
    open("four-numbers");
    press({key::page_down});
    leave_by(key::escape);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1}});
    press({key::f9});
    execute_file_requests(lab, files, state, folders);
    ASSERT_TRUE(files.leaving);
    EXPECT_FALSE(lab.pages);
    ask(LeaveRequest{Leave::discard});
    ASSERT_TRUE(lab.pages);
    EXPECT_EQ(lab.pages->page, 1) << "the page that was left, not the first one";
}

TEST_F(LabLecturePages, AfterAnotherFileTheMenuGoesBackAndF9IsTheLectureView) {
    open("four-numbers");
    press({key::page_down});
    open("3a-love");
    ASSERT_TRUE(view_of(lab).documents.left_pages) << "the row of the menu";
    handle(lab, Action::lecture);  // leaves the lecture view
    handle(lab, Action::lecture);
    execute_file_requests(lab, files, state, folders);
    EXPECT_FALSE(lab.pages);
    EXPECT_TRUE(view_of(lab).lecture);
    ask(OpenRequest{.path = lab.lectures.left->lecture->path.string(), .resume = true});
    ASSERT_TRUE(lab.pages);
    EXPECT_EQ(lab.pages->page, 1);
}

TEST_F(LabLecturePages, F5StartsAtTheFirstPage) {
    press({key::f5});
    EXPECT_EQ(lab.notice.key, "unavailable.no_lecture");
    open("four-numbers");
    for (int i = 0; i < 3; ++i) press({key::page_down});
    press({key::f5});
    EXPECT_EQ(lab.pages->page, 0);
    EXPECT_EQ(lab.pages->step, 0);
    for (int i = 0; i < 3; ++i) press({key::page_down});
    leave_by(key::escape);
    press({key::f5});
    execute_file_requests(lab, files, state, folders);
    ASSERT_TRUE(lab.pages);
    EXPECT_EQ(lab.pages->page, 0);
}

TEST_F(LabLecturePages, CountsHandsForEachPage) {
    open("four-numbers");
    press({key::page_down});
    handle(lab, HandsRequest{1, 12});
    handle(lab, HandsRequest{0, -3});
    handle(lab, HandsRequest{7, 5});
    EXPECT_EQ(lab.pages->hands[1], (std::vector{0, 12, 0}));
    for (int i = 0; i < 3; ++i) press({key::page_down});
    handle(lab, HandsRequest{0, 4});
    for (int i = 0; i < 2; ++i) press({key::page_up});
    EXPECT_EQ(lab.pages->hands[1], (std::vector{0, 12, 0})) << "they are kept when the page is shown again";
}

TEST_F(LabLecturePages, NIsNotesInALectureFileAndANewPopulationWithoutALecture) {
    press({'N'});
    EXPECT_EQ(lab.document.session.snapshot().generation, 2);
    handle(lab, Action::lecture);
    press({'N'});
    EXPECT_EQ(lab.document.session.snapshot().generation, 2);
    open("four-numbers");
    press({'N'});
    EXPECT_TRUE(lab.pages->notes);
    EXPECT_EQ(lab.document.session.snapshot().generation, 1) << "that of the page";
    press({key::page_down});
    EXPECT_TRUE(lab.pages->notes) << "they stay shown on the next page";
    press({'N'});
    EXPECT_FALSE(lab.pages->notes);
}

TEST_F(LabLecturePages, EscClosesAnExplanationBeforeTheLecture) {
    handle(lab, Action::lecture);
    handle(lab, Action::why);
    ASSERT_TRUE(lab.explanation.on);
    handle(lab, Action::cancel);
    EXPECT_FALSE(lab.explanation.on);
    EXPECT_TRUE(lab.before_lecture);
    leave_by(key::escape);
    EXPECT_FALSE(lab.before_lecture);
}

TEST_F(LabLecturePages, TheFirstEscEndsTheMapTheRobotsOrTheComparisonAndNeverTheLecture) {
    open("four-numbers");
    show_page(lab, 6);
    handle(lab, Action::slot);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1}});
    handle(lab, Action::slot);
    handle(lab, Action::compare);
    ASSERT_TRUE(lab.slots.runs.question());
    lab.view.map = true;
    press({key::escape});
    EXPECT_FALSE(lab.view.map);
    EXPECT_TRUE(lab.slots.runs.question()) << "one at a time";
    press({key::escape});
    EXPECT_FALSE(lab.slots.runs.question());
    EXPECT_TRUE(view_of(lab).features.slots.has_any()) << "the stored brains stay";
    lab.view.reality = true;
    press({key::escape});
    EXPECT_FALSE(lab.view.reality);
    EXPECT_TRUE(lab.pages);
    press({key::escape});
    EXPECT_EQ(lab.notice.key, "notice.escape_again");
    ASSERT_TRUE(lab.pages);
    lab.notice = {};  // its time is over
    press({key::escape});
    EXPECT_TRUE(lab.pages) << "it is the first one again";
    press({key::escape});
    EXPECT_FALSE(lab.pages);
}

TEST_F(LabLecturePages, AskFirstHidesTitleCharacterAndBrainOfEachSceneThatIsOpened) {
    const Revealed hidden{false, false, false, true};
    handle(lab, Action::ask_first);
    EXPECT_EQ(lab.view.revealed, Revealed{}) << "not outside a lecture";
    handle(lab, Action::lecture);
    press({'F', false, true});
    EXPECT_EQ(lab.view.revealed, hidden);
    EXPECT_FALSE(disclosure_of(lab).brains);
    for (const char letter : {'T', 'C', 'B'}) press({letter, false, true});
    EXPECT_TRUE(lab.view.revealed.title && lab.view.revealed.character && lab.view.revealed.brain);
    open("3a-love");
    ASSERT_EQ(lab.document.name, "3a-love");
    EXPECT_EQ(lab.view.revealed, hidden) << "the next riddle";
    open("four-numbers");
    EXPECT_TRUE(lab.view.revealed.title) << "a page shows what it says";
    open("2b-aggressor");
    EXPECT_EQ(lab.view.revealed, hidden);
    press({'F', false, true});
    EXPECT_EQ(lab.view.revealed, revealed_after_asking);
    EXPECT_TRUE(disclosure_of(lab).brains);
    open("3a-love");
    EXPECT_EQ(lab.view.revealed, hidden) << "the next riddle after a reveal by the same key";
    press({key::f9});
    EXPECT_EQ(lab.view.revealed, Revealed{}) << "it ends with the lecture";
}

TEST_F(LabLecturePages, AfterARevealAskFirstHidesAllAgainAndSaysThatItGoesOn) {
    handle(lab, Action::lecture);
    press({'F', false, true});
    EXPECT_EQ(lab.notice.key, "notice.asks_first");
    press({'B', false, true});
    EXPECT_EQ(lab.notice.key, "notice.shown_brain") << "and no longer that it is hidden";
    for (const char letter : {'T', 'C'}) press({letter, false, true});
    press({'F', false, true});
    EXPECT_EQ(lab.view.revealed, hidden_until_asked);
    EXPECT_EQ(lab.notice.key, "notice.asks_first");
    press({'F', false, true});
    EXPECT_EQ(lab.view.revealed, revealed_after_asking);
    EXPECT_EQ(lab.notice.key, "notice.asks_again");
    press({'F', false, true});
    EXPECT_EQ(lab.view.revealed, hidden_until_asked);
}

// Each key changes what is shown, or a line in the bar says what it did or why not.
TEST_F(LabLecturePages, EveryKeyOfALectureGivesASign) {
    const auto open_page = [&](int page) {
        open("four-numbers");
        show_page(lab, page);
    };
    const int last = static_cast<int>(opened_pages("four-numbers")) - 1;
    const std::vector<std::pair<std::string, std::function<void()>>> places{
        {"scene", [&] { open("2b-aggressor"); }},
        {"first page", [&] { open_page(0); }},
        {"page of a question", [&] { open_page(1); }},
        {"last page", [&] { open_page(last); }}};
    handle(lab, Action::lecture);
    int keys = 0;
    for (const auto& [place, go] : places)
        for (const Shortcut& shortcut : shortcuts())
            for (const int times : {1, 2}) {  // hidden, then shown
                if (shortcut.place != KeyPlace::lecture) continue;
                SCOPED_TRACE(place + ", " + std::string(braitenlab::name(shortcut.action)) + " " +
                             std::to_string(times));
                go();
                ui::PanelState panels;
                const auto seen = [&] {
                    const LectureView* pages = lab.pages ? &*lab.pages : nullptr;
                    return std::tuple(pages ? pages->page : -1, pages ? pages->step : -1, pages && pages->notes,
                                      lab.lectures.tally.has_value(), lab.view.revealed.title, lab.window.opens_notes,
                                      panels.lecture.blank, panels.lecture.marks.drawing);
                };
                auto before = seen();
                for (int i = 0; i < times; ++i) {
                    lab.window.opens_notes = false;
                    before = seen();
                    lab.notice = {};
                    Outbox outbox;
                    ui::press_key(view_of(lab), panels, shortcut.press, outbox);
                    for (const Request& request : outbox) handle(lab, request);
                    ++keys;
                }
                EXPECT_TRUE(seen() != before || !lab.notice.empty());
                lab.window.opens_notes = false;
                if (lab.lectures.tally) handle(lab, Action::tally);
            }
    EXPECT_GT(keys, 4 * 12);
}

TEST_F(LabLecturePages, F5BeginsTheClockAgainAndSaysSo) {
    open("four-numbers");
    advance(lab, 100);
    EXPECT_NEAR(view_of(lab).pages->seconds, 100, 1);
    press({key::f5});
    EXPECT_EQ(lab.notice.key, "notice.lecture_again");
    advance(lab, 5);
    EXPECT_NEAR(view_of(lab).pages->seconds, 5, 1);
}

TEST_F(LabLecturePages, NoCountBeginsWhereItHasNoRoom) {
    handle(lab, Action::lecture);
    handle(lab, Action::map);
    ASSERT_TRUE(lab.view.map);
    press({'V', false, true});
    EXPECT_EQ(lab.notice.key, "unavailable.tally_covered");
    handle(lab, Action::tally);
    EXPECT_FALSE(lab.lectures.tally);
    handle(lab, Action::cancel);
    handle(lab, Action::slot);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LM, 0.9f}});
    handle(lab, Action::slot);
    handle(lab, Action::compare);
    lab.notice = {};
    press({'V', false, true});
    EXPECT_EQ(lab.notice.key, "unavailable.tally_covered");
    EXPECT_FALSE(lab.lectures.tally);
    handle(lab, Action::cancel);
    press({'V', false, true});
    EXPECT_TRUE(lab.lectures.tally);
}

TEST_F(LabLecturePages, TheKeyOfTheMapSaysWhyThereIsNone) {
    set_mode(lab, Mode::wiring);
    handle(lab, Action::map);
    EXPECT_EQ(lab.notice.key, "unavailable.scene_only");
    EXPECT_FALSE(lab.view.map);
}

TEST_F(LabLecturePages, TheKeyOfTheMapSaysWhatIsMissing) {
    const auto why = [&] {
        lab.notice = {}, lab.view.map = false;
        handle(lab, Action::map);
        EXPECT_EQ(lab.view.map, lab.notice.empty());
        lab.view.map = false;
        EXPECT_EQ(ui::why_unavailable(view_of(lab), {}, Action::map), lab.notice.key) << "menu and button say the same";
        return lab.notice.key;
    };
    EXPECT_EQ(why(), "");
    handle(lab, Action::drive);
    EXPECT_EQ(why(), "unavailable.map_by_hand");
    handle(lab, Action::drive);
    EXPECT_EQ(why(), "");
    handle(lab, Action::lecture);
    handle(lab, Action::hide_brain);
    EXPECT_EQ(why(), "unavailable.map_hidden");
    handle(lab, Action::hide_brain);
    EXPECT_EQ(why(), "");
    open("wheels-to-neurons");
    show_page(lab, 1);
    EXPECT_EQ(why(), "unavailable.map_page");
    open("four-numbers");
    show_page(lab, 1);
    EXPECT_EQ(why(), "unavailable.map_hidden") << "the page hides it";
    lab.view.revealed.brain = true;
    EXPECT_EQ(why(), "unavailable.map_question");
    next_page(lab), next_page(lab);
    ASSERT_TRUE(lab.pages->shows(PagePart::answer));
    EXPECT_EQ(why(), "");
    open("drivers");
    const auto& vehicles = lab.document.session.snapshot().vehicles;
    const auto scripted = std::find_if(vehicles.begin(), vehicles.end(), [](const VehicleView& each) {
        return each.driver != Driver::brain && each.driver != Driver::manual;
    });
    ASSERT_NE(scripted, vehicles.end());
    lab.view.selection.vehicle = scripted->id;
    EXPECT_EQ(why(), "unavailable.map_driver");
    open("19-mystery");
    for (const VehicleView& each : lab.document.session.snapshot().vehicles)
        if (is_secret(lab, each.kind)) lab.view.selection.vehicle = each.id;
    EXPECT_EQ(why(), "unavailable.map_secret");
}

TEST_F(LabLecturePages, TheFirstPageBeginsWithoutCountedHands) {
    open("four-numbers");
    const auto question = [&] { return lab.pages->hands[1]; };
    show_page(lab, 1);
    handle(lab, HandsRequest{0, 7});
    previous_page(lab), show_page(lab, 1);
    EXPECT_EQ(question()[0], 7) << "another page keeps them";
    press({key::f5});
    EXPECT_EQ(lab.pages->page, 0);
    EXPECT_EQ(question(), std::vector<int>(question().size(), 0));
}

TEST_F(LabLecturePages, AnotherSceneBeginsWithEmptySlotsAndTheSameOneKeepsThem) {
    const auto is_stored = [&](std::size_t slot) { return lab.slots.stored[slot].has_value(); };
    for (const bool lecture : {false, true}) {
        open("2a-coward");
        if (lecture) handle(lab, Action::lecture);
        handle(lab, Action::slot);
        ASSERT_TRUE(is_stored(0));
        open("2a-coward");
        EXPECT_TRUE(is_stored(0));
        open("3a-love");
        EXPECT_FALSE(is_stored(0));
        handle(lab, Action::slot);
        EXPECT_TRUE(is_stored(0)) << "the first brain of this scene is A";
        EXPECT_FALSE(is_stored(1));
    }
}

TEST_F(LabLecturePages, ATallyCountsHandsForAQuestionWithoutAPageUntilTheNextScene) {
    const auto hands = [&] { return view_of(lab).tally ? view_of(lab).tally->hands.front() : std::vector<int>{}; };
    handle(lab, Action::tally);
    EXPECT_TRUE(hands().empty()) << "not outside a lecture";
    handle(lab, Action::lecture);
    press({'F', false, true});
    EXPECT_EQ(lab.notice.key, "notice.asks_first");
    press({'V', false, true});
    ASSERT_EQ(hands().size(), 4u);
    handle(lab, HandsRequest{1, 7});
    handle(lab, HandsRequest{4, 7});
    EXPECT_EQ(hands(), (std::vector{0, 7, 0, 0}));
    handle(lab, TallyRequest{3});
    EXPECT_EQ(hands(), (std::vector{0, 7, 0})) << "a question of three options";
    for (const std::size_t wanted : {std::size_t{1}, std::size_t{7}, std::size_t{4}}) {
        handle(lab, TallyRequest{wanted});
        EXPECT_EQ(hands().size(), std::clamp(wanted, least_tally_options, most_tally_options));
        EXPECT_EQ(hands()[1], 7);
    }
    open("3a-love");
    EXPECT_EQ(hands(), (std::vector{0, 0, 0, 0})) << "the next question";
    press({'V', false, true});
    EXPECT_TRUE(hands().empty());
    press({'V', false, true});
    open("four-numbers");
    EXPECT_TRUE(hands().empty()) << "a page has its own question";
    press({'V', false, true});
    EXPECT_EQ(lab.notice.key, "unavailable.tally");
    EXPECT_TRUE(hands().empty());
    open("3a-love");
    press({'V', false, true});
    EXPECT_EQ(hands().size(), 4u);
    press({key::f9});
    EXPECT_TRUE(hands().empty()) << "it ends with the lecture";
}

TEST_F(LabLecturePages, ABrokenLectureIsRefusedAndTheSceneStays) {
    put_text(folder / "own.toml", "format = 1\ntitle = \"T\"\nminutes = 1\n[[page]]\nscene = \"2a-cowerd\"\n");
    ask(OpenRequest{(folder / "own.toml").string()});
    EXPECT_FALSE(lab.pages);
    EXPECT_EQ(lab.document.name, "2a-coward");
    EXPECT_NE(lab.notice.words.find("own.toml:5"), std::string::npos) << lab.notice.words;
    EXPECT_NE(lab.notice.words.find("the nearest is '2a-coward'"), std::string::npos);
}

TEST_F(LabLecturePages, OpeningAnotherFileEndsTheLectureFile) {
    open("four-numbers");
    open("3a-love");
    EXPECT_FALSE(lab.pages);
    EXPECT_EQ(lab.document.name, "3a-love");
    EXPECT_TRUE(view_of(lab).lecture) << "the lecture view stays";
}

}  // namespace
}  // namespace braitenlab::tests::lecture_pages_test
