package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.dynamics.DataDrivenModel;

/** Agreement of what generated code and data compute. */
public final class ModelAgreement {
  private ModelAgreement() {}

  /**
   * Asserts that numbers agree.
   *
   * @param tolerance relative to the largest number expected
   */
  public static void assertClose(double[] actual, double[] expected, double tolerance) {
    double scale = Arrays.stream(expected).map(Math::abs).max().orElse(0);
    assertThat(actual).hasSameSizeAs(expected);
    for (int i = 0; i < expected.length; i++) {
      assertThat(Math.abs(actual[i] - expected[i]))
          .as("element %s: %s, expected %s", i, actual[i], expected[i])
          .isLessThanOrEqualTo(tolerance * scale);
    }
  }

  /** Asserts that energies, power and turnover agree, but for rounding times depth. */
  public static void assertEnergiesClose(
      Model model, DataDrivenModel reference, double t, double[] y) {
    double[] energy = new double[2];
    double[] energies = new double[2];
    ((Energies) ModelParts.of(model).equations()).energy(t, y, energy);
    reference.energy(t, y, energies);
    assertClose(energy, energies, 1e-12);
    double[] power = new double[2];
    double[] powers = new double[2];
    ((PowerInput) ModelParts.of(model).equations()).power(t, y, power);
    reference.power(t, y, powers);
    assertClose(new double[] {power[0]}, new double[] {powers[0]}, 1e-9);
    assertClose(new double[] {power[1]}, new double[] {powers[1]}, 1e-9);
  }
}
