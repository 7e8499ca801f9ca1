package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.equations.RecursiveResidualEquations;
import org.mechservice.sim.scene.ForceReach;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.RecursiveResidualModel;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Chains whose links are all held by springs to bodies far away in the tree. */
class FarForcesTest {
  private static final Expression ONE = Expression.of(1);
  private static final BuildOptions RESIDUAL =
      new BuildOptions("RR", EnumSet.noneOf(ColumnGroup.class), settings());

  private static RunSettings settings() {
    return new RunSettings(0, 3, 0.01, "ode15sR", 1e-5, 1e-5);
  }

  /** A chain with a spring from each link i to link {@code to(i)}, -1 for the root. */
  private static Mechanism chain(int links, IntUnaryOperator to) {
    Mechanism chain = Chains.ofDifferentLinks(links);
    List<ForceElement> springs =
        IntStream.range(2, links).mapToObj(i -> spring(i, to.applyAsInt(i))).toList();
    return new Mechanism(
        "held",
        chain.root(),
        chain.gravity(),
        chain.bodies(),
        chain.joints(),
        List.of(),
        IntStream.range(0, links).mapToObj(i -> StartRole.PREFERRED).toList(),
        List.of(),
        springs,
        List.of());
  }

  private static ForceElement spring(int link, int other) {
    BodyPoint first = new BodyPoint(other, new Vector3(0.1 * link, 0.2, -0.3));
    BodyPoint second = new BodyPoint(link, new Vector3(0.05, 0.01, 0.02));
    Expression none = Expression.ZERO;
    return new SpringDamper(
        "s" + link, first, second, ONE, ONE, ONE, none, Side.BOTH, none, Origin.NONE);
  }

  @Test
  void placesThatManyForcesShareGiveTheForcesOfTheData() {
    Mechanism held = chain(70, i -> Mechanism.ROOT);
    assertThat(ForceReach.of(held)).isEqualTo(new ForceReach(2482, 70, 70));
    assertThat(ForceReach.of(held).areShared()).isTrue();
    MechmlModel file = Scenes.model(held);
    GeneratedModel generated = ModelFactory.generate(file, RESIDUAL);
    assertThat(generated.formulationReason()).doesNotContain("compact form");
    ResidualModel code =
        (ResidualModel)
            ModelParts.of(ModelFactory.compile(file, RESIDUAL, generated).newInstance())
                .equations();
    double[] y = RandomMechmlTrees.state(4, held);
    double[] yDot = new Random(7).doubles(y.length, -2, 2).toArray();
    double[] actual = new double[y.length];
    double[] expected = new double[y.length];
    code.residual(0.4, y, yDot, actual);
    new RecursiveResidualModel(held, settings(), UserForceSource.NONE)
        .residual(0.4, y, yDot, expected);
    double scale = Arrays.stream(expected).map(Math::abs).max().orElse(0);
    for (int i = 0; i < y.length; i++) {
      // Nothing is solved for: rounding times depth.
      assertThat(Math.abs(actual[i] - expected[i])).isLessThanOrEqualTo(1e-12 * scale);
    }
  }

  @Test
  void operationsOfForcesToTheRootGrowWithTheirNumber() {
    int some = operations(chain(64, i -> Mechanism.ROOT));
    int twice = operations(chain(128, i -> Mechanism.ROOT));
    assertThat(twice).isBetween((int) (1.9 * some), (int) (2.1 * some));
  }

  private static int operations(Mechanism held) {
    return RecursiveResidualEquations.derive(Links.of(held)).operationCount();
  }

  @Test
  void forcesToEverOtherBodiesFarAwayAreLeftToTheData() {
    Mechanism held = chain(200, i -> i / 2);
    assertThat(ForceReach.of(held).areTooMany()).isTrue();
    assertThat(ModelFactory.generate(Scenes.model(held), RESIDUAL).formulationReason())
        .contains("no code is generated yet for forces between bodies far apart in the tree");
  }
}
