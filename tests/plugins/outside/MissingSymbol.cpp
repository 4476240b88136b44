// SPDX-License-Identifier: GPL-3.0-or-later
// A library whose author forgot to compile or link one file.
namespace isph {
double forgottenFunction();
double callsIt()
{
    return forgottenFunction();
}
}  // namespace isph
