/**
 * Class files in little room, for the JAR that carries the solver over the network.
 *
 * <p>A JAR deflates every class by itself, so each brings along the names they all share. Here the
 * classes have one table of constants, and the numbers in them are sorted by what they mean into
 * bands (all opcodes, all local variables, all fields referred to by {@code getfield}, …), so that
 * like stands beside like; then every band is deflated. This takes about a third of the JAR's room.
 * The idea is that of JSR 200; the format is our own, far simpler, and private to this package.
 *
 * <p>Unpacked classes have the same code, instruction by instruction; only the order of their
 * constants is another. This package is not itself part of what it packs.
 */
package org.mechservice.solver.pack;
