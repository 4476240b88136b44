// SPDX-License-Identifier: GPL-3.0-or-later
#include "functionObjects/FunctionObject.hpp"

#include "case/TimeControl.hpp"

namespace isph {

FunctionObject::Table& FunctionObject::table()
{
    static Table one;
    return one;
}

Schema FunctionObject::keysWith(const Schema& own)
{
    Schema keys{
        Key::word("type", "What is measured."),
        Key::list("libs", "Libraries to load before the type is looked up.").mayBeAbsent(),
        Key::logical("enabled", "Whether it measures at all.").byDefault("yes"),
        Key::logical("log", "Whether each measurement is also printed in the log.").byDefault("no"),
        Key::scalar("startTime", "First time of measurement; from the beginning where absent.")
            .units(dims::time)
            .mayBeAbsent(),
        Key::scalar("endTime", "Last time of measurement; to the end where absent.")
            .units(dims::time)
            .mayBeAbsent(),
        Key::word("writeControl", "When a row is measured and written.")
            .byDefault("timeStep")
            .oneOf(TimeControl::kindNames()),
        Key::scalar("writeInterval", "Steps with timeStep (1 where absent), else seconds.")
            .above(0)
            .mayBeAbsent(),
        Key::word("executeControl", "When it measures besides, for the log or to accumulate.")
            .byDefault("none")
            .oneOf(TimeControl::kindNames()),
        Key::scalar("executeInterval", "As writeInterval.").above(0).mayBeAbsent(),
    };
    for (const Key& key : own.keys()) keys.add(key);
    return keys;
}

}  // namespace isph
