// The outputs of every command of braitenctl: exit code 0 means written, and no input is overwritten.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/scene/scene_file.h"
#include "core/utf8.h"
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
            "check 04-coward --brain 2b-aggressor",
            "grade 04-coward 2a-coward",
            "show 2a-coward",
            "hashes --seconds 0",
            "hashes --seconds 0 --compare " BRAITENLAB_SOURCE "/tests/golden/hashes.json",
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
        EXPECT_EQ(full.code, 2) << full.out;
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
    expect_refused(grade + " --csv " + scene, "names a file that this command reads");
    EXPECT_EQ(text_of(scene), text);
    EXPECT_NE(ctl(grade + " --csv " + marks).code, 2);
    EXPECT_NE(ctl(grade + " --csv " + marks).code, 2) << "a table of before is replaced";
}

// Expects that each call is refused, with these words where they are given, and that every file of the folder stays.
struct Refusals {
    fs::path folder;
    std::map<std::string, std::string> texts() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            all[entry.path().string()] = entry.is_regular_file() ? text_of(entry.path()) : "";
        return all;
    }
    void expect(const std::vector<std::string>& calls, const std::string& words) const {
        const auto before = texts();
        for (const std::string& call : calls) {
            const Ran ran = shell("cd " + folder.string() + " && " BRAITENLAB_BINARY "/braitenctl " + call);
            EXPECT_EQ(ran.code, 2) << call << "\n" << ran.out;
            EXPECT_NE(ran.out.find(words), std::string::npos) << call << "\n" << ran.out;
            EXPECT_TRUE(texts() == before) << call;
        }
    }
};

TEST(CtlOutput, OverAFileOfABreedingIsRefused) {
    const Folder folder;
    ASSERT_EQ(ctl("breed flee --generations 1 --out " + (folder / "ch").string()).code, 0);
    fs::create_symlink("ch/state.json", folder / "link.csv");
    const Refusals refusals{folder.path};
    std::vector<std::string> calls{"breed ch --csv link.csv"};
    for (const std::string file : {"ch/state.json", "ch/scene.toml", "ch/breeding.toml"})
        for (const char* output : {"--csv ", "--match 0:0 --out ", "--champion prey:0 --out "})
            calls.push_back("breed ch " + (output + file));
    refusals.expect(calls, "names a file that this command reads");
    refusals.expect({"run 2a-coward --seconds 1 --csv ch/state.json"}, "would write over");
    put_text(folder / "mine" / "scene.toml", "format = 1\n");
    refusals.expect({"breed flee --out mine"}, "the breeding would write over this file");
    EXPECT_EQ(
        ctl("breed " + (folder / "ch").string() + " --champion prey:0 --out " + (folder / "b.toml").string()).code, 0);
    EXPECT_EQ(ctl("breed " + (folder / "ch").string() + " --match 0:0 --out " + (folder / "b.toml").string()).code, 0)
        << "a scene replaces a brain";
}

TEST(CtlOutput, OfSeveralFilesIsWholeOrNoneOnAFullDisk) {
    const Folder folder;
    ASSERT_EQ(ctl("breed flee --generations 1 --out " + (folder / "ch").string()).code, 0);
    const std::string report = (folder / "report").string();
    const Ran full = shell("trap '' XFSZ; ulimit -f 3; " BRAITENLAB_BINARY "/braitenctl breed " +
                           (folder / "ch").string() + " --report " + report);
    EXPECT_NE(full.out.find("make room"), std::string::npos) << full.out;
    EXPECT_FALSE(fs::exists(report)) << "on a full disk no file of the report is left";
}

TEST(CtlOutput, OverAFileThatAFileNamesIsRefused) {
    const Folder folder;
    const fs::path shipped = fs::path(BRAITENLAB_SOURCE) / "exercises";
    put_text(folder / "bare.txt", "format = 1\n");  // a scene by the study alone
    put_text(folder / "bare.toml", "format = 1\nscene = \"bare.txt\"\n[[value]]\n");
    put_text(folder / "guided" / "e.toml", text_of(shipped / "guided" / "05-aggressor.toml"));
    put_text(folder / "scenes" / "2a-coward.toml", text_of(shipped / "scenes" / "2a-coward.toml"));
    put_text(folder / "scenes" / "2b-aggressor.toml", text_of(shipped / "scenes" / "2b-aggressor.toml"));
    put_text(folder / "class" / "anna.txt", "an answer in words\n");
    fs::create_symlink("bare.txt", folder / "link.csv");
    fs::create_symlink("class/anna.txt", folder / "an.csv");
    fs::create_symlink("scenes/2b-aggressor.toml", folder / "scene.csv");
    put_text(folder / "list.csv", "a,b\n");
    const std::string grade = "grade guided/e.toml class ";
    Refusals{folder.path}.expect(
        {"study bare.toml --csv bare.txt", "study bare.toml --csv link.csv",
         "robustness guided/e.toml --robots 1 --csv scene.csv", grade + "--csv an.csv", grade + "--html an.csv",
         grade + "--gradebook csv --marks an.csv", grade + "--html scene.csv",
         grade + "--gradebook csv --list list.csv --marks list.csv",
         "run scenes/2a-coward.toml --csv - >> scenes/2a-coward.toml"},
        "a file that this command reads");
}

