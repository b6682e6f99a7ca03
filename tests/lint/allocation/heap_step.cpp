// SPDX-License-Identifier: MIT
/// \file
/// Refused: allocation. The pointer leaves the step, so that the optimiser has to keep it.
extern "C" void heap_step(int value, int** next) { *next = new int(value); }
