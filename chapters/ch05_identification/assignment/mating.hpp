#pragma once

#include <functional>

#include <Eigen/Core>

/// @file
/// The header to keep: write this function in mating.cpp, and change nothing here. Only your variant is to be coded,
/// which the head of the score table names: run the check once to learn it.

/// Draws a number in [0, 1), anew with each call and independent of all before.
using Uniform = std::function<double()>;

/// Replaces strings by the children of others.
/// @param strings  one a column, counted from 0, in order of rank: the first K are parents, and stay; the next K become
///                 their children, number K + n the child n of the brief; those behind stay
/// @param K        how many parents there are, >= 2, and as many children; even in variant 1
/// @param uniform  draws Phi
void mate(Eigen::MatrixXd& strings, Eigen::Index K, const Uniform& uniform);
