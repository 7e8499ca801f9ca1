package org.mechservice.solver.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.NamedPoint;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.scenes.SharedScene;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** The suspension's two user forces against the same forces as elements and expressions. */
class FpsForcesTest {
  private static UserForce create(UserForceElement element) {
    return element.className().equals("FpsFBody") ? new FpsFBody() : new FpsSpringDamper();
  }

  private static Mechanism withUserForces(Mechanism fps) {
    List<NamedPoint> points =
        List.of(new NamedPoint("Wheel", "p1", new BodyPoint(2, Vector3.ZERO)));
    List<ForceElement> forces =
        List.of(
            new UserForceElement("fBody", "FpsFBody", points, Origin.NONE),
            new UserForceElement("strut", "FpsSpringDamper", points, Origin.NONE));
    return new Mechanism(
        fps.name(),
        fps.root(),
        fps.gravity(),
        fps.bodies(),
        fps.joints(),
        fps.motions(),
        fps.startRoles(),
        fps.closures(),
        forces,
        fps.parameters());
  }

  /** Returns what a mechanism's forces do in its joints, somewhere along the road. */
  private static double[] jointForces(Mechanism mechanism, long seed) {
    TreeMotion motion = new TreeMotion(new TreeGeometry(mechanism));
    ForceSet forces = new ForceSet(motion, FpsForcesTest::create);
    Random random = new Random(seed);
    double[] y = new double[mechanism.positionCount() + mechanism.velocityCount()];
    mechanism.initialState(y);
    for (int i = 0; i < y.length; i++) {
      y[i] += 0.01 * random.nextGaussian();
    }
    y[0] += 25 * random.nextDouble();
    motion.sweep(y[0] / 30, y);
    double[] wrench = new double[6 * motion.tree().linkCount];
    double[] tau = new double[motion.tree().velocityCount];
    assertThat(forces.apply(y[0] / 30, wrench, tau)).isEqualTo(ForceSet.REGULAR);
    inJoints(motion, wrench, tau);
    return tau;
  }

  private static void inJoints(TreeMotion motion, double[] wrench, double[] tau) {
    for (int link = 0; link < motion.tree().linkCount; link++) {
      double[] w = Arrays.copyOfRange(wrench, 6 * link, 6 * link + 6);
      motion.wrenches.addRow(link, w, 0, 1, tau);
    }
  }

  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
  @ParameterizedTest
  void userForcesDoWhatElementsDo(long seed) {
    Mechanism fps = SharedScene.named("fps").mechanism();
    double[] byElements = jointForces(fps, seed);
    double[] byClasses = jointForces(withUserForces(fps), seed);
    for (int i = 0; i < byElements.length; i++) {
      // forces of up to 1e5 N, rounded in a different order
      assertThat(byClasses[i]).isCloseTo(byElements[i], within(1e-9));
    }
  }
}
