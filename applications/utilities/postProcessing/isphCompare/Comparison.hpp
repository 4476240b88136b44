// SPDX-License-Identifier: GPL-3.0-or-later
// Measured values beside expected ones, and one number for their difference.
#pragma once
#include "core/Types.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isph {

/// A value of a run beside what it should be.
struct Sample {
    Real time = 0;  ///< [s]
    Real measured = 0;
    Real expected = 0;
};

/// What the samples are taken from. Exactly one of series, profile and value is given.
struct Source {
    /// .dat file, or postProcessing/<name> for all its starts
    std::filesystem::path series, profile;
    std::optional<Real> value;
    std::string columns = "*";  ///< of a series: names or patterns, between blanks
    std::string along = "x";    ///< coordinate of a profile's points
    std::optional<Real> front;  ///< makes a series of a profile: the largest coordinate
                                ///< at which it stands above this level
    std::vector<Real> times;    ///< where given, values at these times, between rows linearly
    Real from, to;              ///< else the rows between these times
    Real delay = 0;             ///< how much later than the run a series' reference began
    Real average = 0;           ///< width of the moving average that is taken of a series [s]
};

/// What they are held against: a table, or one number.
struct Expectation {
    Real value = 0;
    /// Csv of t, value for a series; of t, x, value for a profile
    std::filesystem::path reference;
    bool band = false;  ///< of t, value, low, high: what lies between low and high is as expected
};

/// The samples, pooled over columns, times and points.
/// A series with a reference is compared at the times of the reference, a profile at its points at
/// the times of the source (all of the reference's, where none are given). A point of the reference
/// may lie outside the profile by 5 % of its length, a time after the last row by one row.
/// A band is compared at evenly spaced times; the expected value is that of the band next to the
/// measured one.
/// errors
/// FatalError, FatalIOError: no such file, column, time or point; a value that is no number
std::vector<Sample> samples(const Source& source, const Expectation& expectation);

/// Names of the measures: last mean max min rms range outside.
std::vector<std::string> measureNames();

/// One number >= 0 for the deviations d = measured - expected, no number where one of them is none:
///   last   |mean of d at the latest time|     mean  |mean of d|     rms  root of the mean of d^2
///   max    largest |d|                        min   smallest |d|
///   range  largest less smallest measured value       outside  share of samples with d not 0 [%]
Real measure(const std::string& name, const std::vector<Sample>& all);

/// Samples in per cent of the largest |expected|. Throws FatalError where that is 0.
std::vector<Sample> inPerCent(std::vector<Sample> all);

}  // namespace isph
