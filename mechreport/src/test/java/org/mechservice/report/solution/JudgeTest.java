package org.mechservice.report.solution;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.mechservice.report.PlanarPendulum;
import org.mechservice.report.method.ModelProblem;

class JudgeTest {
  private static final StateDistance DISTANCE =
      new StateDistance(new PlanarPendulum(0).description());
  private static final double[] TIMES = {0, 1, 2};

  private static ReferenceMaker.Source pendulum() {
    return new ReferenceMaker.Source("DTR", () -> new ModelProblem(new PlanarPendulum(0)));
  }

  private static Judge judge(double[][] published) {
    return Judge.of(
        Optional.of(new PublishedReference("By hand", TIMES, published, new double[3])),
        List.of(pendulum()),
        new ReferenceMaker(DISTANCE, 20),
        DISTANCE,
        RunGrid.uniform(0, 2, 2));
  }

  private static double[][] made() {
    return new ReferenceMaker(DISTANCE, 20).make(List.of(pendulum()), TIMES).orElseThrow().states();
  }

  @Test
  void referenceThatTwoCodesContradictIsNamedAndNotUsed() {
    double[][] wrong = {made()[0], {0.5, 0.1}, {0.2, 0.3}};

    Judge judge = judge(wrong);

    assertThat(judge.doubt()).contains("differs by", "Errors are those against the two codes");
    assertThat(judge.reference().orElseThrow().states()[2]).isNotEqualTo(wrong[2]);
  }

  @Test
  void referenceThatTwoCodesConfirmIsTheJudge() {
    double[][] right = made();

    Judge judge = judge(right);

    assertThat(judge.doubtful()).isFalse();
    assertThat(judge.reference().orElseThrow().states()[2]).isEqualTo(right[2]);
  }

  @Test
  void intervalEndsWhereTheSceneHasGrownRoundingBeyondUsefulErrors() {
    // Known to 1e-12 throughout; but a unit in the last place has grown to 1e-6 at the last time.
    double[] known = {1e-12, 1e-12, 1e-12, 1e-12};
    double[] grown = {1, 10, 100, 1e10};
    double[] state = {1, 0};
    Reference reference =
        new Reference(
            new double[] {0, 1, 2, 3},
            new double[][] {state, state, state, state},
            known,
            known,
            Optional.of(grown),
            List.of());

    Judge judge = Judge.cut(reference, RunGrid.uniform(0, 3, 3));

    assertThat(judge.reference().orElseThrow().end()).isEqualTo(2);
    assertThat(judge.said())
        .anySatisfy(said -> assertThat(said).contains("cut at 2.000 s", "grows 1.0e+10"));
  }
}
