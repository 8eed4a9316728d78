// The sheet that exports the selected vehicle's brain to a robot.
#include "core/messages.h"
#include "desk.h"
#include "ui/panels/robots/robot_state.h"

namespace braitenlab::tests::robot_sheet_test {

using namespace ui;

struct RobotSheet : ::testing::Test {
    Desk desk;
    FilesView files;
    RobotSheet() {
        desk.now = shipped_scene("2a-coward");
        files.suggested = "mine";
        desk.view.documents.files = &files;
        open();
    }
    void open() {
        desk.frame(3);
        desk.choose("file", "export_robot");
        desk.frame(3);
    }
    // The selected vehicle's brain with a threshold of 0.2 on its first wire.
    void give_threshold() {
        auto brain = *brain_of(desk.now, desk.now.vehicles[0]);
        brain.wires[0].threshold = 0.2f;
        desk.now.brains[static_cast<std::size_t>(desk.now.vehicles[0].brain)] =
            std::make_shared<const BrainGraph>(std::move(brain));
    }
};

TEST_F(RobotSheet, RequestsTheFilesForTheChosenRobot) {
    ASSERT_TRUE(desk.anchors.find("card.robot"));
    EXPECT_TRUE(desk.says("wiring.svg")) << "the Arduino is chosen at first";
    EXPECT_FALSE(desk.last<WriteFilesRequest>());
    for (const robots::Robot& robot : robots::robots()) {
        desk.click("robot.target." + std::string(robot.word()));
        desk.click("robot.export");
        const auto* request = desk.last<WriteFilesRequest>();
        ASSERT_TRUE(request) << robot.name;
        const auto made = robots::export_brain(brain_to_export(desk.view, desk.now.vehicles[0]), robot.target, robot);
        ASSERT_TRUE(made);
        ASSERT_EQ(request->files->size(), made->size());
        for (std::size_t i = 0; i < made->size(); ++i) {
            EXPECT_EQ((*request->files)[i].name, (*made)[i].name);
            EXPECT_EQ((*request->files)[i].text, (*made)[i].text);
            EXPECT_TRUE(desk.says((*made)[i].name)) << (*made)[i].name;
        }
        EXPECT_EQ(request->folder, "mine-" + std::string(robot.word()));
        EXPECT_FALSE(request->replace);
    }
}

TEST_F(RobotSheet, SaysInTheTitleThatTheFileHasAnotherBrain) {
    const Scene file = *desk.now.scene;
    desk.view.file = &file;
    const auto title = [&] { return brain_to_export(desk.view, desk.now.vehicles[0]).title; };
    EXPECT_FALSE(title().ends_with(", changed")) << title();
    give_threshold();
    EXPECT_TRUE(title().ends_with(", changed")) << title();
    desk.view.file = nullptr;
    EXPECT_FALSE(title().ends_with(", changed")) << "the file is unknown";
}

TEST_F(RobotSheet, NamesTheBrainByItsFileAsBraitenctlDoes) {
    const auto title = [&] { return brain_to_export(desk.view, desk.now.vehicles[0]).title; };
    EXPECT_TRUE(title().starts_with("mine, ")) << title();
    files.suggested.clear();
    EXPECT_TRUE(title().starts_with(desk.now.scene->title + ", ")) << title();
}

TEST_F(RobotSheet, NamesThePartThatTheTargetCannotHold) {
    desk.key({key::escape});
    give_threshold();
    open();
    EXPECT_TRUE(desk.says("brain.h")) << "an Arduino holds thresholds";
    desk.click("robot.target.opamp");
    const BrainGraph& brain = *brain_of(desk.now, desk.now.vehicles[0]);
    const std::string from = find_node(brain, brain.wires[0].from)->name;
    EXPECT_TRUE(desk.says("The wire from '" + from + "'")) << from;
    EXPECT_TRUE(desk.says("has a threshold"));
    EXPECT_FALSE(desk.says("brain.cir"));
    desk.click("robot.export");
    EXPECT_FALSE(desk.last<WriteFilesRequest>());
}

TEST_F(RobotSheet, ReplacesExistingFilesAfterASecondPress) {
    desk.click("robot.folder");
    desk.type("there");
    desk.frame(2);
    desk.click("robot.export");
    ASSERT_TRUE(desk.last<WriteFilesRequest>());
    EXPECT_EQ(desk.last<WriteFilesRequest>()->folder, "there");
    files.refused = error_of(message_of("files_exist", "brain.h"), "/home/there");
    desk.frame(2);
    EXPECT_TRUE(desk.says("brain.h; export once more"));
    EXPECT_TRUE(desk.says("Replace"));
    desk.click("robot.export");
    EXPECT_TRUE(desk.last<WriteFilesRequest>()->replace);
    desk.click("robot.folder");
    desk.type("elsewhere");
    desk.frame(2);
    EXPECT_FALSE(desk.says("Replace")) << "another folder";
    desk.click("robot.export");
    EXPECT_FALSE(desk.last<WriteFilesRequest>()->replace);
}

TEST_F(RobotSheet, SaysWhereTheFilesAreAndWhatToDoNext) {
    desk.click("robot.target.thymio");
    desk.click("robot.export");
    ++files.done;
    files.exported_to = "/home/mine-thymio";
    desk.frame(2);
    EXPECT_TRUE(desk.says("Written to /home/mine-thymio"));
    EXPECT_TRUE(desk.says("brain.aesl"));
    EXPECT_TRUE(desk.says("Aseba Studio"));
    EXPECT_FALSE(desk.anchors.find("robot.export"));
    desk.click("robot.open_folder");
    ASSERT_TRUE(desk.last<OpenFolderRequest>());
    EXPECT_EQ(desk.last<OpenFolderRequest>()->folder, files.exported_to);
    desk.view.program.uploads = true;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("robot.open_folder")) << "a browser has no such folder";
    desk.view.program.uploads = false;
    desk.frame(2);
    desk.click("robot.close");
    EXPECT_EQ(desk.panels.sheet, Sheet::none);
    open();
    EXPECT_TRUE(desk.anchors.find("robot.export")) << "it begins anew";
    EXPECT_EQ(desk.panels.sheets.robot.robot, robots::find_robot("thymio2")) << "with the robot of the last time";
}

