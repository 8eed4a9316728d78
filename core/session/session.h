// One session with a scene: the world, its edits with undo and redo, and the recording for moving back in time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/session/recording.h"
#include "core/session/undo.h"
#include "core/world/world.h"

namespace braitenlab {

// Edits that a reset keeps: all, or those of brains only (an exercise starts from its own scene).
enum class Keep { edits, brains };

// A tick to return to.
struct Bookmark {
    Checkpoint checkpoint;
    Edits edits;
    std::uint64_t tick() const { return checkpoint.tick; }
};

// Receives what happens in a run, in order: `tick` after each step, before the commands that the recording holds for
// that tick, and `command` after each of these commands. Each may be empty.
struct RunVisitor {
    std::function<void(const Snapshot&)> tick;
    std::function<void(const Snapshot&, const Command&)> command;
};

class Session {
public:
    // Fails as World::create does.
    static Result<Session> open(const Scene&, std::uint64_t seed);

    // Continues a saved run exactly as it would have gone on.
    static Session resume(SavedRun);

    // Executes a command of the user. Every edit can be undone; edits with the same gesture (not 0, one per drag) are
    // one undo step. In the recorded past it removes the recorded future, unless it only moves nodes on the canvas or
    // changes the title.
    std::optional<Error> apply(const Command&, std::uint64_t gesture = 0);

    // One tick. In the recorded past the recorded commands are executed again, so the run is the same; the visitor
    // receives them.
    void step(const RunVisitor& = {});

    // Restarts the run at tick 0. Edits stay (see Keep).
    void reset(Keep = Keep::edits);

    // Undo restores values, not time. Returns false when there is nothing to undo or redo. Undoing an edit made in the
    // past before the next step restores the recorded future that it removed.
    bool undo();
    bool redo();
    int undo_depth() const { return static_cast<int>(edits_.done.size()); }
    int redo_depth() const { return static_cast<int>(edits_.undone.size()); }

    // ── Time ──
    // The recorded ticks: at least the last minute, and the future of a tick in the past.
    std::uint64_t earliest() const { return recording_.earliest(); }
    std::uint64_t latest() const { return recording_.latest(); }

    // True when the next undo restores a removed future.
    bool undo_brings_time_back() const;

    // Goes to the recorded tick nearest to `tick`; undo and redo are as they were then. Costs at most keyframe_ticks
    // steps. seek_roughly() goes to the keyframe before it and costs none.
    void seek(std::uint64_t tick);
    void seek_roughly(std::uint64_t tick);

    // The latest tick not after `tick`, earliest() .. latest(), that has a keyframe.
    std::uint64_t keyframe_before(std::uint64_t tick) const { return recording_.keyframe_before(tick); }

    // Repeats the run from `from` (at least earliest()) to the present tick for the visitor; the session does not
    // change. Costs one step per tick from the keyframe before `from`.
    void replay(std::uint64_t from, const RunVisitor&) const;

    // True when replay() visits the commands executed at the present tick. False when there are none, or when they
    // created a keyframe, which holds their effect.
    bool replays_commands() const { return !recording_.commands_at(world_.tick()).empty(); }

    Bookmark bookmark() const { return {world_.checkpoint(), edits_}; }
    void go_to(const Bookmark&);
    SavedRun save() const { return {opened_, world_.checkpoint()}; }

    // The present snapshot; the reference stays valid and its content changes with the session.
    const Snapshot& snapshot() const { return snapshot_; }
    // The scene as it was opened. The edited one, without edits of brains, is snapshot().scene.
    const Scene& scene() const { return opened_; }
    // The scene with all edits, brains included, as a file stores it.
    Scene edited_scene() const;
    std::uint64_t seed() const { return snapshot_.seed; }
    std::uint64_t hash() const { return world_.hash(); }

private:
    Session(Scene opened, World);
    // The recorded future that an edit in the past removed; kept until the next new tick.
    struct Forgotten {
        std::uint64_t tick = 0;  // of that edit
        std::size_t edits = 0;   // undo steps before it
        Recording recording;
        std::vector<std::pair<std::uint64_t, Edits>> edits_since;
    };

    std::optional<Error> execute(const Command&);
    void bring_time_back();
    void advance(const RunVisitor&);
    void remember_edits();
    void change_later(const SharedStep& lost, const SharedStep& gained);
    void take_edits_of(std::uint64_t tick);
    void renumber_after_reset(const Snapshot& before, Keep);

    Scene opened_;
    World world_;
    Snapshot snapshot_;
    Recording recording_;
    Edits edits_;
    std::vector<std::pair<std::uint64_t, Edits>>
        edits_since_;  // undo and redo after each recorded tick that changed them
    std::optional<Forgotten> forgotten_;
};

}  // namespace braitenlab
