// braitenctl export and think: files, exit codes and messages.
#include "core/brain/four_neurons.h"
#include "core/lesson/hand_in.h"
#include "tests/robots/exported.h"

namespace braitenlab::tests::ctl_export_test {
namespace {

std::set<std::string> files_in(const fs::path& folder) {
    std::set<std::string> names;
    if (!fs::exists(folder)) return names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) names.insert(fs::relative(entry.path(), folder).generic_string());
    return names;
}

TEST(CtlExport, WritesTheFilesOfATargetAndPrintsTheirNames) {
    const Folder folder;
    const std::string out = (folder / "new" / "robot").string();
    const Ran ran = ctl("export 3a-love --to arduino --out " + out);
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_EQ(files_in(out), (std::set<std::string>{"README.md", "parts.csv", "wiring.svg", "braitenberg/brain.h",
                                                    "braitenberg/braitenberg.ino"}));
    EXPECT_NE(ran.out.find(out + "/README.md\n"), std::string::npos) << ran.out;
    EXPECT_NE(text_of(fs::path(out) / "README.md").find("3a-love, kind lover"), std::string::npos);
}

TEST(CtlExport, RefusesWithTheNameOfThePartAndWritesNothing) {
    const Folder folder;
    const Ran ran = ctl("export tortoise --to thymio --out " + (folder / "t").string());
    EXPECT_EQ(ran.code, 2);
    EXPECT_NE(ran.out.find("tortoise: the sensor 'EN' senses energy"), std::string::npos) << ran.out;
    EXPECT_EQ(files_in(folder / "t"), std::set<std::string>{});
}

TEST(CtlExport, NamesTheKnownTargetsAndRobots) {
    const Ran target = ctl("export 3a-love --to arduin --out x"),
              robot = ctl("export 3a-love --to c --robot thymio --out x");
    EXPECT_EQ(target.code, 2);
    EXPECT_NE(target.out.find("'arduino'"), std::string::npos) << target.out;
    EXPECT_EQ(robot.code, 2);
    EXPECT_NE(robot.out.find("'thymio2'"), std::string::npos) << robot.out;
    EXPECT_EQ(ctl("export no-such-brain --to c --out x").code, 2);
}

TEST(CtlExport, TakesTheBrainOfAKindAPresetAndABrainFile) {
    const Folder folder;
    const std::string out = " --to c --out " + folder.path.string();
    const auto header = [&](const std::string& brain) {
        const Ran ran = ctl("export " + brain + out);
        EXPECT_EQ(ran.code, 0) << ran.out;
        return text_of(folder / "brain.h");
    };
    EXPECT_NE(header("predator-prey --kind prey"), header("predator-prey --kind predator"));
    EXPECT_NE(header("prey").find("\"prey\""), std::string::npos);
    const std::string scene = (folder / "two.toml").string();
    put_text(scene,
             "format = 1\n[kind.k.brain]\nLL = 0.5\n[vehicle.a]\nkind = \"k\"\n[vehicle.b]\nkind = \"k\"\nx = 3\n"
             "[vehicle.b.brain]\nLL = 0.875\n");
    EXPECT_NE(header(scene + " --vehicle a").find("0.5f"), std::string::npos);
    EXPECT_NE(header(scene + " --vehicle b").find("0.875f"), std::string::npos);  // a brain of its own
    put_text(folder / "mine.toml", "format = 1\n[brain]\nLL = 0.75\n");
    EXPECT_NE(header((folder / "mine.toml").string()).find("0.75f"), std::string::npos);
}

TEST(CtlExport, TakesTheBrainOfAHandIn) {
    const Folder folder;
    HandIn made{.student = "Ana", .exercise = "05-aggressor"};
    made.submission.brain = make_graph({.LR = 0.625f, .RL = 0.625f});
    made.submission.sensors = {Sensor{.name = "SL"}, Sensor{.name = "SR"}};
    const std::string file = (folder / "05-aggressor-ana.braiten-handin.toml").string();
    put_text(file, write_hand_in(made));
    const Ran ran = ctl("export " + file + " --to arduino --out " + (folder / "robot").string());
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_NE(text_of(folder / "robot" / "braitenberg" / "brain.h").find("0.625f"), std::string::npos);
    EXPECT_NE(text_of(folder / "robot" / "README.md").find("\"05-aggressor-ana, hand-in of Ana\""), std::string::npos);
}

TEST(CtlExport, WritesIntoAFolderOfOtherFilesOnlyByForce) {
    const Folder folder;
    put_text(folder / "README.md", "my notes");
    const std::string out = "export 3a-love --to c --out " + folder.path.string();
    const Ran refused = ctl(out);
    EXPECT_EQ(refused.code, 2);
    EXPECT_NE(refused.out.find("holds other files than those of an export"), std::string::npos) << refused.out;
    EXPECT_EQ(text_of(folder / "README.md"), "my notes");
    EXPECT_FALSE(fs::exists(folder / "brain.h"));
    EXPECT_EQ(ctl(out + " --force").code, 0);
    EXPECT_NE(text_of(folder / "README.md"), "my notes");
    EXPECT_EQ(ctl("export 2a-coward --to c --out " + folder.path.string()).code, 0) << "an earlier export is replaced";
}

TEST(CtlExport, ReplacesOrRemovesAFileThatAPersonHasEditedOnlyByForce) {
    for (const char* name : {"main.py", "README.md", "parts.csv"})
        for (const char* next : {"micropython", "c"}) {
            const Folder folder;
            const fs::path edited = folder / name;
            const std::string out = " --out " + folder.path.string() + " --to ";
            ASSERT_EQ(ctl("export 3a-love" + out + "micropython").code, 0);
            ASSERT_TRUE(fs::exists(edited)) << name;
            ASSERT_EQ(ctl("export 2a-coward" + out + "micropython").code, 0) << "none is edited";
            const std::string mine = text_of(edited) + "mine\n";
            put_text(edited, mine);
            const Ran ran = ctl("export 3a-love" + out + next);
            EXPECT_EQ(ran.code, 2) << name << next;
            EXPECT_NE(ran.out.find(std::string("not as an export wrote them: ") + name + ";"), std::string::npos)
                << ran.out;
            EXPECT_EQ(text_of(edited), mine);
            EXPECT_EQ(ctl("export 3a-love --force" + out + next).code, 0);
            EXPECT_FALSE(fs::exists(edited) && text_of(edited) == mine);
        }
}

TEST(CtlExport, WarnsOfAWheelThatACircuitNeverTurns) {
    const Folder folder;
    const Ran ran = ctl("export 3a-love --to opamp --out " + (folder / "c").string());
    EXPECT_EQ(ran.code, 0) << ran.out;
    EXPECT_NE(ran.out.find("braitenctl: warning: the wheel of 'ML' may never turn: its command is 0.50 at most"),
              std::string::npos)
        << ran.out;
}

TEST(CtlExport, RemovesWhatAnEarlierExportWroteAndThisOneDoesNot) {
    const Folder folder;
    const std::string out = " --out " + folder.path.string();
    ASSERT_EQ(ctl("export 3a-love --to opamp" + out).code, 0);
    put_text(folder / "wiring-2.svg", "the second sheet of a larger circuit");
    put_text(folder / "notes.txt", "mine");
    put_text(folder / "main.py", "mine, with a name that exports give, too");
    ASSERT_EQ(ctl("export 3a-love --to arduino" + out).code, 0);
    EXPECT_EQ(files_in(folder.path),
              (std::set<std::string>{"README.md", "braitenberg/braitenberg.ino", "braitenberg/brain.h", "main.py",
                                     "notes.txt", "parts.csv", "wiring.svg"}));
    ASSERT_EQ(ctl("export 3a-love --to c" + out).code, 0);
    EXPECT_EQ(files_in(folder.path), (std::set<std::string>{"README.md", "brain.h", "main.py", "notes.txt"}));
    EXPECT_FALSE(fs::exists(folder / "braitenberg"));
    put_text(folder / "braitenberg", "a compiled program");
    ASSERT_EQ(ctl("export 3a-love --to c" + out).code, 0);
    EXPECT_TRUE(fs::exists(folder / "braitenberg"));
}

TEST(CtlExport, KeepsTheFilesOfAFolderThatHoldsNoExport) {
    const Folder folder;
    put_text(folder / "README.md", "my robot");
    put_text(folder / "brain.py", "my program");
    ASSERT_EQ(ctl("export 3a-love --to c --force --out " + folder.path.string()).code, 0);
    EXPECT_EQ(files_in(folder.path), (std::set<std::string>{"README.md", "brain.h", "brain.py"}));
}

TEST(CtlExport, RefusesLinksInItsFolderAndTheirTargetsStay) {
    for (const std::string link : {"README.md", "braitenberg", "braitenberg/brain.h"}) {
        const Folder folder, elsewhere;
        const fs::path own = folder / link;
        std::map<fs::path, std::string> mine{{elsewhere / "mine.txt", "mine"}};
        if (link == "braitenberg") mine[elsewhere / "brain.h"] = "exported from Braitenlab, and kept";
        for (const auto& [file, text] : mine) put_text(file, text);
        put_text(folder / "README.md", "Exported from Braitenlab.");
        fs::remove(own);
        fs::create_directories(own.parent_path());
        fs::create_symlink(link == "braitenberg" ? elsewhere.path : elsewhere / "mine.txt", own);
        const auto before = files_in(folder.path);
        for (const char* target : {"arduino", "c"}) {
            if (link == "braitenberg/brain.h" && std::string(target) == "c") continue;  // C has no such file
            const Ran ran =
                ctl(std::string("export 3a-love --force --to ") + target + " --out " + folder.path.string());
            EXPECT_EQ(ran.code, 2) << link << ran.out;
            EXPECT_NE(ran.out.find(own.string() + ": is a link"), std::string::npos) << ran.out;
            EXPECT_EQ(files_in(folder.path), before);
        }
        for (const auto& [file, text] : mine) EXPECT_EQ(text_of(file), text) << link;
    }
}

TEST(CtlExport, RefusesABrainThatReadsASensorWhichTheVehicleLacks) {
    const Folder folder;
    const std::string scene = (folder / "typing-error.toml").string();
    put_text(scene,
             "format = 1\n[kind.k.sensor.SL]\n[kind.k.sensor.OM]\nchannel = \"obstacle\"\n[kind.k.brain]\nLL = 1\n"
             "[[kind.k.brain.node]]\nname = \"OX\"\nkind = \"sensor\"\n"
             "[[kind.k.brain.wire]]\nfrom = \"OX\"\nto = \"MR\"\n[vehicle.a]\nkind = \"k\"\n");
    for (const char* target : {"c", "arduino", "micropython", "thymio", "opamp"}) {
        const Ran ran = ctl("export " + scene + " --to " + target + " --out " + (folder / target).string());
        EXPECT_EQ(ran.code, 2) << target;
        EXPECT_NE(ran.out.find("'OX'"), std::string::npos) << ran.out;
    }
}

TEST(CtlExport, TakesTheSceneOfARobotByItsBareName) {
    for (const auto& entry : fs::directory_iterator(*data_folder() / "exercises" / "robots"))
        EXPECT_EQ(ctl("show " + entry.path().stem().string()).code, 0) << entry.path();
}

TEST(CtlExport, AMissingTargetIsAnsweredWithAllTargets) {
    const Ran ran = ctl("export 3a-love --out x");
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.out, "braitenctl: --to: is missing; give one of c, arduino, thymio, micropython, opamp\n");
}

