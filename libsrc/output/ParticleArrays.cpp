// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/ParticleArrays.hpp"

#include "core/Error.hpp"

#include <fmt/core.h>

#include <cmath>
#include <concepts>
#include <type_traits>

namespace isph {

namespace {

enum class Absent { isError, isZero, isEmpty };

/// Set is Kind<2> or Kind<3>, const where it is written.
template <class Set, template <int> class Kind>
concept OneOf = std::same_as<std::remove_const_t<Set>, Kind<2>> ||
    std::same_as<std::remove_const_t<Set>, Kind<3>>;

template <class Set, class Each>
requires OneOf<Set, Water>
void eachField(Set& water, Each&& field)
{
    field("U", water.u);
    field("UOld", water.uOld, Absent::isZero);
    field("forceGradient", water.forceGradient, Absent::isZero);
    field("forceGradientOld", water.forceGradientOld, Absent::isZero);
    field("porosityOfU", water.porosity, Absent::isEmpty);
    field("porosityOfUOld", water.porosityOld, Absent::isEmpty);
    field("pEquation", water.p, Absent::isZero);
    field("id", water.id);
}

template <class Set, class Each>
requires OneOf<Set, Walls>
void eachField(Set& walls, Each&& field)
{
    field("normal", walls.normal);
    field("depth", walls.depth);
    field("volume", walls.volume);
    field("wall", walls.wall);
    field("id", walls.id);
    field.names("wallNames", walls.names);
}

template <class Set, class Each>
requires OneOf<Set, Soil>
void eachField(Set& soil, Each&& field)
{
    field("U", soil.u, Absent::isZero);
    field("solidVolume", soil.solidVolume);
    field("zone", soil.zone);
    field("released", soil.released, Absent::isZero);
    field("id", soil.id);
    field.names("zoneNames", soil.names);
}

[[noreturn]] void fail(const ParticleFile& file, const std::string& message)
{
    throw FatalIOError(message, file.source, 0);
}

template <int Dim>
class Reading {
public:
    explicit Reading(const ParticleFile& file) : file_(file) {}

    void operator()(const std::string& name, std::vector<Vec<Dim>>& to,
                    Absent absent = Absent::isError) const
    {
        const auto* from = find(file_.vectors, name, absent);
        to.assign(file_.size(), {});
        for (std::size_t i = 0; from && i < to.size(); ++i) to[i] = finite(name, (*from)[i], i);
    }
    void operator()(const std::string& name, std::vector<Real>& to,
                    Absent absent = Absent::isError) const
    {
        const auto* from = find(file_.scalars, name, absent);
        to.assign(from || absent != Absent::isEmpty ? file_.size() : 0, 0);
        for (std::size_t i = 0; from && i < to.size(); ++i) to[i] = finite(name, (*from)[i], i);
    }
    void operator()(const std::string& name, std::vector<std::int64_t>& to,
                    Absent absent = Absent::isError) const
    {
        const auto* from = find(file_.integers, name, absent);
        if (from)
            to = *from;
        else
            to.assign(file_.size(), 0);
    }
    void names(const std::string& name, std::vector<std::string>& to) const
    {
        to = *find(file_.names, name, Absent::isError);
    }

    std::vector<Vec<Dim>> points(Real flat) const
    {
        std::vector<Vec<Dim>> x(file_.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] = finite("points", file_.points[i], i);
            if (Dim == 2 && !(std::abs(file_.points[i][2]) <= flat))
                fail(file_, fmt::format("Particle {} has z = {:g} in a case of two dimensions.", i,
                                        file_.points[i][2]));
        }
        return x;
    }
    /// Every index has a name.
    void requireNamed(const std::string& name, const std::vector<std::int64_t>& index,
                      std::size_t count) const
    {
        for (std::size_t i = 0; i < index.size(); ++i)
            if (index[i] < 0 || index[i] >= static_cast<std::int64_t>(count))
                fail(file_,
                     fmt::format(
                         "{} of particle {} is {}, but the list {}Names has {} names, from 0 on.",
                         name, i, index[i], name, count));
    }
    void requireNotNegative(const std::string& name, const std::vector<Real>& values) const
    {
        for (std::size_t i = 0; i < values.size(); ++i)
            if (values[i] < 0)
                fail(file_, fmt::format("{} of particle {} is {:g}, allowed: {} >= 0.", name, i,
                                        values[i], name));
    }
    void requireUnit(const std::string& name, const std::vector<Vec<Dim>>& values) const
    {
        constexpr Real rounding = 1e-6;  // of a program that keeps them in single precision
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!(std::abs(norm(values[i]) - 1) <= rounding))
                fail(file_, fmt::format("{} of particle {} has the length {:g}, allowed: 1.", name,
                                        i, norm(values[i])));
    }

private:
    template <class Map>
    const typename Map::mapped_type* find(const Map& fields, const std::string& name,
                                          Absent absent) const
    {
        const auto it = fields.find(name);
        if (it != fields.end()) return &it->second;
        if (absent == Absent::isError)
            fail(file_,
                 fmt::format("The array {} is missing.\nWas the file written by createParticles or "
                             "isphPorousFoam?",
                             name));
        return nullptr;
    }
    Real finite(const std::string& name, Real value, std::size_t i) const
    {
        if (!std::isfinite(value))
            fail(file_, fmt::format("{} of particle {} is {:g}.", name, i, value));
        return value;
    }
    Vec<Dim> finite(const std::string& name, const Vector3& value, std::size_t i) const
    {
        Vec<Dim> v;
        for (int d = 0; d < Dim; ++d) v[d] = finite(name, value[static_cast<std::size_t>(d)], i);
        return v;
    }