TEST(CtlOutput, OverAFileOfTheLabIsRefusedWhateverItsName) {
    const Folder folder;
    const fs::path shipped = fs::path(BRAITENLAB_SOURCE) / "exercises";
    std::vector<std::string> works{"scene.txt", "exercise.txt", "study.txt", "lecture.txt", "breeding.txt",
                                   "brain.txt", "run.txt",      "zip.txt",   "hand-in.txt"};
    put_text(folder / "scene.txt", text_of(shipped / "scenes" / "2a-coward.toml"));
    put_text(folder / "exercise.txt", text_of(shipped / "guided" / "05-aggressor.toml"));
    put_text(folder / "study.txt", text_of(study_in(folder)));
    put_text(folder / "lecture.txt", text_of(shipped / "lectures" / "four-numbers.toml"));
    put_text(folder / "breeding.txt", text_of(shipped / "breeding" / "flee.toml"));
    put_text(folder / "brain.txt", "[brain]\nLL = 1\n");
    put_text(folder / "hand-in.txt", "format = 1\n[submission.brain]\nLL = 1\n");
    put_text(folder / "zip.txt", "PK\x03\x04");
    ASSERT_EQ(ctl("run 2a-coward --seconds 1 --save " + (folder / "a.run").string()).code, 0);
    put_text(folder / "run.txt", text_of(folder / "a.run"));
    std::vector<std::string> calls{"run 2a-coward --seconds 1 --csv a.run", "map 2a-coward --png a.run.png"};
    fs::create_symlink("scene.txt", folder / "a.run.png");
    fs::create_symlink("scene.txt", folder / "b.run");
    calls.push_back("run 2a-coward --seconds 1 --save b.run");
    const std::string link = shell(BRAITENLAB_BINARY "/braitenctl link 2a-coward").out;
    const std::string link_to = "link '" + link.substr(0, link.find('\n')) + "' --out ";
    for (const std::string& work : works) {
        calls.push_back("run 2a-coward --seconds 1 --csv " + work);
        if (work != "scene.txt" && work != "brain.txt") calls.push_back(link_to + work);
    }
    const Refusals refusals{folder.path};
    refusals.expect(calls, "would write over a scene");
    refusals.expect({"run 2a-coward --seconds 1 --save b.toml"}, "end its name with it");
    for (const std::string& call : {link_to + "scene.txt", std::string("run 2a-coward --seconds 1 --save a.run")}) {
        const Ran again = shell("cd " + folder.path.string() + " && " BRAITENLAB_BINARY "/braitenctl " + call);
        EXPECT_EQ(again.code, 0) << call << again.out;
    }
}

TEST(CtlOutput, OfAnExportOverAnInputWorkOrStandardOutputIsRefused) {
    const Folder folder;
    const std::string scene = text_of(fs::path(BRAITENLAB_SOURCE) / "exercises/scenes/2a-coward.toml");
    const Refusals refusals{folder.path};
    for (const auto& [target, name] : {std::pair("c", "brain.h"), {"opamp", "parts.csv"}, {"thymio", "README.md"}}) {
        const std::string out = std::string("e-") + target, file = out + "/" + name;
        const std::string to = std::string(" --to ") + target + " --out " + out;
        ASSERT_EQ(
            shell("cd " + folder.path.string() + " && " BRAITENLAB_BINARY "/braitenctl export 2a-coward" + to).code, 0);
        EXPECT_EQ(
            shell("cd " + folder.path.string() + " && " BRAITENLAB_BINARY "/braitenctl export 2a-coward" + to).code, 0)
            << "over an earlier one";
        refusals.expect({"export 2a-coward" + to + " >> " + file}, "would be replaced");
        put_text(folder / file, scene);
        refusals.expect({"export " + file + to + " --force"}, "would be replaced");
        refusals.expect({"export 2a-coward" + to + " --force"}, "is a scene");
        EXPECT_EQ(text_of(folder / file), scene);
    }
}

