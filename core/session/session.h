// One sitting with a scene: the world, the edits made to it, the way back from them, and the way back in time.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/session/recording.h"
#include "core/session/undo.h"
#include "core/world/world.h"

namespace braitenlab {

// What of the edits a reset keeps: all of them, or those of brains alone (an exercise gives the same start to
// everyone).
enum class Keep { edits, brains };

// A moment to come back to.
struct Bookmark {
    Checkpoint checkpoint;
    Edits edits;
    std::uint64_t tick() const { return checkpoint.tick; }
};

class Session {
public:
    // Fails as World::create does.
    static Result<Session> open(const Scene&, std::uint64_t seed);

    // Goes on with a saved run, exactly as the saved one would have gone on.
    static Session resume(SavedRun);

    // Does what a person asked for. Every edit can be undone; those with the same gesture (any number but 0, one per
    // drag) are one step of undo. Given in the past, it makes another future: the recorded one is forgotten, but for a
    // move of nodes, which changes nothing that happens.
    std::optional<Error> apply(const Command&, std::uint64_t gesture = 0);

    // One tick. In the recorded past, the commands given there are given again: the run is the same.
    void step();

    // Back to the very start of the run: edits stay (see Keep), time and places start over.
    void reset(Keep = Keep::edits);

    // Values, never time: an undone weight is the old weight now. False when there is nothing to undo or redo. What an
    // edit in the past made the recording forget is there again when the edit is undone before time has gone on.
    bool undo();
    bool redo();
    int undo_depth() const { return static_cast<int>(edits_.done.size()); }
    int redo_depth() const { return static_cast<int>(edits_.undone.size()); }

    // ── Time ──
    // The ticks that can be gone to: the last minute, and what lies ahead of a moment in the past.
    std::uint64_t earliest() const { return recording_.earliest(); }
    std::uint64_t latest() const { return recording_.latest(); }

    // Whether the next undo brings back a future that was forgotten.
    bool undo_brings_time_back() const;

    // Stands at this tick as the run did then, the nearest recorded one; what can be undone is what could be then.
    // Costs at most keyframe_ticks steps; `roughly`, none: it goes to the keyframe before.
    void seek(std::uint64_t tick);
    void seek_roughly(std::uint64_t tick);

    Bookmark bookmark() const { return {world_.checkpoint(), edits_}; }
    void go_to(const Bookmark&);
    SavedRun save() const { return {opened_, world_.checkpoint()}; }

    // The moment as it is now; stays valid and changes with the session.
    const Snapshot& snapshot() const { return snapshot_; }
    // The scene as it was opened. As it is edited, but for brains: snapshot().scene.
    const Scene& scene() const { return opened_; }
    // As edited up to now, brains too: what a file of it would hold.
    Scene edited_scene() const;
    std::uint64_t seed() const { return snapshot_.seed; }
    std::uint64_t hash() const { return world_.hash(); }

private:
    Session(Scene opened, World);
    // The future that an edit in the past made the recording forget, until time goes on.
    struct Forgotten {
        std::uint64_t tick = 0;  // of that edit
        std::size_t edits = 0;   // that could be undone before it
        Recording recording;
        std::vector<std::pair<std::uint64_t, Edits>> edits_since;
    };

    std::optional<Error> execute(const Command&);
    void bring_time_back();
    void advance();
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
        edits_since_;  // as they became at each recorded tick that changed them
    std::optional<Forgotten> forgotten_;
};

}  // namespace braitenlab
