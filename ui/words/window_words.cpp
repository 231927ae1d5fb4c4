#include "ui/words/window_words.hpp"

#include <map>

namespace analogon::ui {

namespace {

/// Sentences that tell how a study is written down, and what is said of the same where it is worked on with mouse and
/// keys. Arguments stand in the same order.
const std::map<std::string_view, const char*>& windowSentences() {
    static const std::map<std::string_view, const char*> sentences{
        {"Use a part of the recordings (\"range\"), fewer of their columns or rows, a smaller "
         "model, or a machine with more memory.",
         "Use a part of the recordings (their range, or Trim above the traces), fewer of their "
         "columns or rows, a smaller model, or a machine with more memory."},
        {"Use a part of the recordings (\"range\"), or a smaller model.",
         "Use a part of the recordings (their range, or Trim above the traces), or a smaller "
         "model."},
        {"Use a part of the recordings (\"range\"), fewer of their rows, or fewer outputs of the "
         "model.",
         "Use a part of the recordings (their range, or Trim above the traces), fewer of their "
         "rows, or fewer outputs of the model."},
        {"Use a part of the recordings (\"range\"), fewer of their rows, or fit fewer parameters.",
         "Use a part of the recordings (their range, or Trim above the traces), fewer of their "
         "rows, or fit fewer parameters."},
        {"the search was ended after {:.0f} times the work of the fit of the model as given, and "
         "says what it had until then; with more patience (--patience {:.0f}) it goes on",
         "the search was ended after {:.0f} times the work of the fit of the model as given, and "
         "says what it had until then; Search ten times as long, in the result and in the menu Run, "
         "goes on"},
        {"{}: tell its start value, or fit it (\"initial\")", "{}: the start value of the model is another one"},
        {"no equation holds the output {}", "Nothing leads to {} yet: connect it, or write an equation for it."},
        {"the study has no experiment with the role \"fit\"", "no recording is used to fit"},
        {"Give an output of an experiment that is fitted a \"weight\" above 0, or none.",
         "Give a recording that is used to fit a weight above 0 in the table of recordings."},
        {"write \"{}\": {} under \"inputs\" of the study (in the window: the menu of the input "
         "among the measurements)",
         "it is set in the menu of the input {} among the measurements"},
        {"{}: {}; correct the header, or give the unit in the study, and search again",
         "{}: {}; correct the unit in the header of the file, and search again"},
        {"the input '{}' is stamped {:.3g} s late ({:.2g} samples; a mean over the last sample "
         "is late by half of one): the search reckons with it, the errors that are reported do "
         "not; set it in the study as its \"clock\": {:.3g}",
         "the input '{}' is stamped {:.3g} s late ({:.2g} samples; a mean over the last sample "
         "is late by half of one): the search reckons with it, the errors that are reported do "
         "not; set the clock in the menu of the input among the measurements to {:.3g} s"},
        {"'{}' does not begin where the model was told: what it begins with is estimated from it "
         "alone, and its errors are with that ({}; say so in the study with \"initial\": \"fit\")",
         "'{}' does not begin where the model was told: what it begins with is estimated from it "
         "alone, and its errors are with that ({})"},
        {"'{}' does not begin where the model was told: {} is {}{}{} there, not {:.5g}; it is "
         "fitted for this recording (\"initial\": \"fit\")",
         "'{}' does not begin where the model was told: {} is {}{}{} there, not {:.5g}; it is "
         "fitted for this recording"},
        {"what jumps has no slope: give it \"interpolation\": \"linear\", or let the model "
         "filter it",
         "what jumps has no slope: choose Straight between its samples in the menu of the input, "
         "or let the model filter it"},
        {"Remove these rows, fill the cells, or leave them out with \"range\": [from, to] in the "
         "study.",
         "Remove these rows, fill the cells, or leave them out with the range of the recording "
         "(or Trim above the traces)."},
        {"An input that is written only now and then is told how it runs between: "
         "\"interpolation\": \"hold\" or \"linear\".",
         "An input that is written only now and then is told how it runs between: Held or "
         "Straight between its samples, in its menu among the measurements."},
        {"Give the unit that its numbers are in, in the header or in the study as {{\"column\": "
         "\"{}\", \"unit\": …}}.",
         "Give the unit that its numbers are in in the header of the file: {} [unit]."},
        {"Say which it is in the study: {{\"column\": \"{}\", \"unit\": \"{}\"}} or "
         "{{\"column\": \"{}\", \"unit\": \"{}\"}}.",
         "Say which it is in the header of the file: {} [{}] or {} [{}]."},
        {"Where they are in another unit, give it in the study as {{\"column\": \"{}\", "
         "\"unit\": …}}.",
         "Where they are in another unit, give it in the header of the file: {} [unit]."},
        {"Map another column, or give the unit in the study as {{\"column\": \"{}\", \"unit\": "
         "…}}.",
         "Map another column, or give the right unit in the header of the file: {} [unit]."},
        {"Between rows, inputs run linearly in '{}'. Use \"range\" in the study to leave a part "
         "out.",
         "Between rows, inputs run linearly in '{}'. The range of the recording (or Trim above "
         "the traces) leaves a part out."},
        {"Choose another \"raster\", or leave the channel out.", "Map another column, or leave the channel out."},
        {"Name the column of its stamps: \"time\": {{\"column\": …, \"group\": …}}; or take "
         "channels of another group.",
         "Import the file again and choose the column of its stamps; or take channels of another "
         "group."},
        {"An output is never resampled: take the raster \"outputs\", or that of its own channel.",
         "An output is never resampled: take the raster of the outputs, or that of its own "
         "channel."},
        {"Where that matters take its stamps: \"raster\": \"{}\".", "Where that matters take its stamps: those of {}."},
        {"\"read\" tells how a text is written, and this is {}: it has no effect",
         "how a text is written has been told, and this is {}: it has no effect"},
        {"Did the sensor or the logger stick? It is used as it stands; leave the part out with "
         "\"range\", or empty the cells of an output.",
         "Did the sensor or the logger stick? It is used as it stands; leave the part out with "
         "the range of the recording, or empty the cells of an output."},
        {"Say it in the study: \"read\": {{\"decimal\": \"{}\"}} for {:.10g}, \"read\": "
         "{{\"thousands\": \"{}\"}} for {:.10g}.",
         "Say it at the import: the decimal sign is '{}' for {:.10g}, the sign between thousands "
         "is '{}' for {:.10g}."},
        {"\"decimal\" and \"thousands\" are the same mark",
         "the decimal sign and the sign between thousands are the same"},
        {"Split the file; or leave the first one out in the study: \"read\": {{\"skip\": {}}}.",
         "Split the file; or leave the first one out at the import: {} lines to skip."},
        {"Is it a measurement? If it is, tell the study how it is written: \"read\": "
         "{{\"separator\": …, \"decimal\": …, \"skip\": lines before the header}}.",
         "Is it a measurement? If it is, say at the import how it is written: the separator, the "
         "decimal sign, the lines to skip before the header."},
        {"Where it is a charge, give the unit in the study as {{\"column\": …, \"unit\": "
         "\"A.s\"}}.",
         "Where it is a charge, give the unit in the header of the file: [A.s]."},
        {"As inputs they are held from row to row with \"interpolation\": \"hold\".",
         "As inputs they are held from row to row with Held between its samples in the menu of "
         "the input."},
        {"Export the time with more digits, or tell the time between two rows: \"read\": "
         "{{\"time_format\": \"0.001 s\"}}.",
         "Export the time with more digits, or tell the time between two rows at the import, as "
         "the form of the time: 0.001 s."},
        {"Say how they are written in the study: \"read\": {{\"time_format\": \"%d.%m.%Y "
         "%H:%M:%S\"}}.",
         "Say how they are written at the import, as the form of the time: %d.%m.%Y %H:%M:%S."},
        {"Write \"time_zone\" as \"Europe/Berlin\", \"UTC\" or \"+02:00\".",
         "Write the time zone as Europe/Berlin, UTC or +02:00."},
        {"Tell how they are written in the study: \"read\": {{\"time_format\": …, \"time_zone\": "
         "…}}.",
         "Tell how they are written at the import: form of the time and time zone."},
        {"Say it in the study: \"read\": {{\"time_format\": \"%d/%m/%Y %H:%M:%S\"}} or "
         "\"%m/%d/%Y %H:%M:%S\".",
         "Say it at the import, as the form of the time: %d/%m/%Y %H:%M:%S or %m/%d/%Y %H:%M:%S."},
        {"If it is summer time, tell the zone of the clock in the study: \"read\": "
         "{{\"time_zone\": \"Europe/Berlin\"}}; if it is not, \"time_zone\": \"UTC\".",
         "If it is summer time, tell the time zone of the clock at the import: Europe/Berlin; if "
         "it is not, UTC."},
        {"Say it in the study: \"read\": {{\"unit_names\": {{\"{}\": \"{}\"}}}}.",
         "Say it at the import, where it is asked: '{}' is '{}'."},
        {"{}: {}; give the column \"scale\": -1 in the study, and search again",
         "{}: {}; give its column a scale of -1, and search again"},
        {"Where channels have times of their own, say it in the study: \"read\": {{\"times\": "
         "\"left\"}}, or \"right\".",
         "Where channels have times of their own, say it at the import, under Several times."},
        {"Say it in the study: \"read\": {{\"time_format\": \"%j:%H:%M:%S\"}} or \"%H:%M:%S:%f\".",
         "Say it at the import, as the form of the time: %j:%H:%M:%S or %H:%M:%S:%f."},
        {"Say it in the study: \"read\": {{\"time_format\": \"{}\"}} or {{\"time_format\": \"s\"}}.",
         "Say it at the import, as the form of the time: {} or s."},
        {"Say it in the study: \"read\": {{\"time_format\": \"%H:%M\"}} or \"%M:%S\".",
         "Say it at the import, as the form of the time: %H:%M or %M:%S."},
        {"\"time_format\" is written as \"%d.%m.%Y %H:%M:%S\", or as the time between two rows: "
         "\"0.001 s\".",
         "The form of the time is written as %d.%m.%Y %H:%M:%S, or as the time between two rows: "
         "0.001 s."},
        {"\"{}\" of \"read\" is not known here", "how the file is written has an entry that is not known here: {}"},
        {"Tell the time between two rows in the study: \"read\": {{\"time_format\": \"0.001 "
         "s\"}}, or as a rate: \"1 kHz\".",
         "Tell the time between two rows at the import, as the form of the time: 0.001 s, or as "
         "a rate: 1 kHz."},
        {"Say it in the study: \"read\": {{\"time_format\": \"s\"}} or {{\"time_format\": "
         "\"d\"}}.",
         "Say it at the import, as the form of the time: s or d."},
        {"The recording may have been started anew there: split the file before line {}, or use "
         "its first part alone (\"range\": [{:.6g}, {:.6g}]). If the clock was set back, add "
         "{:.4g} s from there on. Sorting the rows would mix two recordings.",
         "The recording may have been started anew there: split the file before line {}, or use "
         "its first part alone (range {:.6g} … {:.6g} s). If the clock was set back, add {:.4g} "
         "s from there on. Sorting the rows would mix two recordings."},
        {"Give one in the model, or as \"value\" in the study.", "Give one among the parameters, or in the model."},
        {"Widen the bounds, or do not fit it: \"fit\": false.",
         "Widen the bounds among the parameters, or do not fit it."},
        {"Widen the bounds, or give another start as \"value\".",
         "Widen the bounds, or give another value among the parameters."},
        {"Start above 0, or use \"scale\": \"lin\".", "Start above 0: give another value among the parameters."},
        {"Map the output as {{\"column\": …, \"clock\": \"fit\"}}.",
         "Set the clock of the output among the measurements to fit."},
        {"Take one back in: leave out its \"use\": false.", "Set the check box of a recording among the measurements."},
        {"Say which: {{\"column\": \"{}\", \"group\": …}}, one of {}.",
         "Say which {} it is: drag its column onto the signal among the measurements. Its "
         "groups: {}."},
        {"It holds words. If they are stamps of the time, tell how they are written: \"read\": "
         "{{\"time_format\": \"%d.%m.%Y %H:%M:%S\"}}.",
         "It holds words. If they are stamps of the time, tell how they are written at the "
         "import, as the form of the time: %d.%m.%Y %H:%M:%S."},
        {"Name it: \"time\": \"…\".", "Import the file again and choose its time column."},
        {"It is an output of the model: list it under \"outputs\".",
         "It is an output of the model: take its column from the input, and map it there."},
        {"It is an input of the model: list it under \"inputs\".",
         "It is an input of the model: take its column from the output, and map it there."},
        {"Add \"{}\": \"COLUMN\" to \"inputs\". {}", "Drag a column onto {} among the measurements. {}"},
        {"Put the model's text beside study.json as model.mo.",
         "Write the model, or take its text into the directory of the study as model.mo."},
        {"List parameters under \"parameters\", as \"NAME\": {{\"fit\": true}}.",
         "Check parameters in the list of parameters."},
        {"Give it \"interpolation\": \"hold\" there, too, or say \"linear\" where it is meant.",
         "Choose Held between its samples in its menu there, too, or Straight where it is meant."},
        {"this archive holds no study.json", "this archive holds no study"},
        {"A study archive holds study.json, a model (.mo) and its measurements at its top.",
         "Choose a file that was saved as a study."},
        {"Give the directory of a study, or its study.json.", "Choose a study file, or the directory of a study."},
        {"this directory holds no study.json", "this directory holds no study"},
        {"A study is a directory with study.json, a model (.mo) and its measurements.",
         "Choose a directory that was saved as a study."},
        {"the measurement is called \"{}\" in the study, which cannot name it as it is called",
         "the path of the measurement cannot be kept in the study: {}"},
    };
    return sentences;
}

}  // namespace

const char* windowPattern(const std::string& pattern) {
    const auto known = windowSentences().find(pattern);
    return known == windowSentences().end() ? nullptr : known->second;
}

}  // namespace analogon::ui
