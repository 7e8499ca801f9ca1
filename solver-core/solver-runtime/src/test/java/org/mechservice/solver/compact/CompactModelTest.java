package org.mechservice.solver.compact;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.RandomTrees;

class CompactModelTest {
  private static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "DE", 1e-5, 1e-5);

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void modelFromItsTextsComputesTheSameBits(long seed) {
    Mechanism mechanism = RandomTrees.ofAllJoints(seed, 12);
    CompactModel written = new CompactModel(mechanism, "DTR", "none", SETTINGS);
    String[] texts = written.texts().toArray(new String[0]);
    CompactSource source =
        new CompactSource() {
          @Override
          protected String[] texts() {
            return texts;
          }

          @Override
          protected Object bare(CompactModel data, UserForceSource userForces) {
            return DataDrivenTree.model(data, userForces);
          }
        };

    ExplicitModel read = (ExplicitModel) source.model();

    ExplicitModel original = new DataDrivenModel(mechanism, SETTINGS);
    assertThat(read.description()).isEqualTo(original.description());
    assertThat(derivative(read)).containsExactly(derivative(original));
  }

  private static double[] derivative(ExplicitModel model) {
    double[] y = new double[model.description().stateCount()];
    double[] yDot = new double[y.length];
    model.initialState(y);
    assertThat(model.derivative(0, y, yDot)).isEqualTo(ExplicitModel.REGULAR);
    return yDot;
  }

  @Test
  void textsThatAreCutShortAreRefusedByName() {
    String text = new CompactModel(RandomTrees.tree(1, 3), "DTR", "none", SETTINGS).texts().get(0);

    for (int length = 0; length < text.length(); length += 7) {
      String cut = text.substring(0, length);
      assertThatIllegalArgumentException()
          .isThrownBy(() -> CompactModel.of(List.of(cut)))
          .withMessageStartingWith("S-067");
    }
  }
}
