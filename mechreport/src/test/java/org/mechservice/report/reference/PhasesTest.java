package org.mechservice.report.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Solutions that are parted: both kinds of codes end and begin phases where they should. */
class PhasesTest {
  private static Stream<ReferenceCode> codes() {
    return Stream.of(new RadauCode(5), new RadauCode(7), new ExtrapolationCode(8));
  }

  private static double[][] solve(
      ReferenceCode code, Problem problem, double[] times, double... y0) {
    double tolerance = code instanceof RadauCode ? 1e-12 : 1e-13;
    return code.solve(problem, times, y0, tolerance, Long.MAX_VALUE).orElseThrow();
  }

  /** x'' = −x, and what is done where x passes a level. */
  private static final class Swing implements Problem, Phases {
    private final double level;
    private final boolean rising;
    private final boolean falling;
    private final double factor;
    private final List<Double> passages = new ArrayList<>();

    /**
     * @param factor of the velocity at a passage; 0 ends the solution
     */
    Swing(double level, boolean rising, boolean falling, double factor) {
      this.level = level;
      this.rising = rising;
      this.falling = falling;
      this.factor = factor;
    }

    @Override
    public int dimension() {
      return 2;
    }

    @Override
    public boolean derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = -y[0];
      return true;
    }

    @Override
    public Phases phases() {
      return this;
    }

    @Override
    public int count() {
      return 1;
    }

    @Override
    public boolean values(double t, double[] y, double[] g) {
      g[0] = y[0] - level;
      return true;
    }

    @Override
    public boolean counts(int function, boolean upwards) {
      return upwards ? rising : falling;
    }

    @Override
    public double longestStep() {
      return 0.05;
    }

    @Override
    public double nextBreak(double t) {
      return Double.POSITIVE_INFINITY;
    }

    @Override
    public boolean change(boolean[] passed, double t, double[] y) {
      passages.add(t);
      y[1] *= factor;
      return factor != 0;
    }

    @Override
    public void continueFrom(double t) {}
  }

  @ParameterizedTest
  @MethodSource("codes")
  void passagesOfASineAreFoundToRounding(ReferenceCode code) {
    Swing swing = new Swing(0.5, true, true, 1);
    double[][] states = solve(code, swing, new double[] {0, 3, 20}, 0, 1);
    // sin t = 1/2 seven times up to 20, and nothing is changed there.
    assertThat(swing.passages).hasSize(7);
    for (int i = 0; i < 7; i++) {
      double exact = Math.PI / 6 + (i % 2) * 2 * Math.PI / 3 + (i / 2) * 2 * Math.PI;
      assertThat(swing.passages.get(i)).isCloseTo(exact, offset(2e-12));
    }
    assertThat(states[2][0]).isCloseTo(Math.sin(20), offset(2e-12));
  }

  @ParameterizedTest
  @MethodSource("codes")
  void onlyPassagesInTheDirectionAskedForCount(ReferenceCode code) {
    Swing swing = new Swing(0.5, false, true, 1);
    solve(code, swing, new double[] {0, 20}, 0, 1);
    assertThat(swing.passages).hasSize(3);
    assertThat(swing.passages.get(0)).isCloseTo(5 * Math.PI / 6, offset(1e-12));
  }

  @ParameterizedTest
  @MethodSource("codes")
  void bounceThatLeadsBackIsOnePassageEvenIfBothDirectionsCount(ReferenceCode code) {
    Swing swing = new Swing(0.5, true, true, -1);
    double[][] states = solve(code, swing, new double[] {0, 1, 6}, 0, 1);
    // x rises to 1/2 at pi/6 and is sent back: x = sin(pi/3 − t), which is 1/2 again at 3 pi / 2.
    assertThat(states[1][0]).isCloseTo(Math.sin(Math.PI / 3 - 1), offset(1e-12));
    assertThat(swing.passages).hasSize(2);
    assertThat(swing.passages.get(1)).isCloseTo(1.5 * Math.PI, offset(1e-12));
  }

  @ParameterizedTest
  @MethodSource("codes")
  void startOnTheLevelIsNoPassage(ReferenceCode code) {
    Swing swing = new Swing(0, true, true, 1);
    solve(code, swing, new double[] {0, 4}, 0, 1);
    assertThat(swing.passages)
        .singleElement()
        .satisfies(t -> assertThat(t).isCloseTo(Math.PI, offset(1e-12)));
  }

  @ParameterizedTest
  @MethodSource("codes")
  void solutionThatEndsHasTheStatesBefore(ReferenceCode code) {
    Swing swing = new Swing(0.5, false, true, 0);
    double[][] states = solve(code, swing, new double[] {0, 1, 2, 3, 4}, 0, 1);
    // The end is at 5 pi / 6 = 2.618.
    assertThat(states).hasDimensions(3, 2);
    assertThat(states[2][0]).isCloseTo(Math.sin(2), offset(1e-12));
  }

  @ParameterizedTest
  @MethodSource("codes")
  void equationsThatJumpAtAKnownPlaceAreSolvedOnBothSidesOfIt(ReferenceCode code) {
    double place = 1.0 / 3;
    class Stairs implements Problem {
      private boolean behind;

      @Override
      public int dimension() {
        return 1;
      }

      @Override
      public boolean derivative(double t, double[] y, double[] yDot) {
        yDot[0] = behind ? y[0] : 1;
        return true;
      }

      @Override
      public Phases phases() {
        return new KnownPlace(place, () -> behind = true);
      }
    }
    double[][] states = solve(code, new Stairs(), new double[] {0, 0.25, 1}, 0);
    assertThat(states[2][0]).isCloseTo(place * Math.exp(1 - place), offset(1e-14));
  }

  /** A place at which something is switched. */
  private record KnownPlace(double place, Runnable onBehind) implements Phases {
    @Override
    public int count() {
      return 0;
    }

    @Override
    public boolean values(double t, double[] y, double[] g) {
      return true;
    }

    @Override
    public boolean counts(int function, boolean rising) {
      return false;
    }

    @Override
    public double longestStep() {
      return Double.POSITIVE_INFINITY;
    }

    @Override
    public double nextBreak(double t) {
      return t < place ? place : Double.POSITIVE_INFINITY;
    }

    @Override
    public boolean change(boolean[] passed, double t, double[] y) {
      return true;
    }

    @Override
    public void continueFrom(double t) {
      onBehind.run();
    }
  }
}
