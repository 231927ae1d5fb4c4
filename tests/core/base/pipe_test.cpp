#include "core/base/pipe.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

namespace analogon {
namespace {

TEST(Pipe, HandsOverWhatIsWrittenUntilItIsClosed) {
    std::optional<Pipe> pipe = Pipe::make();
    ASSERT_TRUE(pipe);
    ASSERT_EQ(write(pipe->write.number(), "abc", 3), 3);
    std::string text = "before ";
    EXPECT_TRUE(readSome(pipe->read.number(), text));
    EXPECT_EQ(text, "before abc");
    pipe->write.reset();
    EXPECT_FALSE(readSome(pipe->read.number(), text));
    EXPECT_EQ(text, "before abc");
}

}  // namespace
}  // namespace analogon
