package org.mechservice.solver.force.law;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.result.Variable;

/**
 * What a force between two bodies is in MechML, if it is a law with numbers and nothing else: its
 * element, from which grammar, reader, checks, columns and the guide follow.
 *
 * @param element name of the element
 * @param acts between what, in words
 * @param law its law, in words and signs
 * @param energy what becomes of its work, in words
 * @param attributes its numbers, in the order of the law's coefficients
 * @param outputs names and SI units of its values
 * @param example what its example is
 */
public record ForceRow(
    String element,
    String acts,
    String law,
    String energy,
    List<Attribute> attributes,
    List<Variable> outputs,
    Example example) {
  /** What moves in an example, with the force between the ground and it. */
  public enum Trial {
    /** A block of 1 kg that slides along x, from rest 1 m from the origin. */
    BLOCK,
    /** A ball of 1 kg m² about every axis that turns about its centre, at first at 0.6 rad/s. */
    BALL
  }

  /**
   * An example.
   *
   * @param trial what moves in it
   * @param end how it ends after 1 s
   */
  public record Example(Trial trial, String end) {}

  /**
   * An attribute.
   *
   * @param name its name
   * @param unit its unit in SI, as MechML writes units
   * @param otherwise its value if it is not given; empty if it must be given
   * @param condition what the law needs of it
   * @param meaning in words
   * @param example value in the example of the guide, SI
   */
  public record Attribute(
      String name,
      String unit,
      Optional<Double> otherwise,
      Condition condition,
      String meaning,
      double example) {}

  public ForceRow {
    attributes = List.copyOf(attributes);
    outputs = List.copyOf(outputs);
  }
}
