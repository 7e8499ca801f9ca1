/**
 * Class files in little room, for the JAR that carries the solver over the network.
 *
 * <p>A JAR deflates every class by itself, so each brings along the names they all share. Here a
 * constant is told once for all classes, and every number is coded by what was to be expected where
 * it stands: an opcode after the instructions before it, a field after its class, a letter after
 * the word so far ({@code Surroundings}, {@code Prediction}). This takes a fifth of the JAR's room.
 * That numbers are sorted by what they mean is the idea of JSR 200; the format is our own, far
 * simpler, and private to this package.
 *
 * <p>Unpacked classes have the same code, instruction by instruction; only the order of their
 * constants is another. This package is not itself part of what it packs.
 */
package org.mechservice.solver.pack;
