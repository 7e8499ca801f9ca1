package org.mechservice.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.simulation.RuntimeSolver;

class CandidateTest {
  private static Candidate candidate(Model model) {
    return new Candidate(
        new SimulationMethod("DTR", MethodNames.NONE, "DE"), () -> model, new RuntimeSolver());
  }

  /** Events of these kinds; in a run begun, the equations jump at 1 s. */
  private static ModelEvents events(List<ModelEvents.Kind> kinds) {
    return (ModelEvents)
        Proxy.newProxyInstance(
            ModelEvents.class.getClassLoader(),
            new Class<?>[] {ModelEvents.class},
            (self, method, arguments) -> method.getName().equals("kinds") ? kinds : List.of(1.0));
  }

  @Test
  void equationsAreThoseOfTheModelThatIsWatched() {
    PlanarPendulum model = new PlanarPendulum(0);
    assertThat(candidate(model).equations()).isSameAs(model);
    assertThat(candidate(ModelParts.of(model).with(events(List.of()))).equations()).isSameAs(model);
  }
}
