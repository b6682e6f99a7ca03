// SPDX-License-Identifier: MIT
/// \file
/// Refused: floating point in a port alone.
extern "C" void port_step(const float* state, float* next) { *next = *state; }
