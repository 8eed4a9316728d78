#include "tests/fuzz/commands.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/io/run_file.h"
#include "core/scene/arena.h"
#include "tests/core/sessions.h"
#include "tests/fuzz/promise.h"

namespace braitenlab::fuzz {

namespace {

constexpr int most_commands = 60;

struct Bytes {
    std::string_view left;
    std::uint32_t next() {
        if (left.empty()) return 0;
        const auto byte = static_cast<unsigned char>(left.front());
        left.remove_prefix(1);
        return byte;
    }
};

bool is_within(float value, float low, float high) { return value >= low && value <= high; }

Command any_command(const Session& session, Bytes& bytes) {
    maths::Random chance{bytes.next() * 256 + bytes.next(), 7};
    return tests::any_edit(session, chance);
}

// An edit, undone and done again, leaves the world as the edit did.
void undo_and_redo(Session& session, Bytes& bytes) {
    if (session.apply(any_command(session, bytes)) || session.undo_depth() == 0) return;
    const auto hash = session.hash();
    if (!session.undo()) return;
    promise(static_cast<bool>(session.redo()), "what is undone can be done again");
    promise(session.hash() == hash, "undo and redo have another hash");
}

void seek(Session& session, Bytes& bytes) {
    session.seek(session.earliest() + bytes.next() * (session.latest() - session.earliest()) / 255);
}

void play(Session& session, Bytes& bytes) {
    switch (bytes.next() % 8) {
        case 0:
            (void)session.undo();
            break;
        case 1:
            (void)session.redo();
            break;
        case 2:
            seek(session, bytes);
            break;
        case 3:
            session.reset();
            break;
        case 4:
            undo_and_redo(session, bytes);
            break;
        case 5:
            for (std::uint32_t ticks = bytes.next() % 64; ticks > 0; --ticks) session.step();
            break;
        default:
            (void)session.apply(any_command(session, bytes), bytes.next() % 3);
    }
}

}  // namespace

void is_sound(const Session& session) {
    const Snapshot& now = session.snapshot();
    for (const VehicleView& v : now.vehicles) {
        for (const float value : {v.x, v.y, v.heading, v.speed, v.wheel_angle[0], v.wheel_angle[1]})
            promise(std::isfinite(value), "a motion that is no number");
        promise(is_within(v.energy, 0, 1), "an energy outside 0 .. 1");
        for (const float motor : v.motor) promise(is_within(motor, -1, 1), "a motor outside -1 .. 1");
    }
    for (const float reading : now.sensed) promise(is_within(reading, 0, 1), "a reading outside 0 .. 1");
    for (const float neuron : now.neurons) promise(std::isfinite(neuron), "a neuron that is no number");
}

void is_restored(const Session& session) {
    auto read = io::read_run(io::write_run(session.save()), "again.run");
    promise(static_cast<bool>(read), "a saved run that is refused");
    Session again = Session::resume(std::move(*read));
    promise(again.hash() == session.hash(), "a restored run has another hash");
    World beside = World::restore(session.save().checkpoint);
    for (int i = 0; i < 5; ++i) again.step(), beside.step();
    promise(again.hash() == beside.hash(), "a restored run goes on in another way");
}

void run_commands(std::string_view input) {
    Bytes bytes{input};
    Session session = tests::open_session(tests::furnished());
    for (int i = 0; i < most_commands && !bytes.left.empty(); ++i) play(session, bytes), is_sound(session);
    is_restored(session);
}

}  // namespace braitenlab::fuzz
