package org.mechservice.study;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.mechservice.library.MechModel;

/** Points of a mass on a spring, m x'' = -k x from x = 0.1 at rest: x = 0.1 cos(sqrt(k/m) t). */
class PointModelTest {
  private static PointModel open(List<String> factors, String... reductions) throws Exception {
    return PointModel.of(
        MechModel.of("spring.xml", StudyModels.SPRING),
        factors,
        Stream.of(reductions).map(Reduction::parse).toList());
  }

  private static double[] values(PointOutcome outcome) {
    assertThat(outcome).isInstanceOf(PointOutcome.Values.class);
    return ((PointOutcome.Values) outcome).values();
  }

  @Test
  void forceParameterIsAnInputAndMassIsSettledAndBothGiveTheClosedMotion() throws Exception {
    PointModel model = open(List.of("k", "m"), "last(x.q)", "crossing(x.q,0)", "max(x.a)");

    assertThat(model.tunable()).containsExactly("k");
    assertThat(model.units()).containsExactly("m", "s", "m/s^2");
    for (double k : new double[] {20, 50}) {
      for (double m : new double[] {1, 3}) {
        double w = Math.sqrt(k / m);
        double[] values = values(model.run(Map.of("k", k, "m", m)));
        assertThat(values[0]).isCloseTo(0.1 * Math.cos(w), within(1e-8));
        assertThat(values[1]).isCloseTo(Math.PI / 2 / w, within(1e-5)); // straight between rows
      }
    }
  }

  @Test
  void seriesIsOneValueForEachTime() throws Exception {
    PointModel model = open(List.of("k"), "series(x.q,0.25)");

    assertThat(model.names()).containsExactly("x.q@0", "x.q@0.25", "x.q@0.5", "x.q@0.75", "x.q@1");
    assertThat(values(model.run(Map.of("k", 32.0)))[2]).isCloseTo(0.1 * Math.cos(2), within(1e-8));
  }

  @Test
  void pointThatCannotRunSaysWhy() throws Exception {
    PointOutcome outcome = open(List.of("m"), "last(x.q)").run(Map.of("m", -1.0));

    assertThat(outcome).isInstanceOf(PointOutcome.Failed.class);
    assertThat(((PointOutcome.Failed) outcome).code()).startsWith("M-");
  }

  @Test
  void valuesDoNotDependOnThreadsOrOrder() throws Exception {
    PointModel model = open(List.of("k", "m"), "rms(x.v)");
    List<Double> forward =
        IntStream.range(0, 24).parallel().mapToObj(i -> value(model, i)).toList();
    List<Double> backward = IntStream.range(0, 24).mapToObj(i -> value(model, 23 - i)).toList();

    for (int i = 0; i < 24; i++) {
      assertThat(forward.get(i)).isEqualTo(backward.get(23 - i));
    }
  }

  private static double value(PointModel model, int i) {
    try {
      return values(model.run(Map.of("k", 10.0 + i, "m", 1.0 + i % 3)))[0];
    } catch (java.io.IOException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Classes that are used again for other numbers change no bit: of open chains and of loops. */
  @Test
  void settledValuesInClassesThatAreLoadedHaveTheBitsOfModelsOfTheirOwn() throws Exception {
    MechModel suspension = MechModel.read(Path.of("../examples/optimise/suspension.xml"));
    requireOwnBits(suspension, "rack", -0.1, "rms(toe)");
    requireOwnBits(MechModel.of("spring.xml", StudyModels.SPRING), "m", 1.7, "rms(x.a)");
  }

  private static void requireOwnBits(MechModel read, String factor, double first, String output)
      throws Exception {
    List<Reduction> kept = List.of(Reduction.parse(output));
    PointModel model = PointModel.of(read, List.of(factor), kept);
    assertThat(model.tunable()).isEmpty();
    for (int i = 0; i < 3; i++) {
      double value = first * (1 + 0.01 * i);
      PointModel own = PointModel.of(read.set(factor, value), List.of(), kept);
      double again = values(model.run(Map.of(factor, value)))[0];
      assertThat(again).isEqualTo(values(own.run(Map.of()))[0]);
    }
  }

  @Test
  void unknownNamesAreRefusedWithNearOnes() {
    assertThatThrownBy(() -> open(List.of("kk"), "last(x.q)")).hasMessageContaining("\"k\"?");
    assertThatThrownBy(() -> open(List.of("k"), "last(x.p)")).hasMessageContaining("\"x.q\"?");
    assertThatThrownBy(() -> open(List.of("k"), "at(x.q,2)")).hasMessageContaining("outside");
  }
}
