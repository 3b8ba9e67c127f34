// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "evolver/jet.h"
#include "evolver/tokens.h"

namespace foam::evolver {

/// Values of a datafile's parameters, by name in lower case.
using Parameters = std::map<std::string, double, std::less<>>;

/// Takes the longest expression that the tokens begin with (Surface Evolver Manual, "Expressions"):
/// numbers, pi, parameters, functions and operators. White space before a minus, but none after it,
/// begins another number: 3 -5 are two, 3 - 5 and 3-5 are one.
/// \throws FoamError with line and cause, if there is none
double take_expression(Tokens& tokens, const Parameters& parameters);

/// What the variables of an expression stand for, by name in lower case.
template <class Value> using Variables = std::map<std::string, Value, std::less<>>;

/// The value of an expression, with its derivatives. As it stands alone, any minus is one of its
/// own. \param expression nothing else \throws FoamError with line and cause, if it is none
Jet jet_of(const std::vector<Token>& expression, const Parameters& parameters,
           const Variables<Jet>& variables);

/// Takes a whole number, or a sign and one.
/// \param what it is, for the message \throws FoamError if there is none
long long take_integer(Tokens& tokens, const std::string& what);

/// What a token is, for a message.
std::string described(const Token& token);

} // namespace foam::evolver
