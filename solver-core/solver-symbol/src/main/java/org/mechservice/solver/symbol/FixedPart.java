package org.mechservice.solver.symbol;

/** What a call reads that is known when the program is made: numbers, or a function of points. */
sealed interface FixedPart permits NumberRow, GivenFunction {}
