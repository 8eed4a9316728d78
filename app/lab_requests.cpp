#include "app/lab_requests.h"

#include <algorithm>

#include "app/course/lab_children.h"
#include "app/course/lab_lecture.h"
#include "app/course/lab_lesson.h"
#include "app/course/lab_progress.h"
#include "app/files/data.h"
#include "app/files/pages.h"
#include "app/lab_actions.h"
#include "app/lab_edits.h"
#include "app/lab_reset.h"
#include "app/lab_selection.h"
#include "app/seeking.h"
#include "core/match.h"
#include "core/utf8.h"

namespace braitenlab {

namespace {

template <class... Alternatives>
bool is_one_of(const Request& request) {
    return (std::holds_alternative<Alternatives>(request) || ...);
}

bool acts_on_own_run(const Request& request) {
    if (const auto* action = std::get_if<Action>(&request)) return acts_on_own_run(*action);
    const auto* breeding = std::get_if<BreedingRequest>(&request);
    if (breeding && breeding->edit == BreedingEdit::take) return true;
    return is_one_of<EditRequest, PasteRequest, SeedRequest, SeekRequest, BookmarkRequest, ShowMeRequest, KeptRequest,
                     StudentRequest, ChooseChildRequest, EarlierGenerationRequest, SlotRequest>(request);
}

void handle_breeding(Lab& lab, const BreedingRequest& wanted) {
    // The run does not go on with champions in its middle when the sheet closes. In an exercise it begins with them.
    const bool takes = wanted.edit == BreedingEdit::take;
    if (takes && lab.playback.mode == Mode::playing) set_mode(lab, Mode::paused);
    if (takes && lab.document.lesson && lab.document.session.snapshot().tick > 0) reset(lab);
    if (auto match = handle_breeding(lab.breeding, lab, wanted)) lab.window.files.push_back(std::move(*match));
}

// While the graded starts run at once, their vehicles cannot be selected.
bool selects(const Request& request) { return is_one_of<SelectRequest, TakeRequest, SelectObjectsRequest>(request); }

// Adds a request that only moves an object as a part of this gesture; false for any other request.
bool add_move(MoveObjects& all, const Request& request, std::uint64_t gesture) {
    const auto* edit = std::get_if<EditRequest>(&request);
    if (!edit || edit->gesture != gesture || gesture == 0) return false;
    return std::visit(
        Match{[&](const MoveVehicle& c) { return all.of_vehicles.push_back(c), true; },
              [&](const MoveSource& c) { return all.of_sources.push_back(c), true; },
              [&](const MoveObstacle& c) { return all.of_obstacles.push_back(c), true; },
              [&](const MoveZone& c) { return all.of_zones.push_back(c), true; }, [](const auto&) { return false; }},
        edit->command);
}

}  // namespace

void handle(Lab& lab, const Request& request) {
    if (lab.together && selects(request)) return;
    if (lab.together && acts_on_own_run(request)) {
        end_together(lab);
        if (const auto* action = std::get_if<Action>(&request); action && *action == Action::cancel) return;
    }
    std::visit(Match{[&](Action action) { act(lab, action); },
                     [&](const EditRequest& r) { edit(lab, r); },
                     [&](const SelectRequest& r) {
                         forget_vehicle_notice(lab);
                         select(lab, vehicle_object(r.vehicle)), keep_selection(lab);
                     },
                     [&](const NoticeRequest& r) {
                         say(lab, {NoticeKind::notice, r.key, r.words, r.more});
                     },
                     [&](const TakeRequest& r) { select_object(lab, r.object); },
                     [&](const SelectObjectsRequest& r) { select_objects(lab, r.objects), keep_selection(lab); },
                     [&](const PasteRequest& r) {
                         if (lab.playback.mode != Mode::wiring) paste(lab, lab.clipboard, r.at);
                     },
                     [&](const CanvasShareRequest& r) {
                         lab.view.canvas_share = std::clamp(r.share, least_canvas_share, largest_canvas_share);
                     },
                     [&](const PairRequest& r) { lab.view.selection.pair = r.name; },
                     [&](const ScopeRequest& r) { lab.view.selection.whole_kind = r.whole_kind; },
                     [&](const SeedRequest& r) { reset(lab, r.seed); },
                     [&](const MapRequest& r) { choose_map(lab.map, lab, r); },
                     [&](const StudyRequest& r) {
                         if (r.edit == StudyEdit::save) return lab.window.files.push_back(r);
                         if (r.edit == StudyEdit::figure) return lab.window.reports.push_back(r);
                         handle_study(lab.study, lab, r);
                     },
                     [&](const BreedingRequest& r) { handle_breeding(lab, r); },
                     [&](const RobotsRequest& r) { handle_robots(lab.robots, lab, r); },
                     [&](const SeekRequest& r) { seek(lab, r); },
                     [&](const WhyRequest& r) { explain_at(lab.explanation, lab, r.tick); },
                     [&](const BookmarkRequest& r) { handle_bookmark(lab, r); },
                     [&](const OpenRequest& r) { lab.window.files.push_back(r); },
                     [&](const BrowseRequest& r) { lab.window.files.push_back(r); },
                     [&](const SaveRequest& r) { lab.window.files.push_back(r); },
                     [&](const SaveExerciseRequest& r) { lab.window.files.push_back(r); },
                     [&](const RecoverRequest& r) { lab.window.files.push_back(r); },
                     [&](const BeginRequest&) { lab.window.begins = true; },
                     [&](const UploadRequest&) { lab.window.uploads = true; },
                     [&](const LeaveRequest& r) { lab.window.files.push_back(r); },
                     [&](const PreferencesRequest& r) { lab.preferences = r.preferences; },
                     [&](const OverlaysRequest& r) { lab.view.overlays = r.overlays; },
                     [&](const PredictRequest& r) { predict(lab, r); },
                     [&](const PredictPathRequest& r) { predict(lab, r); },
                     [&](const CompareRequest& r) { compare(lab, r); },
                     [&](const FreePlayRequest& r) {
                         if (lab.document.lesson) lab.document.lesson->attempt.work.free_play = r.on;
                     },
                     [&](const ShowMeRequest&) { show_solution(lab); },
                     [&](const ChooseChildRequest& r) { choose_child(lab, r.child); },
                     [&](const EarlierGenerationRequest&) { take_choice_back(lab); },
                     [&](const KeptRequest&) { take_kept_submission(lab); },
                     [&](const TogetherRequest& r) { r.on ? show_starts_together(lab) : end_together(lab); },
                     [&](const NotesRequest& r) {
                         if (lab.document.lesson) lab.document.lesson->attempt.notes = utf8_cut(r.text, longest_notes);
                     },
                     [&](const StudentRequest& r) {
                         if (r.edit == StudentEdit::save || r.edit == StudentEdit::save_progress)
                             return lab.window.files.push_back(r);
                         edit_students(lab, r);
                     },
                     [&](const HandsRequest& r) { count_hands(lab, r); },
                     [&](const TallyRequest& r) { change_tally(lab, r); },
                     [&](const SlotRequest& r) { handle_slot(lab.slots, lab, r); },
                     [&](const MysteryRequest& r) { handle_mystery(lab.mystery, lab, r); },
                     [&](const ExportRequest& r) { lab.window.files.push_back(r); },
                     [&](const WriteFilesRequest& r) { lab.window.files.push_back(r); },
                     [&](const HandInRequest& r) { lab.window.reports.push_back(r); },
                     [&](const LabRecordRequest& r) { lab.window.reports.push_back(r); },
                     [&](const TakeAwayRequest& r) { lab.window.take_away = r.what; },
                     [&](const PageRequest& r) { open_page(lab, r.page); },
                     [&](const OpenFolderRequest& r) { open_folder(lab, r.folder); },
                     [&](const EmptySlotsRequest&) { empty_slots(lab.slots); },
                     [&](const OpenWrittenRequest& r) { lab.window.reports.push_back(r); },
                     [&](const HideFindingsRequest&) { lab.findings.clear(); },
                     [&](const CancelClipRequest&) { lab.window.cancels_clip = true; },
                     [&](const SpeedRequest& r) {
                         lab.playback.time_scale = std::clamp(r.time_scale, least_time_scale, largest_time_scale);
                     }},
               request);
}

void handle_all(Lab& lab, const Outbox& requests) {
    for (auto next = requests.begin(); next != requests.end();) {
        const auto* edit = std::get_if<EditRequest>(&*next);
        const std::uint64_t gesture = edit ? edit->gesture : 0;
        MoveObjects all;
        auto end = next;
        while (end != requests.end() && add_move(all, *end, gesture)) ++end;
        if (end - next > 1) {
            handle(lab, EditRequest{all, gesture});
            next = end;
        } else {
            handle(lab, *next++);
        }
    }
}

}  // namespace braitenlab
