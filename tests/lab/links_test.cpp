// Links to the open document, and opening them.
#include "app/files/links.h"

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "app/files/file_commands.h"
#include "app/lab_requests.h"
#include "core/io/link.h"
#include "core/scene/scene_file.h"
#include "tests/folder.h"

namespace braitenlab::tests::links_test {
namespace {

struct Links : testing::Test {
    Folder folder;
    FilesView files;
    StoredState state;
    UserFolders folders{.home = folder.path, .pictures = folder / "Pictures", .documents = folder / "Documents"};
    Lab lab = open("2a-coward");

    static Lab open(const char* name) {
        auto opened = open_lab(*find_shipped(name), std::nullopt, {});
        return std::move(*opened);
    }
    void ask(const Request& request) {
        handle(lab, request);
        execute_file_requests(lab, files, state, folders);
    }
    std::string copied() {
        ask(Action::copy_link);
        return std::exchange(lab.window.to_copy, {});
    }
    float LR() const { return read_dials(*lab.document.session.snapshot().kind_brains[0]).LR; }
    static Lab of_scene(const Scene& scene) {
        auto document = linked_document(scene);
        return make_lab(std::move(*document));
    }
    void edit(float LR) { ask(EditRequest{TurnDial{{.kind = 0}, Dial::LR, LR}}); }
};

TEST_F(Links, HoldTheEditedScene) {
    edit(1.25f);
    const std::string link = copied();
    EXPECT_EQ(lab.notice.key, "notice.link");
    EXPECT_EQ(lab.notice.words, std::to_string(link.size()));
    lab = open("3a-love");
    ask(OpenRequest{link});
    EXPECT_EQ(LR(), 1.25f);
    EXPECT_EQ(lab.document.session.scene().title, open("2a-coward").document.session.scene().title);
    EXPECT_TRUE(lab.document.path.empty());
    EXPECT_FALSE(lab.document.lesson);
    EXPECT_FALSE(has_unsaved_edits(lab));
    EXPECT_TRUE(state.recent.empty()) << "a link is no file";
}

TEST_F(Links, BeginWithTheAddressOfTheLab) {
    lab.link_base = "https://lab.example/";
    EXPECT_TRUE(copied().starts_with("https://lab.example/#b1."));
}

TEST_F(Links, OfALinkedSceneAreTheSameAgain) {
    edit(1.25f);
    const std::string link = copied();
    ask(LeaveRequest{Leave::discard});
    ask(OpenRequest{link});
    ask(LeaveRequest{Leave::discard});
    EXPECT_EQ(copied(), link);
}

TEST_F(Links, AreOpenedAfterTheQuestionAboutUnsavedEdits) {
    const std::string link = copied();
    lab = open("3a-love");
    edit(1.75f);
    ask(OpenRequest{link});
    ASSERT_TRUE(files.leaving);
    EXPECT_EQ(files.leaving->next, link);
    EXPECT_EQ(LR(), 1.75f) << "nothing is lost before the answer";
    ask(LeaveRequest{Leave::stay});
    EXPECT_EQ(LR(), 1.75f);
    ask(OpenRequest{link});
    ask(LeaveRequest{Leave::discard});
    EXPECT_NE(LR(), 1.75f);
    EXPECT_FALSE(files.leaving);
}

TEST_F(Links, ThatAreBrokenLeaveTheOpenWorkAlone) {
    const std::string link = copied();
    edit(1.75f);
    std::string damaged = link;
    damaged[link.size() / 2] = damaged[link.size() / 2] == 'A' ? 'B' : 'A';
    for (const std::string& broken :
         {link.substr(0, link.size() / 2), damaged, std::string("#b7.abc"), std::string("#b1.a b"),
          std::string("#e1.no-such-exercise"), std::string("#bGARBAGE"), std::string("#b")}) {
        files.refused.reset();
        ask(OpenRequest{broken});
        EXPECT_FALSE(files.leaving) << broken;
        ASSERT_TRUE(files.refused) << broken;
        EXPECT_FALSE(files.refused->phrases.empty()) << "it is translated: " << broken;
        EXPECT_EQ(LR(), 1.75f);
        EXPECT_TRUE(has_unsaved_edits(lab));
    }
}

TEST_F(Links, ToAShippedExerciseHaveItsName) {
    lab = open("05-aggressor");
    const std::string link = copied();
    EXPECT_EQ(link, "#e1.05-aggressor");
    EXPECT_EQ(lab.notice.key, "notice.link_exercise");
    lab = open("3a-love");
    ask(OpenRequest{"https://lab.example/" + link});
    ASSERT_TRUE(lab.document.lesson);
    EXPECT_EQ(lab.document.lesson->exercise->id, "05-aggressor");
}

TEST_F(Links, HoldTheStudentsBrainOnceTheVehicleOfAnExerciseIsChanged) {
    lab = open("05-aggressor");
    edit(1.25f);
    const std::string link = copied();
    EXPECT_EQ(lab.notice.key, "notice.link_work");
    lab = open("3a-love");
    ask(OpenRequest{link});
    EXPECT_EQ(LR(), 1.25f);
    EXPECT_FALSE(lab.document.lesson);
}

TEST_F(Links, ThatChatProgramsCutAreReported) {
    // Random digits cannot be compressed much.
    const auto with_story = [&](std::size_t length) {
        std::string story;
        maths::Random random(3, 0);
        while (story.size() < length) story += static_cast<char>('!' + random.next() % 90);
        Scene scene = lab.document.session.scene();
        scene.story = story;
        for (char& c : scene.story) c = c == '"' || c == '\\' ? 'x' : c;
        return scene;
    };
    lab = of_scene(with_story(1900));
    (void)copied();
    EXPECT_EQ(lab.notice.key, "notice.link_long") << lab.notice.words;
    Scene scene = with_story(1900);
    maths::Random random(5, 0);
    for (int i = 0; i < 1000; ++i)
        scene.sources.push_back(
            {"lamp" + std::to_string(i), Channel::light, random.uniform(-5, 5), random.uniform(-5, 5)});
    lab = of_scene(scene);
    (void)copied();
    EXPECT_EQ(lab.notice.key, "notice.link_too_long") << lab.notice.words;
    EXPECT_EQ(lab.notice.more, "8000");
}

TEST_F(Links, NameTheDocumentAfterItsTitle) {
    Scene scene = lab.document.session.scene();
    scene.title = " Ben's 2nd coward! ";
    EXPECT_EQ(linked_document(scene)->name, "ben-s-2nd-coward");
    scene.title = "…";
    EXPECT_EQ(linked_document(scene)->name, "link");
}

}  // namespace
}  // namespace braitenlab::tests::links_test
