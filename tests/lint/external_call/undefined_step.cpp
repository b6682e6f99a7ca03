// SPDX-License-Identifier: MIT
/// \file
/// Refused: a call to a function that the top does not define.
int somewhere_else(int value);

extern "C" void undefined_step(int value, int* next) { *next = somewhere_else(value); }
