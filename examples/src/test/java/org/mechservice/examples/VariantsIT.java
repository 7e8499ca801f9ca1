package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Laws of mechanics on the variants of the pendulum. */
class VariantsIT {
  /** rtol 1e-9 in the files; a hundredfold for what the motion amplifies. */
  private static final double AMPLIFIED_TOLERANCE = 1e-7;

  @TempDir Path directory;

  private Report simulate(String variant, String... options) {
    String[] command = new String[options.length + 5];
    command[0] = "simulate";
    command[1] = WorkingTree.TOP.resolve("examples/pendulum/variants/" + variant).toString();
    command[2] = "--out";
    command[3] = "r.csv";
    command[4] = "--json";
    System.arraycopy(options, 0, command, 5, options.length);
    return Report.printedBy(new Terminal(directory).mech(command));
  }

  private ResultRows results() {
    return ResultRows.read(directory.resolve("r.csv"));
  }

  /** The rail bears no horizontal force. */
  @Test
  void horizontalMomentumOfCartAndBarIsKept() {
    simulate("cart.xml");

    ResultRows results = results();
    double[] cartSpeed = results.column("slide.v");
    double[] angle = results.column("swing.q");
    double[] rate = results.column("swing.v");
    assertThat(angle).hasSize(301);
    double atStart = momentum(cartSpeed[0], angle[0], rate[0]);
    for (int i = 0; i < angle.length; i++) {
      assertThat(momentum(cartSpeed[i], angle[i], rate[i]))
          .isCloseTo(atStart, within(AMPLIFIED_TOLERANCE));
    }
  }

  /**
   * Returns the horizontal momentum: cart of 2 kg, bar of 1 kg, its centre 0.5 m from the hinge.
   */
  private static double momentum(double cartSpeed, double angle, double rate) {
    return 2 * cartSpeed + (cartSpeed - 0.5 * Math.sin(angle) * rate);
  }

  @Test
  void slidingCartKeepsItsUnitsInTheResults() {
    simulate("cart.xml");

    assertThat(results().columns())
        .containsExactly("t", "slide.q", "swing.q", "slide.v", "swing.v");
    assertThat(directory.resolve("r.units.json")).content().contains("\"m\"", "\"m/s\"", "\"rad\"");
  }

  @Test
  void energyOfCartAndBarIsKept() {
    Report report = simulate("cart.xml");

    assertThat(report.number("energyDrift") / report.number("energyScale"))
        .isLessThan(AMPLIFIED_TOLERANCE);
  }

  /** The two branches are the same bar; the right one's joint is written from outside inwards. */
  @Test
  void jointWrittenTheOtherWayRoundMovesWithTheSignChanged() {
    simulate("branching.xml");

    double[] left = results().column("j2.q");
    double[] right = results().column("j3.q");
    assertThat(left).hasSize(201);
    for (int i = 0; i < left.length; i++) {
      assertThat(right[i]).isCloseTo(-left[i], within(AMPLIFIED_TOLERANCE));
    }
  }

  @Test
  void energyOfTheBranchingTreeIsKept() {
    Report report = simulate("branching.xml");

    assertThat(report.number("energyDrift") / report.number("energyScale"))
        .isLessThan(AMPLIFIED_TOLERANCE);
  }

  @Test
  void gramAndMillimetreGiveTheSameAngles() {
    simulate("millimetre.xml", "--rtol", "1e-10", "--atol", "1e-12");

    assertThat(PendulumReference.errorOf(results())).isLessThan(1e-8);
  }

  @Test
  void integratorNamedInTheFileIsUsed() {
    assertThat(simulate("ode113.xml").text("integrator")).isEqualTo("ode113");
  }
}
