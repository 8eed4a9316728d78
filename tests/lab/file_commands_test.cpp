// Opening and saving by the requests of the file browser.
#include "app/files/file_commands.h"

#include <ctime>
#include <tuple>

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/course/lesson_view.h"
#include "app/files/autosave.h"
#include "app/files/reports.h"
#include "core/export/export.h"
#include "core/scene/scene_file.h"
#include "core/scene/schema.h"
#include "core/scene/toml_tree.h"
#include "tests/lab/lab_files.h"
#include "tests/tells.h"

namespace braitenlab::tests::file_commands_test {
namespace {

struct FileCommands : LabFiles {};

TEST_F(FileCommands, SavesTheSceneWithItsEditedBrainAndOpensItAgain) {
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    EXPECT_EQ(files.save_to, "") << "shipped files are not overwritten";
    ask(SaveRequest{"mine", FileKind::scene});
    EXPECT_EQ(files.done, 1);
    EXPECT_EQ(files.save_to, (folder / "mine.toml").string());
    ask(OpenRequest{(*find_shipped("3a-love")).string()});
    EXPECT_EQ(lab.document.name, "3a-love");
    ask(OpenRequest{"mine.toml"});
    EXPECT_EQ(dials().LR, 1.25f);
    EXPECT_EQ(state.recent.front(), (RecentFile{(folder / "mine.toml").string(), title_of(lab.document)}));
}

TEST_F(FileCommands, NamesACopyOfASceneByItsOwnFileUnlessTheSceneStatesAName) {
    const auto name_in = [&](const char* file) { return load_scene((folder / file).string())->name; };
    put_text(folder / "my-scene.toml", "format = 1\nname = \"my-scene\"\n");
    ask(OpenRequest{"my-scene.toml"});
    ask(SaveRequest{"my-robot", FileKind::scene});
    EXPECT_EQ(name_in("my-robot.toml"), "my-robot");
    ask(SaveRequest{"third", FileKind::scene});
    EXPECT_EQ(name_in("third.toml"), "third");
    put_text(folder / "fourth.toml", "format = 1\nname = \"tortoise\"\n");
    ask(OpenRequest{"fourth.toml"});
    ask(SaveRequest{"fifth", FileKind::scene});
    EXPECT_EQ(name_in("fifth.toml"), "tortoise");
}

TEST_F(FileCommands, ListsTheSceneFilesThatItHasWritten) {
    ask(SaveRequest{"brain", FileKind::brain});
    ask(SaveRequest{"run", FileKind::run});
    ask(SaveRequest{nowhere.string(), FileKind::scene});
    EXPECT_TRUE(lab.window.saved.empty());
    ask(SaveRequest{"mine", FileKind::scene});
    EXPECT_EQ(lab.window.saved, std::vector{folder / "mine.toml"});
}

TEST_F(FileCommands, SavesTheBrainOfOneVehicleOfThePopulation) {
    lab = open("predator-prey");
    const auto LL_of = [this](VehicleId id) {
        const Snapshot& now = lab.document.session.snapshot();
        return read_dials(*brain_of(now, *find_vehicle(now, id))).LL;
    };
    const float shipped = LL_of(4);
    handle(lab, EditRequest{TurnDial{{.vehicle = 3}, Dial::LL, -1.25f}});
    ASSERT_TRUE(has_unsaved_edits(lab));
    ask(SaveRequest{"mine", FileKind::scene});
    EXPECT_FALSE(has_unsaved_edits(lab));
    ask(OpenRequest{"mine.toml"});
    EXPECT_EQ(LL_of(3), -1.25f);
    EXPECT_EQ(LL_of(4), shipped);
}

TEST_F(FileCommands, SavesToTheFileThatWasOpenedByARelativePath) {
    ask(SaveRequest{"below/mine", FileKind::scene, std::nullopt, true});
    const fs::path file = folder / "below" / "mine.toml";
    ASSERT_TRUE(fs::exists(file));
    const fs::path relative = fs::relative(file);
    if (relative.empty()) GTEST_SKIP() << "the folder is on another drive";
    lab = open(relative.string());
    add_recent_file(state, file, lab.document);
    files = {};
    refresh(files, lab);
    EXPECT_EQ(files.save_to, file.string());
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    ask(Action::save);
    EXPECT_FALSE(has_unsaved_edits(lab)) << files.refused.value_or(Error{}).text();
    EXPECT_EQ(open(file.string()).document.session.edited_scene(), lab.document.session.edited_scene());
}

TEST_F(FileCommands, SavesTheSceneUnderAnotherTitle) {
    ask(SaveRequest{"mine", FileKind::scene, "My own coward"});
    EXPECT_EQ(lab.document.session.snapshot().scene->title, "My own coward") << "the card shows it";
    EXPECT_FALSE(has_unsaved_edits(lab));
    ask(OpenRequest{(*find_shipped("3a-love")).string()});
    ask(OpenRequest{"mine.toml"});
    EXPECT_EQ(lab.document.session.scene().title, "My own coward");
    ask(SaveRequest{"mine", FileKind::scene, std::string(1000, 'x')});
    EXPECT_TRUE(files.refused) << "too long";
    EXPECT_EQ(lab.document.session.snapshot().scene->title, "My own coward");
}

TEST_F(FileCommands, SavesTheSceneWithAnotherStory) {
    const std::string title = lab.document.session.scene().title, story(limits::text_length, 'x');
    ask(SaveRequest{.path = "mine", .story = story});
    EXPECT_EQ(lab.document.session.snapshot().scene->story, story) << "the card shows it";
    EXPECT_FALSE(has_unsaved_edits(lab));
    ask(OpenRequest{(*find_shipped("3a-love")).string()});
    ask(OpenRequest{"mine.toml"});
    EXPECT_EQ(lab.document.session.scene().story, story);
    EXPECT_EQ(lab.document.session.scene().title, title);
    ask(SaveRequest{.path = "mine", .story = story + 'x'});
    ASSERT_TRUE(files.refused);
    EXPECT_NE(files.refused->text().find("story"), std::string::npos) << files.refused->text();
    EXPECT_EQ(lab.document.session.snapshot().scene->story, story);
}

TEST_F(FileCommands, RestoresTitleAndStoryAsOneStepOfUndo) {
    const Scene before = *lab.document.session.snapshot().scene;
    ask(SaveRequest{.path = "mine", .title = "Mine", .story = "It turns."});
    EXPECT_EQ(lab.document.session.undo_depth(), 1);
    handle(lab, Action::undo);
    EXPECT_EQ(*lab.document.session.snapshot().scene, before);
    EXPECT_TRUE(has_unsaved_edits(lab)) << "the file has the other texts";
}

TEST_F(FileCommands, ExportsNumbersToANewFileInTheFolderOfPictures) {
    ask(ExportRequest{"signals", "seconds,SL\n"});
    ask(ExportRequest{"signals", "seconds,SL\n0,1\n"});
    EXPECT_EQ(text_of(folders.pictures / "braitenlab-signals-001.csv"), "seconds,SL\n");
    EXPECT_EQ(text_of(folders.pictures / "braitenlab-signals-002.csv"), "seconds,SL\n0,1\n");
    EXPECT_NE(lab.notice.words.find((folders.pictures / "braitenlab-signals-002.csv").string()), std::string::npos)
        << lab.notice.words;
}

TEST_F(FileCommands, WritesTheFilesOfAnExportIntoANewFolder) {
    const auto files_of = [](const char* text) {
        return std::make_shared<const std::vector<robots::ExportedFile>>(
            std::vector<robots::ExportedFile>{{"sketch/sketch.ino", text}, {"README.md", text}});
    };
    ask(WriteFilesRequest{"robot", files_of("one")});
    ASSERT_FALSE(files.refused) << files.refused->text();
    EXPECT_EQ(files.exported_to, (folder / "robot").string());
    EXPECT_EQ(files.done, 1);
    EXPECT_EQ(text_of(folder / "robot/sketch/sketch.ino"), "one");
    EXPECT_EQ(text_of(folder / "robot/README.md"), "one");
    EXPECT_EQ(lab.notice.key, "notice.exported");

    fs::remove(folder / "robot/README.md");
    ask(WriteFilesRequest{"robot", files_of("two")});
    ASSERT_TRUE(files.refused) << "sketch.ino would be replaced";
    EXPECT_NE(files.refused->what.find("sketch/sketch.ino;"), std::string::npos) << files.refused->what;
    EXPECT_FALSE(fs::exists(folder / "robot/README.md")) << "nothing is written";
    EXPECT_EQ(files.done, 1);
    ask(WriteFilesRequest{"robot", files_of("two"), true});
    EXPECT_FALSE(files.refused);
    EXPECT_EQ(text_of(folder / "robot/sketch/sketch.ino"), "two");

    ask(WriteFilesRequest{"nowhere/robot", files_of("one")});
    ASSERT_TRUE(files.refused);
    EXPECT_FALSE(fs::exists(folder / "nowhere"));
}

TEST_F(FileCommands, ALargeFileWithAnErrorIsRefusedInAboutTheTimeOfReadingIt) {
    std::string keys = "format = 1\n";
    for (int i = 0; i < 60000; ++i) keys += "k" + std::to_string(i) + " = 1\n";
    const auto seconds_of = [](const auto& work) {
        double least = 1e9;
        for (int i = 0; i < 3; ++i) {
            const std::clock_t began = std::clock();
            work();
            least = std::min(least, static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC);
        }
        return least;
    };
    const double parse = seconds_of([&] { EXPECT_TRUE(parse_toml(keys, "f.toml")); });
    for (const auto& [end, dropped, most] :
         {std::tuple("x = 0,5\n", false, 2.9), {"[arena]\n", false, 2.1}, {"[[step]]\n", true, 4.0}}) {
        put_text(folder / "large.toml", keys + end);
        const OpenRequest request{.path = (folder / "large.toml").string(), .dropped = dropped};
        const double open = seconds_of([&] {
            ask(request);
            EXPECT_TRUE(files.refused);
        });
        EXPECT_LT(open, most * parse) << end << open << " s, the text alone " << parse;
    }
}

TEST_F(FileCommands, AsksBeforeAnExportRemovesAFileThatWasEdited) {
    const auto files_of = [](const char* name) {
        return std::make_shared<const std::vector<robots::ExportedFile>>(std::vector<robots::ExportedFile>{
            {name, "Exported from Braitenlab."}, {"README.md", "Exported from Braitenlab."}});
    };
    ask(WriteFilesRequest{"robot", files_of("main.py")});
    ASSERT_FALSE(files.refused) << files.refused->text();
    put_text(folder / "robot/main.py", "Exported from Braitenlab. And mine.");
    fs::remove(folder / "robot/brain.h");
    ask(WriteFilesRequest{"robot", files_of("brain.h")});
    ASSERT_TRUE(files.refused);
    EXPECT_TRUE(tells(*files.refused, message_of("files_exist", "main.py, README.md")));
    EXPECT_TRUE(fs::exists(folder / "robot/main.py"));
    ask(WriteFilesRequest{"robot", files_of("brain.h"), true});
    EXPECT_FALSE(fs::exists(folder / "robot/main.py"));
}

TEST_F(FileCommands, AsksBeforeItExportsIntoAFolderOfOtherFiles) {
    const auto exported = std::make_shared<const std::vector<robots::ExportedFile>>(
        std::vector<robots::ExportedFile>{{"README.md", "Exported from Braitenlab."}});
    fs::create_directories(folder / "photos");
    put_text(folder / "photos/cat.txt", "mine");
    ask(WriteFilesRequest{"photos", exported});
    ASSERT_TRUE(files.refused);
    EXPECT_EQ(files.refused->phrases[0].id, "foreign_folder");
    EXPECT_FALSE(fs::exists(folder / "photos/README.md"));
    ask(WriteFilesRequest{"photos", exported, true});
    EXPECT_FALSE(files.refused);
    EXPECT_TRUE(fs::exists(folder / "photos/README.md"));
    EXPECT_EQ(text_of(folder / "photos/cat.txt"), "mine");
}

TEST_F(FileCommands, ExportsTheProgressOfStudentsBesideTheReports) {
    lab.students.all.front().exercises["06-love"].hints = 2;
    ask(StudentRequest{StudentEdit::save});
    const fs::path file = folders.documents / "Braitenlab" / "braitenlab-progress-001.csv";
    EXPECT_NE(text_of(file).find("06-love"), std::string::npos);
    EXPECT_NE(lab.notice.words.find(file.string()), std::string::npos) << lab.notice.words;
    EXPECT_FALSE(fs::exists(folders.pictures));
}

TEST_F(FileCommands, ReadsTheProgressThatItHasSaved) {
    lab.students.all.front().exercises["06-love"].hints = 2;
    ask(StudentRequest{StudentEdit::save_progress});
    const fs::path file = folders.documents / "Braitenlab" / "braitenlab-progress-001.json";
    ASSERT_TRUE(fs::exists(file));
    lab.students = {};
    ask(OpenRequest{file.string(), true});
    EXPECT_EQ(lab.students.student().exercises.at("06-love").hints, 2);
    EXPECT_EQ(lab.notice.key, "files.took_progress");
}

TEST_F(FileCommands, ContinuesTheExerciseOfAKeptRun) {
    lab = open("06-love");
    lab.document.lesson->attempt.answers.prediction = 1;
    put_text(folder / "06-love.run", write_autosave(draft_of(lab.document), "2026-11-30 10:00:00"));
    lab = open("2a-coward");
    ask(OpenRequest{(folder / "06-love.run").string(), true});
    ASSERT_TRUE(lab.document.lesson);
    EXPECT_EQ(lab.document.lesson->attempt.answers.prediction, 1);
}

TEST_F(FileCommands, NamesAHandInAndItsStudent) {
    lab = open("05-aggressor");
    const HandIn handed_in = hand_in_of(lab, "Ana", {});
    put_text(folder / "x.toml", write_hand_in(handed_in));
    ask(OpenRequest{(folder / "x.toml").string(), true});
    EXPECT_EQ(lab.notice.key, "files.is_hand_in");
    EXPECT_EQ(lab.notice.words, "Ana");
    EXPECT_EQ(lab.notice.more, "05-aggressor");
}

TEST_F(FileCommands, KeepsTheRecordedFutureWhenItSavesUnderAnotherTitle) {
    for (int i = 0; i < 400; ++i) tick(lab);
    handle(lab, SeekRequest{100});
    ask(SaveRequest{"mine", FileKind::scene, "My own coward"});
    EXPECT_EQ(lab.document.session.latest(), 400u) << "a title does not change the run";
}

TEST_F(FileCommands, ReportsThatABrainFromAFileDropsTheRecordedFuture) {
    ask(SaveRequest{"shy", FileKind::brain});
    for (int i = 0; i < 400; ++i) tick(lab);
    handle(lab, SeekRequest{100});
    ask(OpenRequest{"shy.toml"});
    EXPECT_EQ(lab.document.session.latest(), 100u);
    EXPECT_EQ(lab.notice.key, "notice.forgotten");
}

TEST_F(FileCommands, UndoOfABrainFromAFileInThePastRestoresTheDoneStepsOfAnExercise) {
    ask(SaveRequest{"shy", FileKind::brain});
    lab = open("05-aggressor");
    handle(lab, EditRequest{SetBrain{{.kind = 0}, lab.document.lesson->exercise->solution.submission.brain}});
    for (int i = 0; i < 700; ++i) tick(lab);
    const auto then = lesson_view_of(lab).verdicts;
    handle(lab, SeekRequest{20});
    ask(OpenRequest{"shy.toml"});
    for (int i = 0; i < 600; ++i)  // more than a keyframe holds
        handle(lab, EditRequest{MoveSource{0, 5 + 0.001f * static_cast<float>(i), 5}, 7});
    handle(lab, Action::undo);
    handle(lab, Action::undo);
    handle(lab, SeekRequest{700});
    ASSERT_EQ(lab.document.session.snapshot().tick, 700u);
    for (std::size_t i = 0; i < then.size(); ++i) {
        EXPECT_EQ(lesson_view_of(lab).verdicts[i].done, then[i].done) << i;
        EXPECT_EQ(lesson_view_of(lab).verdicts[i].measures, then[i].measures) << i;
    }
}

TEST_F(FileCommands, ListsUnreadableFilesAsBroken) {
    ask(SaveRequest{"good scene", FileKind::scene});
    ask(SaveRequest{"good brain", FileKind::brain});
    ask(SaveRequest{"good run", FileKind::run});
    const std::string run = text_of(folder / "good run.run");
    put_text(folder / "torn.run", run.substr(0, run.size() / 2));
    put_text(folder / "torn brain.toml", text_of(folder / "good brain.toml") + "\n[brain.nonsense]\n");
    put_text(folder / "torn scene.toml", text_of(folder / "good scene.toml") + "\n[nonsense]\n");
    put_text(folder / "garbage.toml", "garbage");
    put_text(folder / "letter.txt", "not the lab's");
    ask(BrowseRequest{folder.path.string()});
    std::vector<std::string> good, broken;
    for (const FileEntry& entry : files.listing.entries) (entry.broken ? broken : good).push_back(entry.name);
    EXPECT_EQ(good, (std::vector<std::string>{"good brain.toml", "good run.run", "good scene.toml"}));
    EXPECT_EQ(broken, (std::vector<std::string>{"garbage.toml", "torn brain.toml", "torn scene.toml", "torn.run"}));
    ask(OpenRequest{"garbage.toml"});
    ASSERT_TRUE(files.refused);
    EXPECT_NE(files.refused->text().find("garbage.toml:1"), std::string::npos) << files.refused->text();
}

TEST_F(FileCommands, CreatesAFolderOnlyIfTheUserAgrees) {
    const fs::path file = folder / "new" / "deep" / "mine.toml";
    ask(SaveRequest{file.string(), FileKind::scene});
    EXPECT_FALSE(fs::exists(folder / "new"));
    EXPECT_EQ(files.new_folder, file.parent_path().string());
    ASSERT_TRUE(files.refused);
    EXPECT_NE(files.refused->text().find("does not exist"), std::string::npos) << files.refused->text();
    EXPECT_EQ(files.done, 0);
    ask(SaveRequest{file.string(), FileKind::scene, {}, true});
    EXPECT_TRUE(fs::exists(file));
    EXPECT_EQ(files.new_folder, "");
    EXPECT_EQ(files.done, 1);
    ask(SaveRequest{nowhere.string(), FileKind::scene, {}, true});
    EXPECT_EQ(files.new_folder, "");
    EXPECT_TRUE(files.refused) << "a folder that cannot be created";
    EXPECT_EQ(files.done, 1);
}

TEST_F(FileCommands, ExplainsADroppedFolder) {
    fs::create_directories(folder / "class");
    ask(OpenRequest{(folder / "class").string(), true});
    EXPECT_EQ(lab.notice.key, "files.dropped_folder");
    EXPECT_EQ(lab.notice.words, "class");
    EXPECT_EQ(files.listing.folder, (folder / "class").string()) << "as the notice says";
}

TEST_F(FileCommands, ADroppedFileDoesNotReachOutOfItsFolder) {
    const std::string scene = text_of(*find_shipped("2a-coward"));
    put_text(folder / "in" / "near.toml", scene);
    put_text(folder / "far.toml", scene);
    const auto lecture = [](const std::string& named) {
        return "format = 1\ntitle = \"L\"\nminutes = 1\n[[page]]\ntitle = "
               "\"P\"\nminutes = 1\nscene = \"" +
               named + "\"\n";
    };
    const auto refusal = [&](const std::string& text, bool dropped) {
        put_text(folder / "in" / "file.toml", text);
        ask(OpenRequest{.path = (folder / "in" / "file.toml").string(), .dropped = dropped});
        return files.refused ? std::string(files.refused->phrases.front().id) : "";
    };
    for (const std::string& named : {std::string("../far.toml"), (folder / "far.toml").string()}) {
        EXPECT_EQ(refusal(lecture(named), true), "leaves_folder") << named;
        EXPECT_EQ(files.refused->line, 7);
        EXPECT_NE(refusal(lecture(named), false), "leaves_folder") << named << ", opened by the user";
    }
    EXPECT_NE(refusal(lecture("near.toml"), true), "leaves_folder");
    EXPECT_NE(refusal(lecture("2b-aggressor"), true), "leaves_folder") << "a shipped scene";
    const fs::path shipped = *find_shipped("04-coward");
    ask(OpenRequest{.path = shipped.string(), .dropped = true});
    EXPECT_FALSE(files.refused) << "its scene is ../scenes/…, which ships, too";
}

TEST_F(FileCommands, KeepsTheDocumentIfAFileIsBroken) {
    put_text(folder / "broken.toml", "format = 1\n[arena]\nwidht = 3\n");
    const auto before = lab.document.session.hash();
    ask(OpenRequest{"broken.toml"});
    EXPECT_EQ(lab.document.session.hash(), before);
    EXPECT_EQ(lab.document.name, "2a-coward");
    EXPECT_EQ(files.done, 0);
    ASSERT_TRUE(files.refused);
    EXPECT_NE(files.refused->text().find("broken.toml:3"), std::string::npos) << files.refused->text();
    ASSERT_TRUE(files.refused);
    EXPECT_NE(files.refused->text().find("width"), std::string::npos) << files.refused->text();
    ask(OpenRequest{"not there.toml"});
    EXPECT_EQ(lab.document.session.hash(), before);
    EXPECT_TRUE(files.refused);
}

TEST_F(FileCommands, CommentsOfTheFileStayWhenItIsSaved) {
    ask(SaveRequest{"mine", FileKind::scene});
    put_text(folder / "mine.toml", "# by hand\n" + text_of(folder / "mine.toml"));
    ask(OpenRequest{"mine.toml"});
    EXPECT_EQ(files.save_to, (folder / "mine.toml").string());
    ask(SaveRequest{"mine.toml", FileKind::scene});
    EXPECT_TRUE(text_of(folder / "mine.toml").starts_with("# by hand\nformat = 1\n")) << text_of(folder / "mine.toml");
    ask(SaveRequest{"copy", FileKind::scene});
    EXPECT_EQ(text_of(folder / "copy.toml"), text_of(folder / "mine.toml"));
}

// The comments of the robots name the sources of their figures.
TEST_F(FileCommands, ACopyOfARobotKeepsTheSourcesOfItsFigures) {
    const fs::path robot = *find_shipped("2a-coward");
    for (const char* name : {"tt2wd-ldr", "thymio2", "romi", "e-puck2"}) {
        const fs::path file = robot.parent_path().parent_path() / "robots" / (std::string(name) + ".toml");
        ask(OpenRequest{file.string()});
        ASSERT_EQ(lab.document.name, name);
        ask(SaveRequest{"copy", FileKind::scene});
        const std::string text = text_of(file), copy = text_of(folder / "copy.toml");
        const auto comments = [](const std::string& all) { return std::count(all.begin(), all.end(), '#'); };
        EXPECT_GE(comments(copy), comments(text)) << name;
        EXPECT_GT(comments(text), 3) << name;
        fs::remove(folder / "copy.toml");
    }
}

TEST_F(FileCommands, ASceneOrARunOfAnExerciseDoesNotShowTheBrainThatItHides) {
    ask(OpenRequest{find_shipped("19-mystery")->string()});
    for (int i = 0; i < 400; ++i) tick(lab);
    const auto hash = lab.document.session.hash();
    ask(SaveRequest{"scene", FileKind::scene});
    ask(SaveRequest{"run", FileKind::run});
    const std::string scene = text_of(folder / "scene.toml"), run = text_of(folder / "run.run");
    EXPECT_EQ(scene.find("-1.6"), std::string::npos);
    EXPECT_EQ(run.find("wires"), std::string::npos);
    ask(OpenRequest{(folder / "run.run").string()});
    ASSERT_FALSE(lab.document.lesson);
    EXPECT_EQ(lab.document.session.hash(), hash);
    const Scene& opened = *lab.document.session.snapshot().scene;
    EXPECT_TRUE(opened.kinds[static_cast<std::size_t>(find_kind(opened, "mystery"))].hidden);
    EXPECT_FALSE(opened.kinds[static_cast<std::size_t>(find_kind(opened, "yours"))].hidden);
}

TEST_F(FileCommands, SavesABrainAndGivesItToAnotherVehicleAsOneStepOfUndo) {
    ask(SaveRequest{"shy", FileKind::brain});
    ASSERT_TRUE(fs::exists(folder / "shy.toml"));
    ask(OpenRequest{(*find_shipped("2b-aggressor")).string()});
    const FourNeurons before = dials();
    ask(OpenRequest{"shy.toml"});
    EXPECT_EQ(dials().LL, 1.5f);
    EXPECT_EQ(lab.document.name, "2b-aggressor");
    EXPECT_EQ(lab.document.session.undo_depth(), 1);
    handle(lab, Action::undo);
    EXPECT_EQ(dials(), before);
}

TEST_F(FileCommands, SavesARunAndContinuesItExactly) {
    for (int i = 0; i < 400; ++i) tick(lab);
    ask(SaveRequest{"later", FileKind::run});
    const auto hash = lab.document.session.hash();
    ask(OpenRequest{(*find_shipped("3a-love")).string()});
    ask(OpenRequest{"later.run"});
    EXPECT_EQ(lab.document.session.hash(), hash);
    EXPECT_EQ(lab.document.session.snapshot().tick, 400u);
    put_text(folder / "broken.run", text_of(folder / "later.run").substr(0, 500));
    ask(OpenRequest{"broken.run"});
    EXPECT_EQ(lab.document.session.hash(), hash) << "a broken file does not replace the document";
    EXPECT_TRUE(files.refused);
}

TEST_F(FileCommands, ReportsAFileThatCannotBeWritten) {
    ask(SaveRequest{nowhere.string(), FileKind::scene});
    EXPECT_EQ(files.done, 0);
    ASSERT_TRUE(files.refused);
    EXPECT_NE(files.refused->text().find(nowhere.string() + ".toml"), std::string::npos) << files.refused->text();
    EXPECT_EQ(lab.document.name, "2a-coward");
}

TEST_F(FileCommands, ListsFoldersFirstAndOnlyFilesOfTheProgram) {
    fs::create_directories(folder / "z");
    put_text(folder / "b.toml", "format = 1\n[brain]\nLL = 1\n");
    put_text(folder / "a.toml", "format = 1\n# why\n[kind.x]\n");
    put_text(folder / "e.toml", "format = 1\n[[step]]\n");
    put_text(folder / "notes.txt", "format = 1\n");
    put_text(folder / "alien.toml", "[package]\nname = 'x'\n");
    put_text(folder / ".hidden.toml", "format = 1\n[kind.x]\n");
    ask(BrowseRequest{folder.path.string()});
    std::vector<std::string> names;
    for (const FileEntry& entry : files.listing.entries) names.push_back(entry.name);
    EXPECT_EQ(names, (std::vector<std::string>{"z", "a.toml", "b.toml", "e.toml"}));
    EXPECT_EQ(files.listing.entries[1].kind, FileKind::scene);
    EXPECT_TRUE(files.listing.entries[1].comments);
    EXPECT_EQ(files.listing.entries[2].kind, FileKind::brain);
    EXPECT_EQ(files.listing.entries[3].kind, FileKind::exercise);
    ask(BrowseRequest{"/not/there"});
    EXPECT_NE(files.listing.problem, "");
}

TEST_F(FileCommands, OpensAFolderThatIsTyped) {
    fs::create_directories(folder / "deep");
    ask(OpenRequest{"deep"});
    EXPECT_EQ(files.listing.folder, (folder / "deep").string());
    EXPECT_EQ(files.done, 0);
    ask(OpenRequest{".."});
    EXPECT_EQ(files.listing.folder, folder.path.string());
}

TEST_F(FileCommands, ShowsSuccessAndFailureAsDifferentNotices) {
    ask(SaveRequest{"mine", FileKind::scene});
    EXPECT_EQ(lab.notice, (Notice{NoticeKind::done, "files.saved", "mine.toml"}));
    ask(OpenRequest{"nowhere.toml"});
    EXPECT_EQ(lab.notice.kind, NoticeKind::failure);
}

TEST_F(FileCommands, GivesEachOpenedDocumentAnotherRunId) {
    const auto before = lab.document.run_id;
    ask(OpenRequest{(*find_shipped("3a-love")).string()});
    EXPECT_NE(lab.document.run_id, before) << "histories of the other run are dropped";
}

}  // namespace
}  // namespace braitenlab::tests::file_commands_test
