// Session: a world, its edits with undo and redo, and a recording to return to earlier ticks.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/session/recording.h"
#include "core/session/run_observer.h"
#include "core/session/undo.h"
#include "core/world/world.h"

namespace braitenlab {

// Edits that a reset keeps: all, or only those of the submission (core/scene/subject.h) and of other kinds' brains: an
// exercise starts from its own scene.
enum class Keep { edits, submission };

// A tick to return to.
struct Bookmark {
    Checkpoint checkpoint;
    RunObserver observer;  // at the checkpoint's keyframe
    Edits edits;
    std::uint64_t tick() const { return checkpoint.tick; }
};

// A run with its recorded ticks and the undo history of each, at one of its ticks.
struct Timeline {
    Recording recording;
    std::uint64_t tick = 0;  // earliest() .. latest() of the recording
    Edits edits;
    std::vector<std::pair<std::uint64_t, Edits>> edits_since;
};

// What an undo or a redo has done. False when there was nothing to undo or redo.
struct UndoResult {
    bool done = false;
    std::optional<Error> error{};  // of the first command that was refused; the others were executed
    explicit operator bool() const { return done; }
};

// Callbacks for the events of a run, in order: `tick` after each step and before the recorded commands of that tick,
// `command` after each of these commands. Each can be empty.
struct RunVisitor {
    std::function<void(const Snapshot&)> tick;
    std::function<void(const Snapshot&, const Command&)> command;
};

class Session {
public:
    // Fails as World::create does. The observer watches the run from its start on, see observer().
    static Result<Session> open(const Scene&, std::uint64_t seed, RunObserver = {});

    // Continues a saved run, identical to the uninterrupted run. The observer is as it was at the run's last keyframe,
    // see observer_at_keyframe(). The edits can be undone at its tick.
    static Session resume(SavedRun, RunObserver at_keyframe = {}, Edits = {});

    // Executes a command of the user. Every edit can be undone; edits with the same gesture (not 0, one number per
    // drag) are one undo step. At a tick before latest(), a command removes the later recorded ticks unless it is
    // cosmetic.
    std::optional<Error> apply(const Command&, std::uint64_t gesture = 0);

    // Computes one tick. Before latest() it also executes the recorded commands of that tick, so that the run is the
    // same.
    void step();

    // Restarts the run at tick 0 and keeps edits (see Keep).
    void reset(Keep = Keep::edits);

    // As reset(), with another seed: other random poses, noise and motor gains. save() and later resets keep the seed.
    // Returns the new id of each vehicle by its old id. The new run may not have a vehicle with that id.
    // When a run of the edited scene cannot begin, the opened scene is used, and last_reset_error() says why.
    std::map<VehicleId, VehicleId> restart(std::uint64_t seed, Keep = Keep::edits);
    const std::optional<Error>& last_reset_error() const { return last_reset_error_; }

    // Undo restores values, not the tick. A removed vehicle returns to its pose, or to the nearest free one if another
    // vehicle or an obstacle is there now. Commands for vehicles that no longer exist are left out. If an edit removed
    // later recorded ticks, its undo before the next step restores them.
    UndoResult undo();
    UndoResult redo();
    const Edits& edits() const { return edits_; }
    int undo_depth() const { return static_cast<int>(edits_.done.size()); }
    int redo_depth() const { return static_cast<int>(edits_.undone.size()); }

    // ── Time ──
    // First and last recorded tick. latest() is after the present tick when the session returned to an earlier one.
    std::uint64_t earliest() const { return recording_.earliest(); }
    std::uint64_t latest() const { return recording_.latest(); }

    // True when the next undo restores removed ticks.
    bool undo_brings_time_back() const;

    // seek() goes to the recorded tick nearest to `tick` and restores undo and redo of that tick. It costs at most
    // keyframe_ticks steps. seek_roughly() goes to the last keyframe at or before it and costs no steps.
    void seek(std::uint64_t tick);
    void seek_roughly(std::uint64_t tick);

    // Tick of the last keyframe at or before `tick`, which is in earliest() .. latest().
    std::uint64_t keyframe_before(std::uint64_t tick) const { return recording_.keyframe_before(tick); }

    // The recorded ticks, for a RecordedRun beside this session.
    const Recording& recording() const { return recording_; }

    // Repeats the run from `from` (at least earliest()) to the present tick for the visitor; the session does not
    // change. Costs one step per tick from the keyframe before `from`.
    void replay(std::uint64_t from, const RunVisitor&) const;

    // What has watched the run up to the present tick: it goes back and forward in time with the world. It sees every
    // tick and every command but cosmetic ones, each once, as if the run had been driven straight to here.
    const RunObserver& observer() const { return observer_; }
    // The same at the last keyframe, which is that of save(). The run goes on from there with its commands.
    const RunObserver& observer_at_keyframe() const { return recording_.observer_at(world_.tick()); }

    Bookmark bookmark() const { return {world_.checkpoint(), observer_at_keyframe(), edits_}; }
    void go_to(const Bookmark&);

    // The present run, to return to after a reset. Recorded states are shared, not copied.
    Timeline timeline() const { return {recording_, world_.tick(), edits_, edits_since_}; }
    // Replaces the run by one of this session: its tick, its recorded ticks before and after, its scene and brains, and
    // its undo history.
    void return_to(const Timeline&);
    SavedRun save() const { return {opened_, world_.checkpoint()}; }

    // The present snapshot; the reference stays valid and its content changes with the session.
    const Snapshot& snapshot() const { return snapshot_; }
    // The scene without edits. snapshot().scene has all edits except those of brains.
    const Scene& scene() const { return opened_; }
    // The scene with all edits as a file stores it: brains and drivers of kinds and of single vehicles included. A
    // session opened from it starts as this one does after reset().
    Scene edited_scene() const;
    std::uint64_t seed() const { return snapshot_.seed; }
    std::uint64_t hash() const { return world_.hash(); }

private:
    Session(Scene opened, World at_keyframe, RunObserver);
    // The recorded ticks that an edit at an earlier tick removed; kept until the next new tick.
    struct Forgotten {
        std::uint64_t tick = 0;  // of that edit
        std::size_t edits = 0;   // undo steps before it
        Recording recording;
        std::vector<std::pair<std::uint64_t, Edits>> edits_since;
    };

    std::optional<Error> execute(const Command&);
    void execute_part(Command, UndoResult&);
    void bring_time_back();
    RunVisitor observing();
    void repeat_until(std::uint64_t tick);
    void restore(std::uint64_t tick);
    void remember_edits();
    void change_later(const SharedStep& lost, const SharedStep& gained);
    void take_edits_of(std::uint64_t tick);
    std::map<VehicleId, VehicleId> renumber_after_reset(const Snapshot& before, Keep);

    std::optional<Error> last_reset_error_;
    Scene opened_;
    World world_;
    RunObserver observer_;
    Snapshot snapshot_;
    Recording recording_;
    Edits edits_;
    std::vector<std::pair<std::uint64_t, Edits>>
        edits_since_;  // undo and redo after each recorded tick that changed them
    std::optional<Forgotten> forgotten_;
};

}  // namespace braitenlab
