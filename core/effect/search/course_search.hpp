#pragma once

#include "core/effect/course/courses.hpp"
#include "core/effect/search/round.hpp"

/// Parameters that change, in mid run or with a recorded channel, beside what the search for effects comes to.
namespace analogon {

class SearchContext;

/// Looks once for the best course of each family (Courses) beside the model as given: a parameter that changed in mid
/// run is imitated by many slow effects; none of them is it.
void seekCourses(SearchContext& search, const NullModel& base);

/// Whether one course leaves noise alone and is a better account than these effects, by so much evidence.
bool isCourseAll(SearchContext& search, const NullModel& base, const NullModel& with,
                 double leastGain = equivalenceMargin);

/// Whether one course leaves noise alone where the effect that the first round chose leaves far too much for it to be
/// half of a pair: none is added to it then.
bool isCourseAlone(SearchContext& search, const NullModel& base, const Round& first);

/// Says of a course that was found that it is the better account.
Text betterAccount(const Courses& courses);

/// Keeps the best of the courses where it is a better account than the effects that were found.
void settleCourses(SearchContext& search, const NullModel& base, const NullModel& with);

}  // namespace analogon