TEST(CtlOutput, WithAnEmptyNameIsRefused) {
    const Folder folder;  // into which a program that takes the name would write
    Refusals{folder.path}.expect(
        {"run 2a-coward --csv ''", "picture 2a-coward --wiring ''", "think 2a-coward --vectors ''",
         "export 2a-coward --to c --out ''", "map 2a-coward --png ''"},
        "has an empty name");
}

TEST(CtlOutput, AnUnknownOptionIsRefusedWithTheNearestOne) {
    for (const char* call : {"map 2a-coward --mesure behaviour", "map 2a-coward --mesure=behaviour"})
        expect_refused(call, "--measure");
    expect_refused("run 2a-coward --secnds 3", "--seconds");
}

TEST(CtlOutput, ThatCannotBeWrittenIsRefusedBeforeTheWork) {
    const Folder folder;
    study_in(folder);
    fs::create_symlink("pipe", folder / "p.run");
    const std::string grade = "grade 04-coward 2a-coward ", long_run = "run 2a-coward --seconds 1000000 ";
    const Refusals refusals{folder.path};
    refusals.expect({grade + "--html -", "study s.toml --svg -"}, "give the name of a file");
    fs::create_directory(folder / "d.run");
    refusals.expect({long_run + "--save d.run", long_run + "--csv d.run"}, "could not be saved");
    if (fs::exists("/dev/full")) refusals.expect({"study s.toml --csv /dev/full"}, "is not a regular file");
    ASSERT_EQ(shell("mkfifo " + (folder / "pipe").string()).code, 0);
    EXPECT_NE(ctl(long_run + "--save " + (folder / "p.run").string()).out.find("is not a regular file"),
              std::string::npos);
}

TEST(CtlOutput, OfTwoKindsInOneFileIsRefused) {
    const Folder folder;
    const std::string both = (folder / "both.svg").string(), beside = (folder / ".").string() + "/both.svg";
    const std::string why = "names a file that another option writes";
    expect_refused("picture 2a-coward --wiring " + both + " --paths " + both, why);
    expect_refused("picture 2a-coward --wiring " + both + " --paths " + beside, why);
    EXPECT_FALSE(fs::exists(both));
    fs::create_symlink("none.csv", folder / "m.csv");
    const std::string grade = "grade 04-coward 2a-coward --gradebook csv ";
    Refusals{folder.path}.expect({grade + "--csv a.csv --marks a.csv", grade + "--html a.html --marks a.html",
                                  grade + "--csv m.csv --marks none.csv", grade + "--csv - --marks -"},
                                 why);
}

TEST(CtlOutput, ATableIsUtf8WithoutControlCharactersWhateverTheNamesOfFiles) {
    const Folder folder;
    std::error_code refused;
    fs::create_directories(folder / "class");
    const fs::path scene = fs::path(BRAITENLAB_SOURCE) / "exercises/scenes/2a-coward.toml";
    fs::copy_file(scene, folder / "class" / "bad\xFF\x1B[2J.toml", refused);
    if (refused) GTEST_SKIP() << "this system allows no such names";
    const std::string csv = (folder / "a.csv").string(), marks = (folder / "m.csv").string();
    const std::string grade = "grade 04-coward " + (folder / "class").string() + " --csv " + csv;
    ASSERT_LT(ctl(grade + " --gradebook csv --marks " + marks).code, 2);
    for (const std::string& file : {csv, marks}) {
        const std::string text = text_of(file);
        EXPECT_NE(text.find("bad\uFFFD\uFFFD[2J"), std::string::npos) << text;
        EXPECT_TRUE(is_utf8(text));
        EXPECT_EQ(text.find('\033'), std::string::npos) << text;
    }
}

TEST(CtlOutput, InJsonIsUtf8WhateverAFileIsCalled) {
    const Folder folder;
    const fs::path exercise = fs::path(BRAITENLAB_SOURCE) / "exercises" / "guided" / "05-aggressor.toml";
    const fs::path named = folder / "guided" / "ex\xff.toml";
    fs::create_directories(named.parent_path());
    std::error_code refused;  // some systems have no such names
    fs::copy_file(exercise, named, refused);
    if (refused) GTEST_SKIP() << refused.message();
    fs::copy(exercise.parent_path().parent_path() / "scenes", folder / "scenes");
    const std::string brain = (exercise.parent_path().parent_path() / "scenes" / "2b-aggressor.toml").string();
    const Ran ran = ctl("check '" + named.string() + "' --brain " + brain + " --json");
    EXPECT_LE(ran.code, 1) << ran.out;
    EXPECT_NE(ran.out.find("\"exercise\": \"ex\uFFFD\""), std::string::npos) << ran.out;
}

