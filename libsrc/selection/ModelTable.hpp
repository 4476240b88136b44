// SPDX-License-Identifier: GPL-3.0-or-later
// Runtime selection: models register under a name when their library is loaded, and a dictionary
// picks one by that name.
//
// A family F is an abstract class with
//     static constexpr const char* family = "porousModel";   // the word of messages and dictionaries
//     using Table = ModelTable<F, Args...>;                   // Args: what every model is made with
//     static Table& table();                                  // defined in one .cpp of the family
// and a model M of it is a class with `static Schema keys();`, a constructor (const Dictionary&, Args...)
// and, in its .cpp,
//     namespace { const F::Table::Entry<M> entry{"ergun"}; }
#pragma once
#include "dictionary/Schema.hpp"
#include "selection/Libraries.hpp"

#include <map>
#include <memory>
#include <string>

namespace isph {

/// Raised by whatever changes a family interface; compiled into every model.
inline constexpr int kAbi = 1;

template <class Family, class... Args>
class ModelTable {
public:
    using Make = std::unique_ptr<Family> (*)(const Dictionary&, Args...);
    struct Row {
        Make make;
        Schema (*keys)();
    };

    /// Called while a library is being loaded, so it must not throw: conflicts are noted for later.
    void add(const char* name, Row row, int abi) noexcept
    {
        if (abi != coreAbi() || !rows_.emplace(name, row).second) noteConflict(Family::family, name, abi);
    }

    /// The model called `name`, made from its coefficients after they were checked against its keys.
    /// `where` and `key` are the entry that named it, for the error message.
    std::unique_ptr<Family> make(const std::string& name, const Dictionary& coefficients,
                                 const Dictionary& where, std::string_view key, Args... args) const
    {
        const Row& row = find(name, where, key);
        row.keys().check(coefficients);
        return row.make(coefficients, args...);
    }

    const Row& find(const std::string& name, const Dictionary& where, std::string_view key) const
    {
        loadFamily(Family::family);
        const auto it = rows_.find(name);
        if (it == rows_.end()) failUnknownModel(Family::family, name, names(), where, key);
        return it->second;
    }

    /// Registered names, sorted; loads the family's library.
    std::vector<std::string> names() const
    {
        loadFamily(Family::family);
        std::vector<std::string> all;
        for (const auto& [name, row] : rows_) all.push_back(name);
        return all;
    }

    Schema keys(const std::string& name) const { return rows_.at(name).keys(); }

    template <class Model>
    struct Entry {
        explicit Entry(const char* name)
        {
            Family::table().add(name,
                                {[](const Dictionary& dict, Args... args) -> std::unique_ptr<Family> {
                                     return std::make_unique<Model>(dict, args...);
                                 },
                                 &Model::keys},
                                kAbi);
        }
    };

private:
    std::map<std::string, Row> rows_;
};

/// "Unknown porousModel type foo\n\nValid porousModel types are:\n\n3\n(\n...": throws FatalIOError.
[[noreturn]] void failUnknownModel(const std::string& family, const std::string& name,
                                   const std::vector<std::string>& valid, const Dictionary& where,
                                   std::string_view key);

}  // namespace isph
