// The outputs of every command of braitenctl: exit code 0 means written, and no input is overwritten.
#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/scene_file.h"
#include "tests/folder.h"
#include "tests/tools/ctl.h"

namespace braitenlab::tests::ctl_output_test {
namespace {

using ctl_runs::expect_refused;
fs::path study_in(const Folder& folder) {
    put_text(folder / "s.toml",
             "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nmeasures = [\"touch\"]\nseconds = 1\nseeds = 1\n"
             "[[value]]\nname = \"w\"\npaths = [\"kind.aggressor.brain.LR\"]\nlevels = [1]\n");
    return folder / "s.toml";
}

// A call of each command, and of each form of its output.
std::vector<std::string> calls_that_print(const Folder& folder) {
    const std::string study = study_in(folder).string(), out = (folder / "robot").string();
    const std::string bred = (folder / "bred").string(), hidden = (folder / "hidden.toml").string();
    auto mystery = load_scene(fs::path(BRAITENLAB_SOURCE) / "exercises/scenes/2b-aggressor.toml");
    mystery->kinds[0].hidden = true;
    put_text(hidden, write_scene(*mystery));
    EXPECT_EQ(ctl("breed flee --generations 1 --out " + bred).code, 0);
    return {"--help",
            "--version",
            "run --help",
            "run 2a-coward --seconds 1",
            "run 2a-coward --seconds 1 --json",
            "run 2a-coward --seconds 1 --hash",
            "run 2a-coward --seconds 1 --csv -",
            "map 2a-coward --size 2 --seconds 1",
            "map 2a-coward --size 2 --seconds 1 --json",
            "map 2a-coward --size 2 --seconds 1 --csv -",
            "robustness 2a-coward --robots 1 --seconds 1",
            "robustness 2a-coward --robots 1 --seconds 1 --json",
            "robustness 2a-coward --robots 1 --seconds 1 --csv -",
            "check 04-coward",
            "check 04-coward --json",
            "grade 04-coward 2a-coward",
            "show 2a-coward",
            "hashes --seconds 0",
            "export 2a-coward --to c --out " + out + " --force",
            "think 2a-coward --ticks 2 --vectors -",
            "breed " + bred + " --generations 1 --continue",
            "breed " + bred + " --generations 1 --continue --json",
            "breed " + bred + " --matrix master --csv -",
            "study " + study,
            "study " + study + " --json",
            "study " + study + " --csv -",
            "compare 2a-coward --a 2a-coward --b 2b-aggressor --seconds 1",
            "compare 2a-coward --a 2a-coward --b 2b-aggressor --seconds 1 --json",
            "mystery " + hidden + " --brain 2a-coward --starts 1",
            "mystery " + hidden + " --brain 2a-coward --starts 1 --json",
            "link 2a-coward",
            "link \"$(" BRAITENLAB_BINARY "/braitenctl link 2a-coward)\""};
}

TEST(CtlOutput, ThatCannotBeWrittenIsAFailureOfEveryCommand) {
    if (!fs::exists("/dev/full")) GTEST_SKIP();
    const Folder folder;
    for (const std::string& call : calls_that_print(folder)) {
        SCOPED_TRACE(call);
        const Ran whole = ctl(call), full = ctl(call + " > /dev/full");
        EXPECT_LT(whole.code, 2) << whole.out;
        EXPECT_FALSE(whole.out.empty());
        EXPECT_EQ(full.code, whole.code == 0 ? 2 : whole.code) << full.out;
        EXPECT_NE(full.out.find("braitenctl: standard output could not be written"), std::string::npos) << full.out;
    }
}

TEST(CtlOutput, EndsWithoutAWordAtAClosedPipe) {
    for (const char* before : {"", "trap '' PIPE; "}) {  // the second: started with the signal ignored
        const Ran ran =
            shell(std::string(before) + BRAITENLAB_BINARY "/braitenctl run predator-prey --csv - | head -n 1");
        EXPECT_TRUE(ran.out.starts_with("seconds,")) << ran.out;
        EXPECT_EQ(ran.out.find("braitenctl:"), std::string::npos) << ran.out;
    }
}

TEST(CtlOutput, OverAnInputIsRefusedAndTheInputStays) {
    const Folder folder;
    const std::string scene = (folder / "in.toml").string(), same = (folder / "same.toml").string(),
                      study = study_in(folder).string();
    fs::copy_file(fs::path(BRAITENLAB_SOURCE) / "exercises/scenes/2a-coward.toml", scene);
    fs::create_symlink(scene, same);
    const std::string text = text_of(scene), study_text = text_of(study);
    const std::string why = "names a file that this command reads";
    for (const std::string& output : {"--csv " + scene, "--csv " + same, "--save " + scene})
        expect_refused("run " + scene + " --seconds 1 " + output, why);
    expect_refused("map " + scene + " --size 2 --seconds 1 --csv " + scene, why);
    expect_refused("robustness " + scene + " --robots 1 --seconds 1 --csv " + scene, why);
    expect_refused("think " + scene + " --vectors " + scene, why);
    expect_refused("study " + study + " --csv " + study, why);
    EXPECT_EQ(text_of(scene), text);
    EXPECT_EQ(text_of(study), study_text);
}

TEST(CtlOutput, OverAFileOfAClassOrOfAStudyIsRefused) {
    const Folder folder;
    const std::string scene = (folder / "ana.toml").string(), marks = (folder / "marks.csv").string();
    fs::copy_file(fs::path(BRAITENLAB_SOURCE) / "exercises/scenes/2a-coward.toml", scene);
    const std::string text = text_of(scene), grade = "grade 04-coward " + folder.path.string();
    expect_refused(grade + " --csv " + scene, "would write over a scene");
    EXPECT_EQ(text_of(scene), text);
    EXPECT_NE(ctl(grade + " --csv " + marks).code, 2);
    EXPECT_NE(ctl(grade + " --csv " + marks).code, 2) << "a table of before is replaced";
}

TEST(CtlOutput, OfTwoKindsInOneFileIsRefused) {
    const Folder folder;
    const std::string both = (folder / "both.svg").string(), beside = (folder / ".").string() + "/both.svg";
    const std::string why = "names a file that another option writes";
    expect_refused("picture 2a-coward --wiring " + both + " --paths " + both, why);
    expect_refused("picture 2a-coward --wiring " + both + " --paths " + beside, why);
    EXPECT_FALSE(fs::exists(both));
}

TEST(CtlOutput, HasNothingThatATerminalActsUpon) {
    const Folder folder;
    put_text(folder / "s.toml",
             "format = 1\ntitle = \"a\\u001b[2Jb\\u009bc\\u202Ed "
             "\u00e4\\tz\\rP\"\nstory = \"\\u0007\"\n");
    const Ran shown = ctl("show " + (folder / "s.toml").string());
    EXPECT_EQ(shown.code, 0) << shown.out;
    EXPECT_NE(shown.out.find("a\uFFFD[2Jb\uFFFDc\uFFFDd \u00e4\tz\uFFFDP\n\uFFFD\n"), std::string::npos) << shown.out;
    const Ran refused = ctl("show \"$(printf 'x\\033]0;y.toml')\"");
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(refused.out.find('\033'), std::string::npos) << refused.out;
    EXPECT_NE(refused.out.find("x\uFFFD]0;y.toml"), std::string::npos) << refused.out;
}

}  // namespace
}  // namespace braitenlab::tests::ctl_output_test