// With two warnings.
TEST(RobotSheetInEachLanguage, HasTheFolderAboveItsButtonsWhenItWarns) {
    FilesView files;
    files.suggested = "mine";
    for (const std::string& code : shipped_codes()) {
        Desk warned(1280, 800, 1, true);
        warned.strings = speaking(code);
        warned.now = shipped_scene("3a-love");
        warned.view.documents.files = &files;
        warned.frame(3);
        warned.choose("file", "export_robot");
        warned.frame(3);
        warned.click("robot.target.opamp");
        warned.frame(3);
        ASSERT_EQ(warned.panels.sheets.robot.warnings.size(), 2u) << code;
        const Rect folder = warned.where("robot.folder"), button = warned.where("robot.export");
        EXPECT_GE(folder.h, 30) << code;
        EXPECT_LE(folder.y + folder.h, button.y) << code;
    }
}

TEST_F(RobotSheet, NeedsAVehicleWhoseBrainIsShown) {
    desk.key({key::escape});
    EXPECT_EQ(why_unavailable(desk.view, desk.panels, Action::export_robot), "");
    desk.view.settings.revealed.brain = false;
    desk.follow_disclosure();
    EXPECT_EQ(why_unavailable(desk.view, desk.panels, Action::export_robot), "wiring.hidden");
    desk.view.settings.selection.vehicle = no_vehicle;
    EXPECT_EQ(why_unavailable(desk.view, desk.panels, Action::export_robot), "unavailable.no_vehicle");
}

TEST_F(RobotSheet, AnnouncesDownloadsInABrowser) {
    EXPECT_FALSE(desk.says("The browser downloads"));
    desk.view.program.uploads = true;
    desk.frame(2);
    EXPECT_TRUE(desk.says("The browser downloads"));
}

}  // namespace braitenlab::tests::robot_sheet_test
