package org.mechservice.solver.mechanism;

/**
 * A number that may be changed without rebuilding the model; expressions refer to it by its index
 * in {@link Mechanism#parameters()}.
 *
 * @param name name in the model file
 * @param value in SI units
 * @param unit SI unit, {@code 1} for a pure number
 * @param unitInFile unit that the model file gives it in
 * @param numerator 1 unit of the file is numerator / denominator in SI
 * @param denominator see {@code numerator}
 */
public record Parameter(
    String name,
    double value,
    String unit,
    String unitInFile,
    double numerator,
    double denominator) {
  /** A parameter given in SI units. */
  public Parameter(String name, double value, String unit) {
    this(name, value, unit, unit, 1, 1);
  }

  /** Returns the value in the unit of the model file. */
  public double valueInFile() {
    return value * denominator / numerator;
  }

  /** Returns the same parameter with a value given in the unit of the model file. */
  public Parameter with(double valueInFile) {
    return new Parameter(
        name, valueInFile * numerator / denominator, unit, unitInFile, numerator, denominator);
  }
}
