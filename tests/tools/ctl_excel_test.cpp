// --excel and --lang of every table.
#include <string>

#include <gtest/gtest.h>

#include "tests/folder.h"
#include "tests/tools/ctl.h"

namespace braitenlab::tests::ctl_excel_test {
namespace {

using namespace ctl_runs;

const std::string mark = "\xEF\xBB\xBF";

TEST(CtlExcel, EveryTableHasTheSeparatorAndTheDecimalMarkOfTheLanguage) {
    const Folder folder;
    put_text(folder / "s.toml",
             "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nseconds = 2\nseeds = 1\nmeasures = [\"survival\"]\n"
             "[[value]]\nname = \"w\"\npaths = [\"kind.aggressor.brain.LR\"]\nlevels = [0, 0.5]\n");
    const struct {
        std::string command, german, english;  // the beginnings of the table without the mark
    } tables[] = {
        {"run 2b-aggressor --seconds 0",
         "seconds;id;kind;role;x_m;y_m;heading_rad;speed_m_s;energy;left;right\n0,00000;0;",
         "seconds,id,kind,role,x_m,y_m,heading_rad,speed_m_s,energy,left,right\n0.00000,0,"},
        {"run 2b-aggressor --seconds 0 --set kind.aggressor.brain.LR=0,0.5",
         "run;seed;kind.aggressor.brain.LR;seconds;", "run,seed,kind.aggressor.brain.LR,seconds,"},
        {"map 2b-aggressor --size 2 --seconds 1",
         "LL=RR;LR=RL;kind;agree;closest_m;final_m;touch_s;captures;survival_s\n-2,00000;-2,00000;",
         "LL=RR,LR=RL,kind,agree,closest_m,final_m,touch_s,captures,survival_s\n-2.00000,-2.00000,"},
        {"robustness 2b-aggressor --robots 2 --seconds 1", "robot;seed;works;", "robot,seed,works,"},
        {"study " + (folder / "s.toml").string(), "run;seed;w;survival_s\n1;1;0,0;2,0\n2;1;0,5;2,0\n",
         "run,seed,w,survival_s\n1,1,0.0,2.0\n2,1,0.5,2.0\n"},
    };
    const std::string csv = (folder / "t.csv").string();
    for (const auto& table : tables) {
        SCOPED_TRACE(table.command);
        EXPECT_TRUE(ctl(table.command + " --csv -").out.starts_with(table.english));
        for (const char* language : {"de", "es"}) {
            const Ran ran = ctl(table.command + " --excel --lang " + language + " --csv -");
            EXPECT_TRUE(ran.out.starts_with(mark + table.german)) << ran.out.substr(0, 300);
        }
        EXPECT_EQ(ctl(table.command + " --excel --csv " + csv).code, 0);
        EXPECT_TRUE(text_of(csv).starts_with(mark + table.english)) << text_of(csv).substr(0, 300);
    }
    expect_refused("run 2b-aggressor --seconds 0 --excel --lang xx --csv -", "xx");
}

}  // namespace
}  // namespace braitenlab::tests::ctl_excel_test
