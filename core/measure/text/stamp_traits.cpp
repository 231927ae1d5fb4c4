#include "core/measure/text/stamp_traits.hpp"

namespace analogon {

StampTraits traitsOf(const StampSeries& stamps) {
    StampTraits traits;
    for (const Stamp stamp : stamps) {
        traits.areMidnight = traits.areMidnight && stamp.nanoseconds == 0;
        if (!isTold(stamp)) continue;
        ++traits.count;
        traits.haveDate = traits.haveDate && stamp.hasDate();
        traits.haveClock = traits.haveClock && stamp.hasClock;
        traits.anyDate = traits.anyDate || stamp.hasDate();
        traits.haveZone = traits.haveZone && stamp.zone != Stamp::noZone;
        traits.anyZone = traits.anyZone || stamp.zone != Stamp::noZone;
        traits.haveTwoFields = traits.haveTwoFields && stamp.hasTwoFields;
        traits.anyFraction = traits.anyFraction || stamp.hasFraction;
        traits.mayCountDays = traits.mayCountDays && (stamp.mayCountDays || stamp.countsDays);
        traits.anyMayCountDays = traits.anyMayCountDays || stamp.mayCountDays;
        traits.anyCountsDays = traits.anyCountsDays || stamp.countsDays;
        if (stamp.hasDate()) traits.orders &= stamp.orders;
    }
    return traits;
}

}  // namespace analogon
