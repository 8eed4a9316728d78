// The web page that shows the program in a browser. Elsewhere there is no page: repeat() is a loop, and the other
// functions do nothing.
#pragma once

#include <functional>
#include <string>

namespace braitenlab {

// Calls `turn` until it returns false. In a browser it returns at once, and the page calls `turn` before each picture.
void repeat(std::function<bool()> turn);

// True in a browser: files come by upload and leave by download, and the program has no terminal.
bool is_on_page();

// True if the user asks pages for light colours (prefers-color-scheme); false elsewhere.
bool prefers_light();

// The address of the page without what follows '?' or '#'; empty elsewhere.
std::string page_address();

// What the page has in its title and its address, and what a reload opens again.
struct DocumentOnPage {
    std::string document{};      // its file, or a number of its own after a # if it has none: it came by a link
    std::string title{};         // empty: that of the program
    std::string lecture{};       // file of the open lecture; empty: none
    int page = 1, revealed = 0;  // of the lecture, the first page is 1; steps that are shown
    friend bool operator==(const DocumentOnPage&, const DocumentOnPage&) = default;
};
void tell_page(const DocumentOnPage&);

// While true, F5 is a key of the lab; else it loads the page anew.
void take_reload_key(bool wanted);

// Calls `work` again and again between two turns until it returns false, and again after the next turn. `work` takes
// some milliseconds at most, so that the page answers.
void work_between_turns(std::function<bool()> work);

// Lets the user choose files of the computer; they arrive as dropped files do.
void choose_files();

// Calls `keep` when the browser may end the page without a further event; what it writes is stored.
void when_page_is_left(std::function<void()> keep);

// Gives scripts of the page a JSON text as the result of window.braitenlab.NAME(). `name` is "state" or "anchors".
void offer_to_page(const std::string& name, std::function<std::string()> json);

}  // namespace braitenlab
