// Going on with an exercise that has been saved from the open scene: the scene is kept, so that its author can change
// what is on the sheet and save again.
#pragma once

#include <filesystem>
#include <string>

#include "app/course/authored_scene.h"
#include "app/lab.h"

namespace braitenlab {

// Opens the exercise and keeps the scene that was open.
void open_authored(Lab&, Document exercise, const std::filesystem::path&, const std::string& vehicle);

// Restores the scene. Its vehicle gets the brain and the sensors of the exercise's vehicle, if they have been edited:
// what is in the window becomes the solution. Does nothing without has_draft() (app/course/authored_scene.h).
void edit_again(Lab&);

}  // namespace braitenlab
