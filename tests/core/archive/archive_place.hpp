#pragma once

#include <gtest/gtest.h>

#include "core/base/owned_directory.hpp"

namespace analogon {

/// A directory of its own, gone with the test.
class ArchivePlace : public testing::Test {
protected:
    void SetUp() override {
        auto made = TemporaryDirectory::make();
        ASSERT_TRUE(made);
        holder = *made;
        root = holder->path();
    }

    std::shared_ptr<const TemporaryDirectory> holder;
    std::filesystem::path root;
};

}  // namespace analogon
