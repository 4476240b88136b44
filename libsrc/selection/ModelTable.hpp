// SPDX-License-Identifier: GPL-3.0-or-later
// Runtime selection: models register under a name when their library is loaded, and a dictionary
// picks one by that name.
//
// A family F is an abstract class with
//     static constexpr const char* family = "porousModel";  // the word of messages and files
//     using Table = ModelTable<F, Args...>;                 // Args: what every model is made with
//     static Table& table();                                // defined in one .cpp of the family
// and a model M of it is a class with `static Schema keys();`, a constructor that takes
// (const Dictionary&, Args...) and, in its .cpp,
//     namespace { const F::Table::Entry<M> entry{"ergun"}; }
// A dictionary then says   porousModel ergun;  ergunCoeffs { ... }   (coefficients of other models
// may stand beside, so that changing a model is changing one word).
#pragma once
#include "dictionary/Schema.hpp"
#include "selection/Libraries.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace isph {

/// Raised by whatever changes a family interface; compiled into every model.
inline constexpr int kAbi = 1;

/// Throws FatalIOError: "Unknown porousModel type foo\n\nValid porousModel types are:\n\n3\n(...".
[[noreturn]] void failUnknownModel(const std::string& family, const std::string& name,
                                   const std::vector<std::string>& valid, const Dictionary& where,
                                   std::string_view key);

/// <name>Coeffs of `dict`; empty, but so named, where it is absent and none of its keys is
/// required. Throws FatalIOError where a required sub-dictionary is missing.
Dictionary modelCoefficients(const Dictionary& dict, const std::string& name, const Schema& keys);

/// What every table shows to those that list models.
class AnyModelTable {
public:
    virtual ~AnyModelTable();
    /// Registered names, sorted; loads the family's library.
    virtual std::vector<std::string> names() const = 0;
    /// The keys of a registered model.
    virtual Schema keys(const std::string& name) const = 0;

protected:
    explicit AnyModelTable(const char* family);  ///< enters the table in modelFamilies()
};

/// The tables of all families whose libraries are loaded, by name.
const std::map<std::string, const AnyModelTable*>& modelFamilies();

template <class Family, class... Args>
class ModelTable : public AnyModelTable {
public:
    ModelTable() : AnyModelTable(Family::family) {}

    using Make = std::unique_ptr<Family> (*)(const Dictionary&, Args...);
    struct Row {
        Make make;
        Schema (*keys)();
    };

    /// Called while a library is being loaded, so it must not throw: conflicts are noted for later.
    void add(const char* name, Row row, int abi) noexcept
    {
        if (abi != coreAbi()) return noteConflict(Family::family, name, abi);
        const auto [place, added] = rows_.emplace(name, row);
        if (!added)
            noteConflict(Family::family, name, abi,
                         reinterpret_cast<const void*>(place->second.make));
    }

    /// The model called `name`, made from its coefficients after they were checked against its
    /// keys. `where` and `key` are the entry that named it, for the error message.
    std::unique_ptr<Family> make(const std::string& name, const Dictionary& coefficients,
                                 const Dictionary& where, std::string_view key, Args... args) const
    {
        const Row& row = find(name, where, key);
        row.keys().check(coefficients);
        return row.make(coefficients, args...);
    }

    /// The model that `dict`, among other keys, names by the word at `key`; made from <name>Coeffs.
    std::unique_ptr<Family> select(const Dictionary& dict, std::string_view key, Args... args) const
    {
        const std::string name = dict.get<std::string>(key);
        const Schema keys = find(name, dict, key).keys();
        return make(name, modelCoefficients(dict, name, keys), dict, key, args...);
    }

    /// As select(), for a dictionary that holds nothing but this choice:  <family> <name>;
    /// <name>Coeffs {...}, and perhaps the coefficients of other models. Any other key is an error.
    std::unique_ptr<Family> selectOnly(const Dictionary& dict, Args... args) const
    {
        if (dict.found(Family::family))
            find(dict.get<std::string>(Family::family), dict, Family::family);
        choiceKeys().check(dict);
        return select(dict, Family::family, args...);
    }

    const Row& find(const std::string& name, const Dictionary& where, std::string_view key) const
    {
        loadFamily(Family::family);
        const auto it = rows_.find(name);
        if (it == rows_.end()) failUnknownModel(Family::family, name, names(), where, key);
        return it->second;
    }

    std::vector<std::string> names() const override
    {
        loadFamily(Family::family);
        std::vector<std::string> all;
        for (const auto& [name, row] : rows_) all.push_back(name);
        return all;
    }

    Schema keys(const std::string& name) const override { return rows_.at(name).keys(); }

    template <class Model>
    struct Entry {
        explicit Entry(const char* name)
        {
            Family::table().add(
                name,
                {[](const Dictionary& dict, Args... args) -> std::unique_ptr<Family> {
                     return std::make_unique<Model>(dict, args...);
                 },
                 &Model::keys},
                kAbi);
        }
    };

private:
    Schema choiceKeys() const
    {
        Schema all{Key::word(Family::family, "the model")};
        for (const std::string& name : names())
            all.add(Key::dictionary(name + "Coeffs", "coefficients of " + name).mayBeAbsent());
        return all;
    }

    std::map<std::string, Row> rows_;
};

}  // namespace isph
