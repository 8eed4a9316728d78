// Lecture mode, and the pages of a lecture file. A page opens its scene or exercise anew.
#pragma once

#include "app/lab.h"

namespace braitenlab {

inline constexpr float lecture_type = 1.4f;  // times the type size outside a lecture

// How much larger the type of a lecture is in this window than in one of 1280 x 800: in a large window a lecture looks
// as in a small one. At least 1. `display_scale`: window pixels per layout pixel at type size 1.
float lecture_growth(Rect window, float display_scale);

// True if the document has edits since it was saved. Those made in lecture mode alone are not asked to be saved.
bool has_edits_to_keep(const Lab&);

// Lecture mode: large type, and the theme of the last lecture since the start of the program, at first light. The end
// restores preferences, view settings and stored brains, and leaves the lecture file; the scene of the last page stays
// open.
void begin_lecture(Lab&);
void end_lecture(Lab&);

// A lecture whose pages can all be opened, with its absolute path. Fails as read_lecture() and check_pages() do.
Result<Lecture> read_whole_lecture(const std::filesystem::path&);

// Begins lecture mode if it is off, and shows the first page.
void open_lecture(Lab&, std::shared_ptr<const Lecture>);

// Closes the lecture file and keeps its page, its time and the counted hands in LectureMemory::left. Lecture mode and
// the brains stored on the page stay. Does nothing without an open lecture.
void leave_pages(Lab&);

// Shows the page of LectureMemory::left. Its scene goes on with its run and the edits made in the lecture; it is opened
// anew if another file has been opened, if the scene has been edited since, or if the page has another scene now. The
// lecture is the file as it is now: if the author has changed its questions, the counted hands are lost. Precondition:
// LectureMemory::left.
void resume_lecture(Lab&, std::shared_ptr<const Lecture>);

// Requests that the lecture that was left is opened: at the page where it was left, or at the first one. Without one,
// shows a notice.
void request_left_lecture(Lab&, bool resume);

// Opens a page with so many of its steps shown. Both numbers are limited to those that exist. If the page's file cannot
// be opened any more, shows the error and keeps the present page. Precondition: Lab::pages.
void show_page(Lab&, int page, int steps = 0);

// Shows the first page again, with no counted hands on any page, and the clock begins again. Precondition: Lab::pages.
void begin_pages_again(Lab&);

// Shows the next step of the page; after the last one, the next page. The step `play` starts the run. Do nothing
// without an open lecture.
void next_page(Lab&);
// Hides the last step shown; hiding the step `play` returns the run to its start and keeps edits. Before the first
// step, goes to the previous page with all of its steps; on the first page, says so. Its run begins anew; the step
// `play` does not start it.
void previous_page(Lab&);

// Begins or ends the count of hands for a question that is asked about a scene without a page. A page has its own
// question: then shows a notice, and so it does where the map, the robots or a comparison have the room. Does nothing
// outside a lecture. Another scene begins a new count.
void switch_tally(Lab&);

// Gives the tally another number of options; their hands stay.
void change_tally(Lab&, const TallyRequest&);

// Sets the number of raised hands, 0 .. 999, of an option of the page, or of the tally without one.
void count_hands(Lab&, const HandsRequest&);

}  // namespace braitenlab
