package org.mechservice.report.method;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.capability.ModelParts;

class MethodListTest {
  @Test
  void modelWithLoopsHasThemWhateverHappensAlongItsRuns() {
    Model open = (Model) model(Model.class, ExplicitModel.class);
    Model closed = (Model) model(Model.class, ExplicitModel.class, DependentStates.class);
    ModelEvents events = (ModelEvents) model(ModelEvents.class);

    assertThat(MethodList.hasLoops(closed)).isTrue();
    assertThat(MethodList.hasLoops(ModelParts.of(closed).with(events))).isTrue();
    assertThat(MethodList.hasLoops(ModelParts.of(open).with(events))).isFalse();
  }

  private static Object model(Class<?>... capabilities) {
    return Proxy.newProxyInstance(
        MethodListTest.class.getClassLoader(), capabilities, (self, method, given) -> List.of());
  }
}
