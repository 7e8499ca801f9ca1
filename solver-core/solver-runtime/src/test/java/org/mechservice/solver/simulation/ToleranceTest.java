package org.mechservice.solver.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.simulation.equations.ExplicitForm;
import org.mechservice.solver.simulation.equations.ModelEquations;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** A wheel on a slide: one state of each kind. */
class ToleranceTest {
  private static final RunSettings SETTINGS =
      new RunSettings(0, 1, 0.1, "DE", 1e-6, 1).withTolerances(List.of(1e-3, 1e-4, 1e-5, 1e-6));

  private static ModelEquations equations() {
    Vector3 x = new Vector3(1, 0, 0);
    InertiaTensor one = new InertiaTensor(1, 1, 1, 0, 0, 0);
    Mechanism mechanism =
        new Mechanism(
            "wheel",
            new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
            Vector3.ZERO,
            List.of(
                new Body("slide", 1, Vector3.ZERO, one, Origin.NONE),
                new Body("wheel", 1, Vector3.ZERO, one, Origin.NONE)),
            List.of(
                new Prismatic("s", at(-1, 0), x, 0, 0, Origin.NONE),
                new Revolute("w", at(0, 1), x, 0, 0, Origin.NONE)));
    return new ExplicitForm().of(new DataDrivenModel(mechanism, SETTINGS));
  }

  private static Attachment at(int parent, int child) {
    return new Attachment(parent, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
  }

  @Test
  void statesHaveTheTolerancesOfTheirKind() {
    assertThat(equations().absoluteTolerances(SETTINGS)).containsExactly(1e-3, 1e-4, 1e-5, 1e-6);
  }

  @Test
  void angleCountsAsOneTurnAtMost() {
    ModelEquations equations = equations();
    assertThat(equations.largestSize(1)).isEqualTo(2 * Math.PI);
    assertThat(equations.largestSize(0)).isInfinite();
    assertThat(equations.largestSize(2)).isInfinite();
    assertThat(equations.largestSize(3)).isInfinite();
  }
}
