// SPDX-License-Identifier: GPL-3.0-or-later
// Flows whose water level, volume and fields are known: lattices of water in a tank.
#pragma once
#include "core/Vec.hpp"
#include "functionObjects/FunctionObject.hpp"

#include <functional>
#include <string>

namespace isph::test {

/// A tank 0 <= x <= length (and 0 <= z <= width in 3-D) with its floor at y = 0 and walls of four
/// layers, open at the top.
struct Tank {
    int dimension = 2;
    Real spacing = 0.01;
    Real length = 0.2, width = 0.2, height = 0.3;
    std::string kernel = "wendlandC2";
    Real smoothingRatio = 1.5;
};

/// The empty tank: kernel, gravity and walls.
FlowView emptyTank(const Tank& tank);

/// Adds water of the given porosity on a lattice of d0/eps^(1/D) that begins half a spacing from
/// the corner low and ends before high (in 2-D z is ignored). With U = 0 and p = 0.
void addWater(FlowView& flow, const Vector3& low, const Vector3& high, Real porosity = 1);

/// Moves every water particle by up to `share` of its spacing in each direction, by a fixed
/// sequence.
void jitter(FlowView& flow, Real share);

/// Turns the particles and gravity by `angle` [rad] about the z axis through the origin.
void turn(FlowView& flow, Real angle);
Vector3 turned(const Vector3& x, Real angle);

void setPressure(FlowView& flow, const std::function<Real(const Vector3&)>& p);
void setVelocity(FlowView& flow, const std::function<Vector3(const Vector3&)>& u);

/// The function object that the text of a dictionary describes.
std::unique_ptr<FunctionObject> make(const std::string& text);

}  // namespace isph::test
