package org.mechservice.sim.emit.c;

import java.util.List;
import org.mechservice.solver.expression.TapeListing;
import org.mechservice.solver.symbol.Program;

/**
 * What the steps of a model in C watch.
 *
 * @param quantities program from time and state to the quantities: the leaves of the tape, then
 *     rates of angles, rad/s
 * @param quantityCount number of quantities
 * @param tape the formulas and their choices
 * @param turns groups of rates, as places among the quantities
 * @param contacts names of the contacts whose shapes may be inside each other too far
 * @param overlaps program from time and state to depth and largest depth of each of them, m
 */
public record CWatch(
    Program quantities,
    int quantityCount,
    TapeListing tape,
    List<List<Integer>> turns,
    List<String> contacts,
    Program overlaps) {
  public CWatch {
    turns = turns.stream().map(List::copyOf).toList();
    contacts = List.copyOf(contacts);
  }
}
