package org.mechservice.benchmarks.paper;

import java.util.List;

/** The figures of the paper: Pentium II and III at 400 to 500 MHz, JDK 1.2.2. */
final class PaperFigures {
  private PaperFigures() {}

  /** The scenes of the tables, in their order, and our files of them. */
  enum Scene {
    PENDULUM("pendulum", "pendulum/pendulum.xml"),
    SUSPENSION("five-point suspension", "five-point-suspension/variants/elements.xml"),
    DRIVER("driver", "driver/variants/driver-c0-elements.xml"),
    DAMPED_DRIVER("driver, C = K/100", "driver/variants/driver-ck100-elements.xml");

    final String label;
    final String file;

    Scene(String label, String file) {
      this.label = label;
      this.file = file;
    }
  }

  /**
   * A line of Table I.
   *
   * @param label name of the figure
   * @param key of our run report; empty for a figure that is measured otherwise
   * @param unit kB or s
   * @param paper for pendulum, suspension and driver
   */
  record SetUpLine(String label, String key, String unit, List<Double> paper) {
    SetUpLine {
      paper = List.copyOf(paper);
    }
  }

  static final List<SetUpLine> TABLE_I =
      List.of(
          new SetUpLine("MechML file", "mechmlBytes", "kB", List.of(4.3, 5.6, 33.5)),
          new SetUpLine("model JAR", "modelClassBytes", "kB", List.of(2.2, 7.1, 11.8)),
          new SetUpLine("solver code", "runtimeJarBytes", "kB", List.of(125.0, 125.0, 125.0)),
          new SetUpLine("t1c: model sent and treated", "t1c", "s", List.of(0.10, 0.11, 0.32)),
          new SetUpLine("t1s: of that in the server", "t1s", "s", List.of(0.08, 0.09, 0.23)),
          new SetUpLine("t2c: JARs made and fetched", "t2c", "s", List.of(0.22, 0.69, 1.13)),
          new SetUpLine("t2s: of that in the server", "t2s", "s", List.of(0.11, 0.32, 0.55)),
          new SetUpLine("tcc: compile", "tcc", "s", List.of(0.21, 0.25, 0.31)),
          new SetUpLine("tR: set-up of a remote run", "tR", "s", List.of(0.38, 0.51, 0.70)),
          new SetUpLine("tL: set-up of a local run", "tL", "s", List.of(0.62, 1.15, 1.82)));

  /**
   * Run times of Table II, s.
   *
   * @param label program
   * @param explicit its explicit method, for pendulum, driver C = 0 and C = K/100
   * @param implicit its implicit method, likewise
   */
  record RunLine(String label, List<Double> explicit, List<Double> implicit) {
    RunLine {
      explicit = List.copyOf(explicit);
      implicit = List.copyOf(implicit);
    }
  }

  static final List<RunLine> TABLE_II =
      List.of(
          new RunLine(
              "SIMPACK LSODE / SODASRT", List.of(0.15, 6.95, 39.03), List.of(0.29, 8.40, 0.79)),
          new RunLine(
              "C++ DTR-DE / RR-JF-ode15sR", List.of(0.08, 2.35, 8.02), List.of(0.10, 3.32, 0.25)),
          new RunLine(
              "Java DTR-DE / RR-JF-ode15sR",
              List.of(0.14, 3.94, 13.06),
              List.of(0.24, 7.98, 0.53)));
}
