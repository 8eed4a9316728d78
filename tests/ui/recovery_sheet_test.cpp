// What a crash or an end has left is offered in words that tell which it was.
#include "desk.h"

namespace braitenlab::tests::recovery_sheet_test {
namespace {

TEST(RecoverySheet, SaysWhetherTheLabCrashedOrWasToldToEnd) {
    for (const bool ended : {false, true}) {
        Desk desk;
        const RecoveryOffer offer{"2a-coward", "2026-03-01 10:42:05", ended};
        desk.view.recovery = &offer;
        desk.frame(3);
        bool crashed = false, kept = false;
        for (const Written& w : desk.written) {
            crashed |= w.words == desk.strings("recovery.heading");
            kept |= w.words == desk.strings("recovery.heading_ended");
        }
        EXPECT_EQ(crashed, !ended);
        EXPECT_EQ(kept, ended);
    }
}

}  // namespace
}  // namespace braitenlab::tests::recovery_sheet_test