    const ParticleFile& file_;
};

struct Writing {
    ParticleFile& file;

    template <int Dim>
    void operator()(const std::string& name, const std::vector<Vec<Dim>>& from, Absent = {})
    {
        file.vectors[name] = toVectors3(from);
    }
    void operator()(const std::string& name, const std::vector<Real>& from, Absent absent = {})
    {
        if (absent == Absent::isEmpty && from.empty()) return;
        file.scalars[name] = from;
    }
    void operator()(const std::string& name, const std::vector<std::int64_t>& from, Absent = {})
    {
        file.integers[name] = from;
    }
    void names(const std::string& name, const std::vector<std::string>& from)
    {
        file.names[name] = from;
    }
};

template <int Dim>
ParticleFile withPoints(const std::vector<Vec<Dim>>& x, Real spacing)
{
    ParticleFile file;
    file.points = toVectors3(x);
    file.numbers["spacing"] = {spacing};
    file.numbers["dimension"] = {Real(Dim)};
    return file;
}

/// Of the spacing: a z of a 2-D case that is no more than the noise of another program.
constexpr Real kFlat = 1e-6;

template <int Dim>
std::vector<Vec<Dim>> pointsOf(const ParticleFile& file)
{
    return Reading<Dim>(file).points(kFlat * file.number("spacing"));
}

template <template <int> class Kind, int Dim>
Kind<Dim> setOf(const ParticleFile& file, const Reading<Dim>& reading)
{
    Kind<Dim> set;
    set.x = pointsOf<Dim>(file);
    eachField(set, reading);
    return set;
}

template <int Dim, class Set>
ParticleFile fileOfSet(const Set& set, Real spacing)
{
    ParticleFile file = withPoints<Dim>(set.x, spacing);
    eachField(set, Writing{file});
    return file;
}

}  // namespace

template <int Dim>
Water<Dim> waterOf(const ParticleFile& file)
{
    auto water = setOf<Water>(file, Reading<Dim>(file));
    if (!file.vectors.contains("UOld")) water.uOld = water.u;
    if (water.porosityOld.empty()) water.porosityOld = water.porosity;
    if (!file.vectors.contains("forceGradientOld")) water.forceGradientOld = water.forceGradient;
    return water;
}

template <int Dim>
Walls<Dim> wallsOf(const ParticleFile& file)
{
    const Reading<Dim> reading(file);
    auto walls = setOf<Walls>(file, reading);
    reading.requireNamed("wall", walls.wall, walls.names.size());
    reading.requireNotNegative("volume", walls.volume);
    reading.requireUnit("normal", walls.normal);
    return walls;
}

template <int Dim>
Soil<Dim> soilOf(const ParticleFile& file)
{
    const Reading<Dim> reading(file);
    auto soil = setOf<Soil>(file, reading);
    reading.requireNamed("zone", soil.zone, soil.names.size());
    reading.requireNotNegative("solidVolume", soil.solidVolume);
    return soil;
}

template <int Dim>
ParticleFile fileOf(const Water<Dim>& water, Real spacing)
{
    return fileOfSet<Dim>(water, spacing);
}

template <int Dim>
ParticleFile fileOf(const Walls<Dim>& walls, Real spacing)
{
    return fileOfSet<Dim>(walls, spacing);
}

template <int Dim>
ParticleFile fileOf(const Soil<Dim>& soil, Real spacing)
{
    return fileOfSet<Dim>(soil, spacing);
}

void requireSameCase(const ParticleFile& file, Real spacing, int dimension)
{
    const auto same = [&](const std::string& name, Real now) {
        const Real then = file.number(name);
        if (std::abs(then - now) > 1e-9 * now)
            fail(file, fmt::format("made with {} {}, but system/particlesDict now has {}: run "
                                   "createParticles again",
                                   name, then, now));
    };
    same("spacing", spacing);
    same("dimension", dimension);
}

#define ISPH_INSTANTIATE(Dim)                              \
    template Water<Dim> waterOf(const ParticleFile&);      \
    template Walls<Dim> wallsOf(const ParticleFile&);      \
    template Soil<Dim> soilOf(const ParticleFile&);        \
    template ParticleFile fileOf(const Water<Dim>&, Real); \
    template ParticleFile fileOf(const Walls<Dim>&, Real); \
    template ParticleFile fileOf(const Soil<Dim>&, Real);
ISPH_INSTANTIATE(2)
ISPH_INSTANTIATE(3)
#undef ISPH_INSTANTIATE

}  // namespace isph
