package org.mechservice.mechml;

import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What is wanted of a model file beside what it says.
 *
 * @param simulation name or number, from 1, of the {@code MBSsimulation} wanted; empty: the first
 * @param values parameters set to other values: name and expression, read in the unit that the file
 *     gives the parameter
 * @param tunable names of parameters that are to stay inputs of the model, besides those the file
 *     marks
 */
public record ReadOptions(
    Optional<String> simulation, Map<String, String> values, Set<String> tunable) {
  /** The file as it is. */
  public static final ReadOptions NONE = new ReadOptions(Optional.empty(), Map.of(), Set.of());

  public ReadOptions {
    values = Map.copyOf(values);
    tunable = Set.copyOf(tunable);
  }

  /** Returns options that set parameters. */
  public static ReadOptions setting(Map<String, String> values) {
    return new ReadOptions(Optional.empty(), values, Set.of());
  }

  /** Returns options that choose a simulation. */
  public static ReadOptions choosing(String simulation) {
    return new ReadOptions(Optional.of(simulation), Map.of(), Set.of());
  }
}