TEST(CtlOutput, ThatWouldNotBeWrittenIsRefused) {
    const Folder folder;
    const std::string study = "study " + study_in(folder).string(), bred = "breed " + (folder / "bred").string();
    ASSERT_EQ(ctl("breed flee --generations 1 --out " + (folder / "bred").string()).code, 0);
    const Refusals refused{folder.path};
    refused.expect({"link 2a-coward --out l.toml"}, "only the scene of a link is written");
    refused.expect({study + " --title T", "map 2a-coward --size 2 --seconds 1 --x-label x"}, "requires --svg");
    const std::string champion = " --champion prey:1", match = " --match 1:1", report = " --report r", out = " --out o";
    refused.expect(
        {bred + champion + out + " --csv c.csv", bred + champion + match + out, bred + report + " --svg s.svg",
         bred + match + out + " --matrix ciao", bred + report + champion + out},
        "excludes");
    EXPECT_EQ(ctl(bred + " --title T --report " + (folder / "r").string()).code, 0) << "a title of all drawings";
}

TEST(CtlOutput, HasNothingThatATerminalActsUpon) {
    const Folder folder;
    put_text(folder / "s.toml",
             "format = 1\ntitle = \"a\\u001b[2Jb\\u009bc\\u202Ed "
             "\u00e4\\tz\\rP\\u2028Q\"\nstory = \"\\u0007\"\n");
    const Ran shown = ctl("show " + (folder / "s.toml").string());
    EXPECT_EQ(shown.code, 0) << shown.out;
    EXPECT_NE(shown.out.find("a\uFFFD[2Jb\uFFFDc\uFFFDd \u00e4\tz\uFFFDP\uFFFDQ\n\uFFFD\n"), std::string::npos)
        << shown.out;
    const Ran refused = ctl("show \"$(printf 'x\\033]0;y.toml')\"");
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(refused.out.find('\033'), std::string::npos) << refused.out;
    EXPECT_NE(refused.out.find("x\uFFFD]0;y.toml"), std::string::npos) << refused.out;
}

TEST(CtlOutput, HasNoLineThatATitleANameOrAPathMakesUp) {
    const Folder folder;
    const fs::path shipped = fs::path(BRAITENLAB_SOURCE) / "exercises";
    const auto put = [&](const char* name, std::string text, const std::string& old, const std::string& fresh) {
        const auto at = text.find(old);
        ASSERT_NE(at, text.npos) << old;
        put_text(folder / name, text.replace(at, old.size(), fresh));
    };
    put_text(folder / "s.toml", "format = 1\nname = \"a\\nfaked\"\ntitle = \"b\\r\\nfaked\"\nstory = \"c\\nfaked\"\n");
    put("exercise.toml", text_of(shipped / "guided" / "05-aggressor.toml"), "text = \"It turns",
        "text = \"It\\nfaked turns");
    put_text(folder / "scenes" / "2b-aggressor.toml", text_of(shipped / "scenes" / "2b-aggressor.toml"));
    put("exercise.toml", text_of(folder / "exercise.toml"), "../scenes", "scenes");
    std::error_code refused;
    fs::create_directories(folder / "class" / "d\nfaked", refused);
    if (refused) GTEST_SKIP() << "this system allows no such names";
    put_text(folder / "class" / "notes\nfaked.bin", "x");
    fs::copy_file(shipped / "scenes" / "2a-coward.toml", folder / "class" / "a.toml");
    const std::string fake = "\"$(printf 'x\\nfaked')\"";
    for (const std::string& call :
         {std::string("show s.toml"), std::string("run s.toml --seconds 0"),
          std::string("check exercise.toml --brain 2a-coward"), "show " + fake, "run 2a-coward " + fake,
          "run 2a-coward --threads " + fake, "export 2a-coward --to c --out " + fake, "nothing" + fake,
          std::string("grade 04-coward class --csv a.csv")}) {
        const Ran ran = shell("cd " + folder.path.string() + " && " BRAITENLAB_BINARY "/braitenctl " + call);
        EXPECT_NE(ran.out.find("faked"), std::string::npos) << call << "\n" << ran.out;
        EXPECT_EQ(ran.out.find("\nfaked"), std::string::npos) << call << "\n" << ran.out;
        EXPECT_EQ(ran.out.find('\r'), std::string::npos) << call << "\n" << ran.out;
    }
}

}  // namespace
}  // namespace braitenlab::tests::ctl_output_test