TEST(CtlExport, TheReadmeOfCAndOfAThymioNamesEverySensor) {
    const Folder folder;
    const std::string out = (folder / "c").string();
    ASSERT_EQ(ctl("export 2a-coward --to c --out " + out).code, 0);
    const std::string in_c = text_of(fs::path(out) / "README.md");
    EXPECT_NE(in_c.find("| SL | `sensor_SL` | light |"), std::string::npos) << in_c;
    EXPECT_NE(
        in_c.find("    for (;;) {                          /* 60 times per second */\n"
                  "        brain.sensor_SL = ...;\n        brain.sensor_SR = ...;\n        brain_think(&brain);\n"),
        std::string::npos)
        << in_c;
    EXPECT_NE(in_c.find("60 times per second"), std::string::npos);
    ASSERT_EQ(ctl("export 2a-coward --to thymio --out " + (folder / "t").string()).code, 0);
    const std::string thymio = text_of(folder / "t" / "README.md");
    EXPECT_NE(thymio.find("| SL | the two on the left | 1000, nothing | 4300, a hand close to it |"), std::string::npos)
        << thymio;
    EXPECT_NE(thymio.find("| SR | the two on the right |"), std::string::npos);
    for (const std::string& text : {in_c, thymio})
        EXPECT_EQ(text.find('@'), std::string::npos) << "a key is not filled";
}

TEST(CtlThink, WritesVectorsAtTheRateOfTheRobot) {
    const Folder folder;
    const auto vectors = [&](const std::string& options) {
        const Ran ran = ctl("think tortoise --ticks 200 --vectors - " + options);
        EXPECT_EQ(ran.code, 0) << ran.out;
        return ran.out;
    };
    EXPECT_EQ(vectors("").substr(0, 22), "tick,sensor_SL,sensor_");
    EXPECT_EQ(vectors(""), vectors("--rate 60"));
    EXPECT_NE(vectors(""), vectors("--rate 10"));
    EXPECT_NE(vectors(""), vectors("--seed 2"));
    EXPECT_EQ(ctl("think tortoise --rate 0 --vectors -").code, 2);
}

}  // namespace
}  // namespace braitenlab::tests::ctl_export_test
