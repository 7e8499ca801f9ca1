package org.mechservice.sim.equations.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.DirectedForces;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.simulation.Simulation;
import org.mechservice.solver.simulation.equations.ExplicitForm;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** A slider on the x axis, and a spring from the ground's origin to its own. */
class DirectedForcesTest {
  private static final BuildOptions OPTIONS = new BuildOptions("auto", Set.of(), Scenes.SETTINGS);

  private static Mechanism slider(double length0, double damping) {
    SpringDamper spring =
        new SpringDamper(
            "coil",
            new BodyPoint(Mechanism.ROOT, Vector3.ZERO),
            new BodyPoint(0, Vector3.ZERO),
            new Expression.Constant(100),
            new Expression.Constant(damping),
            new Expression.Constant(length0),
            new Expression.Constant(0),
            Side.BOTH,
            new Expression.Constant(0),
            Origin.NONE);
    Attachment attachment =
        new Attachment(Mechanism.ROOT, Vector3.ZERO, 0, Vector3.ZERO, Rotation.IDENTITY);
    Body body =
        new Body("block", 2, Vector3.ZERO, new InertiaTensor(1, 1, 1, 0, 0, 0), Origin.NONE);
    return new Mechanism(
        "slider",
        new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
        Vector3.ZERO,
        List.of(body),
        List.of(Scenes.joint("rail", "P", attachment, new Vector3(1, 0, 0), 0, 3)),
        List.of(),
        List.of(StartRole.PREFERRED),
        List.of(),
        List.of(spring),
        List.of());
  }

  /** A hinge with a bushing about it, turned by an angle at the start. */
  private static Mechanism hinge(double angle) {
    List<Expression> none = Collections.nCopies(36, Expression.of(0));
    List<Expression> stiffness = new ArrayList<>(none);
    for (int i = 0; i < 6; i++) {
      stiffness.set(7 * i, Expression.of(40));
    }
    Bushing bushing =
        new Bushing(
            "sleeve",
            new BodyFrame(Mechanism.ROOT, Vector3.ZERO, Rotation.IDENTITY),
            new BodyFrame(0, Vector3.ZERO, Rotation.IDENTITY),
            stiffness,
            none,
            none.subList(0, 6),
            Bushing.Law.ENERGY,
            Origin.NONE);
    Attachment attachment =
        new Attachment(Mechanism.ROOT, Vector3.ZERO, 0, Vector3.ZERO, Rotation.IDENTITY);
    Body body =
        new Body("block", 2, Vector3.ZERO, new InertiaTensor(1, 1, 1, 0, 0, 0), Origin.NONE);
    return new Mechanism(
        "hinge",
        new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
        Vector3.ZERO,
        List.of(body),
        List.of(Scenes.joint("pin", "R", attachment, new Vector3(0, 0, 1), angle, 9)),
        List.of(),
        List.of(StartRole.PREFERRED),
        List.of(),
        List.of(bushing),
        List.of());
  }

  /** Takes no notice. */
  private static final class NoRows implements ResultSink {
    @Override
    public void begin(List<Variable> columns) {}

    @Override
    public void row(double[] values) {}
  }

  private static Model generated(Mechanism mechanism) {
    MechmlModel file = Scenes.model(mechanism);
    return ModelFactory.compile(file, OPTIONS, ModelFactory.generate(file, OPTIONS)).newInstance();
  }

  @Test
  void aSlackSpringPassesThroughZeroLengthAsItsDamperSays() {
    Mechanism slider = slider(0, 5);
    Model model = generated(slider);
    assertThat(model).isNotInstanceOf(DirectedForces.class);
    double[] actual = new double[2];
    double[] expected = new double[2];
    for (double q : new double[] {0, 1e-3, -0.2}) {
      double[] y = {q, 3};
      assertThat(((ExplicitModel) ModelParts.of(model).equations()).derivative(0, y, actual))
          .isEqualTo(ExplicitModel.REGULAR);
      new DataDrivenModel(slider, Scenes.SETTINGS).derivative(0, y, expected);
      assertThat(actual).containsExactly(expected, within(1e-12));
    }
  }

  @Test
  void aSpringUnderTensionWithoutLengthIsNamed() throws Exception {
    Model model = generated(slider(0.5, 0));
    Outcome outcome =
        new Simulation(De::new, new ExplicitForm())
            .run(model, new RunRequest(Scenes.SETTINGS, Set.of()), new NoRows(), new RunControl())
            .outcome();
    assertThat(outcome).isInstanceOf(Outcome.Failed.class);
    assertThat(((Outcome.Failed) outcome).failure().message())
        .startsWith("N-031")
        .contains("force coil");
  }

  @Test
  void aBushingTurnedByHalfATurnIsNamed() throws Exception {
    Model model = generated(hinge(Math.PI));
    Outcome outcome =
        new Simulation(De::new, new ExplicitForm())
            .run(model, new RunRequest(Scenes.SETTINGS, Set.of()), new NoRows(), new RunControl())
            .outcome();
    assertThat(outcome).isInstanceOf(Outcome.Failed.class);
    assertThat(((Outcome.Failed) outcome).failure().message())
        .startsWith("N-031")
        .contains("force sleeve");
  }

  @Test
  void aBushingIsRefusedWhereTheDataDrivenOneIsAndNowhereElse() {
    Mechanism hinge = hinge(0);
    ExplicitModel model = (ExplicitModel) ModelParts.of(generated(hinge)).equations();
    DataDrivenModel reference = new DataDrivenModel(hinge, Scenes.SETTINGS);
    for (double angle : new double[] {0, 3.13, Math.PI, Math.PI + 1e-4, 3.2}) {
      double[] y = {angle, 1};
      double[] actual = new double[2];
      double[] expected = new double[2];
      boolean regular = reference.derivative(0, y, expected) == ExplicitModel.REGULAR;
      assertThat(model.derivative(0, y, actual) == ExplicitModel.REGULAR).isEqualTo(regular);
      if (regular) {
        assertThat(actual).containsExactly(expected, within(1e-9));
      }
    }
  }

  @Test
  void theClassFileHasTheBitsOfTheCompiledSource() {
    MechmlModel file = Scenes.model(slider(0.5, 1));
    GeneratedModel generated = ModelFactory.generate(file, OPTIONS);
    for (double q : new double[] {0, 0.1}) {
      double[] y = {q, 3};
      double[] direct = new double[2];
      double[] compiled = new double[2];
      Model one = ModelFactory.compile(file, OPTIONS, generated).newInstance();
      Model other = ModelFactory.compileSource(file, OPTIONS, generated).newInstance();
      assertThat(((ExplicitModel) ModelParts.of(one).equations()).derivative(0, y, direct))
          .isEqualTo(((ExplicitModel) ModelParts.of(other).equations()).derivative(0, y, compiled));
      assertThat(direct).containsExactly(compiled);
      assertThat(((DirectedForces) one).directedForce(0))
          .isEqualTo(((DirectedForces) other).directedForce(0));
    }
  }
}
