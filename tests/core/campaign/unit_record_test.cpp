#include "core/campaign/unit_record.hpp"

#include <cmath>
#include <limits>

#include "tests/core/campaign/campaign_folder.hpp"

namespace analogon {
namespace {

TEST(UnitRecord, ReadsBackAsItWasWritten) {
    UnitRecord record;
    record.unit = "A \"1\"";
    record.fingerprint = "00ff";
    record.finding = "effect";
    record.effects = {{"friction.coulomb", "rotor.flange_a"}};
    record.parameters = {{"k", "1", 0.1 + 0.2, std::numeric_limits<double>::quiet_NaN()}};
    record.errorAfter = 1.0 / 3;
    record.work = 12345;
    const std::optional<UnitRecord> read = parseUnitJson(unitJson(record));
    ASSERT_TRUE(read);
    EXPECT_EQ(unitJson(*read), unitJson(record));
    EXPECT_EQ(read->parameters[0].value, record.parameters[0].value);
    EXPECT_TRUE(std::isnan(read->parameters[0].standardError));
    EXPECT_TRUE(read->isDone());
}

TEST(UnitRecord, IsNoneWhereTheTextIsCutOrOfAnotherKind) {
    const std::string whole = unitJson(UnitRecord{});
    for (std::size_t size = 0; size + 2 < whole.size(); size += 7) EXPECT_FALSE(parseUnitJson(whole.substr(0, size)));
    EXPECT_FALSE(parseUnitJson("{\"format\": \"analogon-report-1\"}"));
}

}  // namespace
}  // namespace analogon
