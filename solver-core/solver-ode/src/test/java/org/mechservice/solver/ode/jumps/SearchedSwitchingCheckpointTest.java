package org.mechservice.solver.ode.jumps;

import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.junit.jupiter.api.Test;
import org.mechservice.solver.ode.CheckpointContract;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.suite.FunctionOde;
import org.mechservice.solver.ode.switching.Switching;

class SearchedSwitchingCheckpointTest extends CheckpointContract {
  private static final FunctionOde GROWTH = new FunctionOde(1, (t, y, yDot) -> yDot[0] = y[0]);

  @Override
  protected Integrator create(IntegratorSettings settings) {
    return UndeclaredJumps.around(new Switching(settings));
  }

  private static byte[] saved(Integrator integrator) {
    integrator.start(GROWTH, 0, new double[] {1}, 1);
    integrator.step();
    return integrator.save();
  }

  /** What the search has seen is part of the state: without it the steps would be others. */
  @Test
  void stateSavedWithTheSearchIsTakenUpWithItOnly() {
    IntegratorSettings settings = new IntegratorSettings(1e-6, 1e-6);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> new Switching(settings).resume(GROWTH, saved(create(settings))))
        .withMessageContaining("watch of the steps is none")
        .withMessageContaining("search for undeclared jumps");
    assertThatIllegalArgumentException()
        .isThrownBy(() -> create(settings).resume(GROWTH, saved(new Switching(settings))))
        .withMessageContaining("that of the saved state is none");
  }
}
