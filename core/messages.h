// The texts of error messages that the window shows in the chosen language: English here, translations under [error] in
// the files of other languages, ui/strings/*.toml.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/result.h"

namespace braitenlab {

struct MessageText {
    std::string_view id, english;  // each {} is a value
};
inline constexpr auto message_table = std::to_array<MessageText>({
    {"no_file", "there is no such file"},
    {"not_progress", "not the progress of a student: {}"},
    {"kept_aside", "; it is kept as {}, and the progress starts anew"},
    {"not_kept_aside", "; it cannot be renamed and is not used"},
    {"student_twice", "the progress of {} is also in {}; this file is not used. Change the name in it, or delete it"},
    {"student_without_name",
     "the progress of a student without a name; it is not used. Add \"student\" or delete the file"},
    {"too_many_students", "there are more than {} students; this file is not used. Move some files to another folder"},
    {"breeding_has_own_values", "a breeding takes neither --seed nor --set; change the values in its file"},
    {"settings_ignored", "; the settings are not used"},
    {"settings_kept_aside", "; the settings are not used and kept as {}"},
    {"no_shipped", "there is no file and no shipped scene called '{}'"},
    {"no_shipped_exercise", "there is no file and no shipped exercise called '{}'"},
    {"no_shipped_study", "there is no file and no shipped study called '{}'"},
    {"no_shipped_breeding", "there is no file and no shipped breeding called '{}'"},
    {"no_data", "the exercises and shaders of the lab are not in {}; set BRAITENLAB_DATA to their folder"},
    {"no_clip_format", "a clip is a file .gif, .mp4 or .webm; end its name with one of these"},
    {"no_ffmpeg", "the program ffmpeg, which writes MP4 and WebM, is not found; install it, or write a GIF"},
    {"ffmpeg_failed", "ffmpeg cannot write the clip: {}"},
    {"picture_too_large", "the graphics driver draws pictures of at most {} × {} pixels; choose a smaller size"},
    {"no_clip_time", "the clip ends before it begins; give an end after the beginning"},
    {"clip_too_long", "the clip is longer than {} s; choose a shorter part"},
    {"key_missing", "'{}' is missing; add {}"},
    {"solution_missing", "there is no [solution]; add the brain that passes"},
    {"step_missing", "there is no [[step]]; add at least one check of what must happen"},
    {"no_brain_number", "there is no brain number {}"},
    {"no_kind_number", "there is no kind number {}"},
    {"no_sensors_number", "there is no list of sensors number {}"},
    {"vehicles_incomplete", "some vehicles have too few or too many values"},
    {"vehicle_numbers", "the numbers of the vehicles do not ascend, or go beyond the next one"},
    {"vehicle_start", "a vehicle has a start that the scene does not have"},
    {"vehicle_waypoint", "vehicle {} drives to a waypoint that it does not have"},
    {"vehicle_range", "a value of a vehicle is outside its range"},
    {"brains_of_kinds", "not every kind has a brain for new vehicles"},
    {"clock_range", "its time is outside its range"},
    {"contradicts", "'{}' contradicts the rest of the file"},
    {"not_a_file", "this is not a file; give one"},
    {"too_large", "larger than {} MB; split it"},
    {"unreadable", "cannot be read; are you allowed to?"},
    {"not_toml", "not TOML: {}"},
    {"other_file", "this is a file of the format {}; give a file of the lab, .toml or .run"},
    {"run_as_toml", "this is a saved run; end its name with .run"},
    {"in_encoding", "the text is in {}"},
    {"only_zeros", "the file has only characters of value 0, as after an interrupted copy; take another copy of it"},
    {"not_text", "this is no text; give a file of the lab, .toml or .run"},
    {"bare_returns",
     "the line ends with a carriage return alone; save the file with the line ends of Unix or Windows (LF or CRLF)"},
    {"advice_utf8", "; save the file as UTF-8"},
    {"advice_no_zero", "; remove each character of value 0 in this line"},
    {"advice_plain_blanks", "; write a plain space in place of the special space {}"},
    {"advice_no_invisible", "; remove the invisible character {}"},
    {"advice_open_text", "; the text that begins here has no end; write {} after it"},
    {"advice_plain_minus", "; write a plain minus - instead of {}"},
    {"advice_straight_quotes", "; write straight quotes \" instead of {}"},
    {"advice_closing_quote", "; a quote \" is missing at the end of a text"},
    {"advice_closing_bracket", "; a bracket ] is missing"},
    {"advice_missing_value", "; write a value after {} ="},
    {"advice_key_and_value", "; write a key and its value, like x = 1.5"},
    {"advice_decimal_point", "; write {}, with a point"},
    {"decimal_commas", "the commas in '{}' stand as in decimal numbers"},
    {"advice_no_unit", "; write the number without its unit: {}"},
    {"advice_small_letters", "; write {}, in small letters"},
    {"advice_heading_twice", "; [{}] stands twice: write [[{}]] where there are several, or join them"},
    {"advice_key_twice", "; {} stands twice: remove one"},
    {"advice_text_in_quotes", "; put text in quotes \", not bare as {}"},
    {"too_deep_key", "a key has too many dots; the longest is like kind.NAME.body.wheel"},
    {"no_format", "'format' is missing; begin the file with format = 1"},
    {"other_format", "this program reads format = 1 only; the file may be from a newer one"},
    {"format_whole", "'format' should be the whole number 1; write format = 1"},
    {"type_wanted", "'{}' should be "},
    {"type_found", ", not "},
    {"a_number", "a number"},
    {"a_whole_number", "a whole number"},
    {"true_or_false", "true or false"},
    {"text_in_quotes", "text in quotes"},
    {"a_word_in_quotes", "a word in quotes"},
    {"a_list", "a list"},
    {"a_table", "a table"},
    {"a_table_like", "a table, [{}]"},
    {"a_text", "text"},
    {"a_date", "a date or time"},
    {"two_numbers", "two numbers, [x, y]"},
    {"tables_like", "a list of tables, [[{}]]"},
    {"single_table", "write [[{}]] instead of [{}]; it is one of a list"},
    {"out_of_range", "'{}' is {}, outside {} .. {}"},
    {"too_long", "'{}' has {} characters, the most is {}; shorten it"},
    {"longer_than", "'{}' is longer than {} characters"},
    {"not_one_of", "'{}' cannot be {}"},
    {"nearest", "; the nearest is {}"},
    {"known", "; known are {}"},
    {"too_many_entries", "'{}' has {} entries, the most is {}"},
    {"too_many_tables", "{} tables [{}.…], the most is {}"},
    {"unknown_key", "no key {} "},
    {"at_the_top", "at the top of the file"},
    {"in_table", "in [{}]"},
    {"bad_name", "{} cannot be a name; use up to {} of the letters a-z A-Z 0-9 _ -"},
    {"no_kind_called", "no kind is called {}"},
    {"no_source_called", "no source is called {}"},
    {"no_node_called", "no node is called {}"},
    {"exercise_without_vehicle", "this scene places no vehicle; an exercise is about one"},
    {"exercise_solved",
     "the brain in the window is the one that the student gets; change it, so that it is the solution"},
    {"exercise_wrong_is_solution",
     "the wrong answer “{}” is the brain in the window, which becomes the solution; restore the solution first"},
    {"file_exists", "there is a file of this name; save once more to replace it"},
    {"starts_outside", "it starts outside the arena"},
    {"round_torus", "a torus cannot be round; choose another edge or leave out 'round'"},
    {"scene_not_brain", "this is a whole scene; a brain alone has one [brain] table, as saving a brain writes it"},
    {"no_brain_table", "there is no [brain] table; see the brain of any kind in a scene"},
    {"too_many_sensors", "a brain may have {} sensors, this one has {}; take some away"},
    {"too_many_neurons", "a brain may have {} neurons, this one has {}; take some away"},
    {"too_many_wires", "a brain may have {} wires, this one has {}; take some away"},
    {"same_node_name", "two nodes are called '{}'; give each its own name"},
    {"unknown_motor", "motor '{}' is unknown; a vehicle has the motors ML and MR"},
    {"in_node", "node '{}': "},
    {"in_wire", "the wire from '{}' to '{}': "},
    {"wire_without_end", "a wire runs from node {} to node {}, and one of them does not exist"},
    {"wire_into_sensor", "a wire runs into the sensor '{}'; sensors only send"},
    {"same_wire", "two wires run from '{}' to '{}'; make them one"},
    {"no_kinds", "the scene has no kind of vehicle to add; write one into its file"},
    {"full_world", "{} vehicles are the most a world holds; remove some first"},
    {"vehicle_is_gone", "vehicle {} is no longer in the world; select another one"},
    {"kind_in_use", "{} vehicles are of the kind '{}'; remove them first"},
    {"kind_starts", "a vehicle of the kind '{}' starts at a reset; remove it first"},
    {"population_limit", "a world holds 0 to {} vehicles"},
    {"no_vehicle_left", "there is no vehicle left to remove"},
    {"no_run", "is no saved run that can be gone on with: "},
    {"not_saved", "could not be saved: {}; choose another place"},
    {"disk_full", "could not be saved: {}; make room on the disk or choose another place"},
    {"no_permission", "could not be saved: {}; choose a folder that you may write to"},
    {"old_file_stays", ". The old file is unchanged"},
    {"special_file", "is not a regular file; choose another name"},
    {"changed_outside",
     "another program has changed this file since it was read; save once more to replace it, or save under another "
     "name"},
    {"leaves_folder",
     "{} is outside the folder of this file, and a dropped file may not reach out of its folder; open the file with "
     "Ctrl+O to allow it"},
    {"no_such_folder", "cannot be saved there: its folder does not exist"},
    {"not_savable", "can be saved as a scene, a run or a brain only"},
    {"no_brain_to_save", "no vehicle is selected; select the one whose brain to save"},
    {"no_vehicle_for_brain", "no vehicle is selected; select the one that gets this brain"},
    {"was_open_last", "was open last, but cannot be opened now"},
    {"no_recovery", "the work cannot be stored for recovery after a crash; save it yourself (Ctrl+S): "},
    {"wheel_loads", "the wheels' loads add up to {}; make it 1, the whole weight"},
    {"wide_triangle", "a triangle opens by 179 degrees at most; make it narrower or its shape a sector"},
    {"few_points", "a table needs two points or more: add a 'point' with 'distance' and 'reading'"},
    {"points_of_table", "points belong to the response \"table\"; set it, or remove them"},
    {"point_order", "point {} is at {} m, and the one before it at {} m; the distances of points ascend"},
    {"few_corners_box", "an outline needs at least 3 corners; leave them out for a box"},
    {"few_corners_rectangle", "an outline needs at least 3 corners; leave them out for a rectangle"},
    {"close_corners", "corners {} and {} stand less than 0.01 m apart"},
    {"corner_order",
     "corner {} does not lie left of the edge from {} to {}; list the corners of a convex outline counter-clockwise"},
    {"vehicle_without_kind", "a vehicle needs a kind: kind = \"NAME\" of a [kind.NAME]"},
    {"member_name", "the name of a member is its number in the population, from 0, without leading zeros"},
    {"member_beyond",
     "the population has {} vehicles, numbered from 0; raise ecology.population or remove this member"},
    {"too_much_memory",
     "{} vehicles with up to {} numbers in brain and sensors each are more than fit; with such brains and latencies {} "
     "are the most"},
    {"too_dense", "{} vehicles cover {} m², and the arena has {} m²; take at most {}, smaller ones or a larger arena"},
    {"too_much_work",
     "a tick of {} vehicles may take as long as {} million comparisons, and the most are {} million; take fewer "
     "vehicles, obstacles, sensors or neurons, shorter ranges or a larger arena"},
    {"too_crowded", "more than {} vehicles are placed within {} m; move some apart"},
    {"no_role_to_count", "the vehicles that a goal counts are predators or prey"},
    {"no_kind_to_populate", "there is no [kind.NAME] to populate the arena with"},
    {"node_without_name", "a node needs a name: name = \"N1\""},
    {"wire_without_names", "a wire needs from = and to =, each a node's name"},
    {"node_of_key", "the brain lacks the node {} that this belongs to"},
    {"nodes_of_dial", "the brain lacks the node SL, SR, ML or MR that this belongs to"},
    {"a_colour", "'{}' should be a colour like \"#3d7cc9\""},
    {"negative_node_id", "node '{}' has the id {}; ids begin at 0"},
    {"same_node_id", "two nodes have the id {}; give each its own"},
    {"not_an_autosave", "is not an autosave"},
    {"nothing_to_recover", "there is nothing to recover"},
    {"reset_as_opened", "the reset took the scene as it was opened, because a run of the edited one cannot begin: "},
    {"missing_in_hand_in", "'{}' is missing; write the file again in the lab"},
    {"empty_key", "'{}' is empty"},
    {"more_passed_than_graded", "'passed_starts' is larger than 'graded_starts'"},
    {"no_scene_of_exercise", "there is no scene {}; its path is relative to this file"},
    {"no_link", "this is no link of the lab; such a link has #b1. or #e1. and more in it"},
    {"link_version", "the version of this link is {}, this program knows {}; a newer program may open it"},
    {"link_characters", "the link has characters that no link of the lab has; copy the whole link once more"},
    {"link_incomplete", "the link is incomplete; copy it once more, up to its end"},
    {"link_damaged", "the link is damaged; copy the whole link once more"},
    {"link_too_large", "the scene of the link is larger than {} MB, the most that the lab opens"},
    {"no_exercise_of_link", "there is no shipped exercise called {}; the link may be from another version of the lab"},
    {"run_moment", "its moment is not in reach of its keyframe"},
    {"run_many_commands", "more commands than a person can give"},
    {"run_command_order", "its commands are not in order"},
    {"run_other_file", "it is some other file"},
    {"run_version", "its version is {}, this program knows {}; a newer program may open it"},
    {"run_too_large", "it is larger than {} MiB"},
    {"run_too_deep", "lists within lists within lists"},
    {"run_large_number", "a number is too large"},
    {"no_source_of_scene", "the scene has no source called {}"},
    {"no_zone_of_scene", "the scene has no zone called {}"},
    {"no_obstacle_of_scene", "the scene has no obstacle called {}"},
    {"no_vehicle_of_scene", "the scene has no vehicle called {}"},
    {"no_kind_of_scene", "the scene has no kind called {}"},
    {"sealed_damaged", "this hidden brain is damaged; save the scene once more"},
    {"no_sensor_of_vehicle", "the vehicle has no sensor called {}"},
    {"name_zone", "; name one zone of the scene"},
    {"name_obstacle", "; name one obstacle of the scene"},
    {"name_vehicle", "; name one vehicle of the scene"},
    {"name_kind", "; name one kind of the scene"},
    {"name_sensor", "; name one sensor of the vehicle"},
    {"several_sources", "the scene has several sources; name the one that '{}' is about"},
    {"vehicle_of_check", "{} is the vehicle of this check; name another one"},
    {"about_first_vehicle", "'{}' is about the first vehicle, {}"},
    {"at_least", "'{}' should be at least '{}'"},
    {"more_than", "'{}' should be more than '{}'"},
    {"earlier_step", "'{}' should be the number of an earlier step"},
    {"goal_missing", "'goal' is missing; it is one of {}"},
    {"checks_missing", "the goal '{}' needs at least one check of its own"},
    {"no_control",
     "{} is no control; write dials like \"LR\" or \"LL=RR\", or one of \"wiring\", \"curves\", \"sensors\", "
     "\"selection\""},
    {"offered_twice", "{} is offered twice"},
    {"different_ranges", "{} joins dials of different ranges; offer them one by one"},
    {"not_another_kind", "{} is no kind of the scene other than the first vehicle's"},
    {"selection_not_offered", "'selection' has no effect; add \"selection\" to 'offers'"},
    {"changes_without_offers", "'changes' counts offered controls; add 'offers'"},
    {"changes_of_wires", "'changes' does not count wires; remove it, or \"wiring\" from 'offers'"},
    {"prediction_incomplete",
     "a prediction needs a question, two or more options, and one of them as its answer; with 'path' it may have no "
     "options"},
    {"no_widget", "the window has no widget {}"},
    {"more_needed_than_starts", "'needed' is {}, more than the {} starts"},
    {"median_step", "'median' compares step {}, and there are {} steps"},
    {"hint_text_missing", "a hint needs a text: text = \"…\""},
    {"source_outside", "{} is at ({}, {}), outside the arena of {} × {} m; move it inside"},
    {"sensor_unread", "no wire reads the sensor {}, and the student cannot add one; remove it, or offer \"wiring\""},
    {"starts_in", "with seed {} this vehicle starts in "},
    {"the_obstacle", "the obstacle {}"},
    {"the_solid", "the solid {}"},
    {"the_wall", "the wall"},
    {"starts_in_cure", "; move it, or reduce 'place_spread'"},
    {"done_at_start",
     "with seed {} this step is done at the start, before the vehicle moves; ask for more, or add 'earliest', 'hold' "
     "or 'after'"},
    {"equal_starts",
     "all {} starts are alike, so a brain that fits one passes; add 'heading_spread' or 'place_spread'"},
    {"answer_untested", "nothing tests that the run shows this answer; add a check as [[predict.shows]]"},
    {"run_before_answer", ". In {} s of the run with the shipped brain and seed {} the vehicle drives {} m"},
    {"left_before_answer", " and turns {}° to the left in all"},
    {"right_before_answer", " and turns {}° to the right in all"},
    {"straight_before_answer", " straight on"},
    {"source_before_answer", "; its distance to {} goes from {} m to {} m"},
    {"answer_of_any_brain",
     "every run meets the checks of the answer, also with the solution, with crossed wires and with the wrong answers, "
     "so they tell no option from another; test what only this answer shows"},
    {"answer_after_the_run",
     "the answer is visible after {} s, and a graded run lasts {} s; reduce 'after', or increase 'seconds'"},
    {"check_without_option",
     "this check belongs to no option, so a wrong 'answer' is not noticed; add option = \"{}\""},
    {"no_outcome", "the prediction has no 'outcome'; say what happens and why"},
    {"many_words", "goal, prediction question and options have {} words; students read at most {} before they act"},
    {"wrong_is_solution", "this wrong answer is the solution; change it, or remove it"},
    {"wrong_outside",
     "this wrong answer changes '{}', which the exercise does not offer, so no student gives it; offer it, or give the "
     "answer the value as shipped"},
    {"wrong_without_text", "this wrong answer has no 'text'; say what the student sees and which clue helps"},
    {"median_differs", "step {} needs {}; {} times the median as shipped is {}"},
    {"answer_contradicted",
     "the run with the shipped brain and seed {} does not meet this check in {} s, so it contradicts the answer; "
     "correct 'answer', 'after' or this check"},
    {"other_option_shown",
     "the run with the shipped brain and seed {} shows “{}”, so the answer “{}” is false; correct 'answer' or the "
     "checks"},
    {"not_translated", "{} has no translation of this text; add {}"},
    {"step_text_missing", "a step needs a text: text = \"It …\""},
    {"brain_of_first",
     "the first vehicle of an exercise has no brain of its own, as the student changes that of its kind; set it in "
     "[kind.{}]"},
    {"sensors_of_first",
     "the first vehicle of an exercise has no sensors of its own, as the student changes those of its kind; set them "
     "in [kind.{}]"},
    {"outside_answer",
     "the student cannot change {}; an answer sets the brain, the sensors and the body of the first vehicle's kind"},
    {"scene_or_exercise", "a page has either 'scene' or 'exercise'; give one of them"},
    {"no_scene_of_page", "there is no file and no shipped scene called {}"},
    {"no_exercise_of_page", "there is no file and no shipped exercise called {}"},
    {"few_options", "'options' needs two or more texts"},
    {"answer_missing", "'answer' is missing; give the text of the right option"},
    {"empty_page_step", "a step names at least one part"},
    {"no_page_part", "'{}' has no part {}"},
    {"missing_in_lecture", "'{}' is missing; a lecture has a title, minutes and [[page]] tables"},
    {"page_missing", "there is no page; add [[page]]"},
    {"list_of_numbers", "'{}' should be a list of numbers"},
    {"missing_in_study", "'{}' is missing; a study has a title, a scene, measures and [[value]] tables"},
    {"missing_in_value", "'{}' is missing; a [[value]] has a name, paths and levels"},
    {"no_measure", "there is no measure {}"},
    {"column_twice", "the table has two columns {}; give each its own name"},
    {"too_many_runs", "the study has {} runs, the most is {}; take fewer levels or seeds"},
    {"study_without_vehicle", "the scene has no vehicle to measure"},
    {"no_vehicle_to_select", "'select' names {}, which is no [vehicle.NAME] of the scene"},
    {"not_unfinished", "is not the unfinished table of a study; give the table another name, or remove this file"},
    {"unfinished_of_other",
     "has runs of another study; go on with that one, give the table another name, or remove this file"},
    {"study_table_locked", "another study writes this table; wait for its end, or give another file"},
    {"no_colour", "{} is no colour; write one like \"#3d7cc9\""},
    {"same_name", "two of [{}.…] are called {}; give each its own name"},
    {"too_many_times", "{} times [{}.…]; the most is {}"},
    {"off_before_on", "it goes off before it goes on; give an 'until' that is later than 'from'"},
    {"missing_in_breeding", "'{}' is missing; a breeding has a title, a scene and [[breed]] tables"},
    {"missing_in_breed", "'{}' is missing; a [[breed]] has a kind and [[breed.gene]] tables"},
    {"missing_in_gene", "'{}' is missing; a [[breed.gene]] has a name and paths"},
    {"gene_without_range", "the gene {} has no range; give a high above its low"},
    {"exceeds", "{} is {}, more than {}, which is {}; take less"},
    {"no_duel",
     "a breeding needs a scene with one predator and one prey; give two kinds these roles and one vehicle each"},
    {"breed_without_side", "no predator and no prey of the scene is of the kind {}"},
    {"breed_twice", "two [[breed]] tables are of the kind {}; write one"},
    {"other_breeding",
     "this is the state of another breeding; continue with its file and scene unchanged, or take another folder"},
    {"damaged_breeding", "not the state of a breeding, or damaged; delete it to begin anew"},
    {"no_such_value", "no such value {}"},
    {"a_plain_value", "{} should be a number, text, true or false"},
    {"named_tables", "[{}] holds named tables like [{}.one], and {} is "},
    {"short_texts", "'{}' should be a list of short texts"},
    {"key_of_other", "the {} '{}' has no '{}'; remove it"},
    {"key_of_own", "the {} '{}' needs '{}'; add it"},
    {"foreign_folder", "the folder holds other files than those of an export; give a new folder"},
    {"foreign_folder_window", "; export once more to write into it"},
    {"export_to_link", "is a link to another file or folder; remove it, or export to another folder"},
    {"files_exist", "these files exist already: {}; export once more to replace them"},
    {"no_such_sensor", "the brain reads the sensor {}, which the vehicle does not have; add it or cut its wires"},
    {"no_part", "the sensor {} senses {}, for which the robot has no part; cut its wires"},
    {"no_pin",
     "the sensor {} has no pin: the brain uses {} sensors, and the {} has {} analog inputs; cut the wires of some"},
    {"program_neurons", "{} neurons do not fit into the memory of the {}, which holds {}; remove some"},
    {"program_flash", "the program would have about {} bytes, and the {} holds {}; cut wires or remove neurons"},
    {"program_time",
     "a step would take about {} ms, and the {} allows {} ms at its lowest rate; take fewer sigmoids and humps"},
    {"program_bytes", "the program has {} bytes, {} of them for {}, and a {} takes {}; cut wires or remove neurons"},
    {"thymio_same_sensor", "the sensors {} and {} would both be the same sensor of a Thymio; cut the wires of one"},
    {"thymio_learns", "a wire into {} learns, which the program of a Thymio cannot do; set its learning rate to 0"},
    {"thymio_numbers",
     "numbers of {} can reach {}, and the program of a Thymio holds 32 at most; take smaller weights, or a curve that "
     "limits the values of a loop"},
    {"thymio_slow", "the time constant of {} is {} s, too long for the whole numbers of a Thymio; take a shorter one"},
    {"thymio_words",
     "the program would have about {} words, and a Thymio holds {}; cut wires, or take fewer humps and sigmoids"},
    {"circuit_neuron", "{} is a neuron, which this circuit cannot hold; take wires from sensors to motors only"},
    {"circuit_motor_curve", "the curve of {} is {}, which this circuit cannot hold; take a linear one"},
    {"circuit_memory", "{} has a time constant, which this circuit cannot hold; set it to 0"},
    {"circuit_bias", "the bias of {} is too small for a resistor; set it to 0"},
    {"circuit_motor_wire", "a wire into {} comes from a motor, which this circuit cannot hold; cut it"},
    {"circuit_learns", "the wire from {} to {} learns, which this circuit cannot hold; set its learning rate to 0"},
    {"circuit_threshold", "the wire from {} to {} has a threshold, which this circuit cannot hold; set it to 0"},
    {"circuit_wire_curve",
     "the wire from {} to {} has the curve {}, which this circuit cannot hold; take a linear one"},
    {"circuit_stands",
     "the wheel of {} never turns: its command is {} at most, and an L298 turns it from {} on, a TB6612 from {} on; "
     "the L298 takes a bias of {} or larger weights, else take a driver with an analog input"},
    {"circuit_may_stand",
     "the wheel of {} may never turn: its command is {} at most, and an L298 turns it for certain from {} on, a TB6612 "
     "from {} on; the L298 takes a bias of {} or larger weights, else take a driver with an analog input"},
    {"circuit_rest",
     "while its sensors sense nothing, in total darkness, the command of {} is {}, with which the lab's vehicle "
     "drives, "
     "and the driver {} turns the wheel for certain from {} on; raise its bias, or start the robot near what it "
     "senses"},
    {"circuit_rest_in_room",
     "while its sensors sense nothing but the light of the scene's room, the command of {} is {}, with which the lab's "
     "vehicle drives, and the driver {} turns the wheel for certain from {} on; raise its bias, or start the robot "
     "near "
     "what it senses"},
    {"circuit_inverted",
     "the part for {} gives nearly 1 above black and less above white, the reverse of the lab; give its wires the "
     "other "
     "sign, and add their old weight to the bias of the wire's motor"},
    {"part_beyond",
     "beyond the chassis, where nothing holds a sensor: {}; move each to at most half of its length and half of its "
     "width from the middle"},
    {"part_range", "the part reads up to {} m, the lab's sensor further: {}; set its range in the lab to that"},
    {"circuit_weak", "the wire from {} to {} is too weak for a resistor; set it to 0 or to {}"},
});

// Replaces the {} of the pattern by the values, in order. Surplus {} are kept.
template <class Values>
std::string filled(std::string_view pattern, const Values& values) {
    std::string text;
    auto value = values.begin();
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern.substr(i, 2) == "{}" && value != values.end()) {
            text += *value++;
            ++i;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

// A message in English and its parts.
struct Message {
    std::string text;
    std::vector<Phrase> phrases;

    Message() = default;
    // An English text, a name or a path that has no translation.
    explicit Message(std::string text_as_is) : text(std::move(text_as_is)), phrases{{{}, {text}}} {}

    Message& operator+=(const Message& next) {
        text += next.text;
        phrases.insert(phrases.end(), next.phrases.begin(), next.phrases.end());
        return *this;
    }
};
inline Message operator+(Message first, const Message& next) { return std::move(first += next); }

// A number and the limit that it passes, for a message with both: with so many digits in all, or behind the point, or
// with as many more as tell them apart.
enum class Digits { in_all, behind_point };
inline std::pair<std::string, std::string> told_apart(double value, double limit, Digits kind, int digits) {
    const auto text = [&](double number) {
        return kind == Digits::in_all ? fmt::format("{:.{}g}", number, digits) : fmt::format("{:.{}f}", number, digits);
    };
    constexpr int most = 17;  // digits of any double
    while (digits < most && value != limit && text(value) == text(limit)) ++digits;
    return {text(value), text(limit)};
}

// The id of a message of message_table that takes N values. Another text does not compile.
template <std::size_t N>
class MessageId {
public:
    consteval MessageId(const char* id) : row_(row_of(id)) {}
    constexpr const MessageText& text() const { return message_table[row_]; }

private:
    static consteval std::size_t row_of(std::string_view id) {
        for (std::size_t row = 0; row < message_table.size(); ++row) {
            const auto& [known, english] = message_table[row];
            if (known != id) continue;
            std::size_t gaps = 0;
            for (std::size_t at = english.find("{}"); at != english.npos; at = english.find("{}", at + 2)) ++gaps;
            if (gaps != N) throw "the message takes another number of values";
            return row;
        }
        throw "message_table has no message with this id";
    }

    std::size_t row_;
};

template <class... Values>
Message message_of(const MessageId<sizeof...(Values)>& id, const Values&... values) {
    Message made;
    made.phrases.push_back({id.text().id, {fmt::format("{}", values)...}});
    made.text = filled(id.text().english, made.phrases.front().values);
    return made;
}

inline Error error_of(Message message, std::string file = {}, int line = 0) {
    return {std::move(message.text), std::move(file), line, std::move(message.phrases)};
}

// The error's message without its place.
inline Message message_of(const Error& error) {
    if (error.phrases.empty()) return Message(error.what);
    Message message;
    message.text = error.what, message.phrases = error.phrases;
    return message;
}

}  // namespace braitenlab
