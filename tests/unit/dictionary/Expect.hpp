// SPDX-License-Identifier: GPL-3.0-or-later
// The errors of dictionaries, caught and looked at.
#pragma once
#include "core/Error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace isph::testing {

struct Failure {
    std::string message;
    std::string file;
    int line = -1;
};

/// What f() throws; an empty message and line -1 where it throws nothing.
template <class F>
Failure failureOf(F&& f)
{
    try {
        f();
    } catch (const FatalIOError& error) {
        return {error.what(), error.file(), error.line()};
    } catch (const FatalError& error) {
        return {error.what(), "", 0};
    }
    return {};
}

inline ::testing::AssertionResult says(const Failure& failure, const std::string& part)
{
    if (failure.message.find(part) != std::string::npos) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure()
           << "'" << part << "' is not in the message '" << failure.message << "'";
}

}  // namespace isph::testing
