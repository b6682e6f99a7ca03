// SPDX-License-Identifier: MIT
/// \file
/// Refused: indirect call; which function runs is data.
extern "C" void function_pointer_step(int value, int (*function)(int), int* next) { *next = function(value); }
