package org.mechservice.solver.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Forces that have no value end in a message that names them; those that only seem so do not. */
class ForceRefusalTest {
  private static final JointCoordinate SLIDE = new JointCoordinate(0, 0);

  private static Mechanism slider(double rootAt, ForceElement force) {
    return body(
        new Prismatic("slide", attachment(), new Vector3(1, 0, 0), 0, 0, Origin.NONE),
        rootAt,
        force);
  }

  private static Mechanism body(Joint joint, double rootAt, ForceElement force) {
    return new Mechanism(
        "one body",
        new Root("ground", new Vector3(rootAt, rootAt, 0), Rotation.IDENTITY),
        Vector3.ZERO,
        List.of(
            new Body("block", 1, Vector3.ZERO, new InertiaTensor(1, 1, 1, 0, 0, 0), Origin.NONE)),
        List.of(joint),
        List.of(),
        List.of(StartRole.FREE),
        List.of(),
        List.of(force),
        List.of(new Parameter("p", 1, "N/m")));
  }

  private static Attachment attachment() {
    return new Attachment(-1, Vector3.ZERO, 0, Vector3.ZERO, Rotation.IDENTITY);
  }

  private static SpringDamper spring(Expression k, double c, double length0, double force0) {
    return new SpringDamper(
        "strut",
        new BodyPoint(BodyPoint.ROOT, Vector3.ZERO),
        new BodyPoint(0, Vector3.ZERO),
        k,
        Expression.of(c),
        Expression.of(length0),
        Expression.of(force0),
        Side.BOTH,
        Expression.ZERO,
        Origin.NONE);
  }

  private static ForceSet at(Mechanism mechanism, double q, double v, double[] wrench) {
    TreeMotion motion = new TreeMotion(new TreeGeometry(mechanism));
    ForceSet forces = new ForceSet(motion);
    motion.sweep(0, new double[] {q}, new double[] {v});
    forces.apply(0, wrench, new double[1]);
    return forces;
  }

  @Test
  void tensionWithoutDirectionIsRefused() {
    ForceSet forces = at(slider(0, spring(Expression.of(100), 0, 0.5, 0)), 0, 1, new double[6]);
    assertThat(forces.defect().code()).isEqualTo(MessageCode.FORCE_WITHOUT_DIRECTION);
    assertThat(forces.defect().part()).isEqualTo("force strut");
    assertThat(forces.defect().cause()).contains("-50.0 N");
  }

  /** The damper's force is the same on both sides of zero length, so it is that in between. */
  @Test
  void springOfNoRestLengthPassesThroughZero() {
    double[] before = new double[6];
    double[] between = new double[6];
    double[] after = new double[6];
    Mechanism slider = slider(0, spring(Expression.of(100), 7, 0, 0));
    at(slider, -1e-12, 2, before);
    at(slider, 0, 2, between);
    at(slider, 1e-12, 2, after);
    assertThat(between[3]).isEqualTo(-14);
    assertThat(before[3]).isCloseTo(-14, within(1e-9));
    assertThat(after[3]).isCloseTo(-14, within(1e-9));
  }

  /** A million metres from the world's origin the spring's length keeps its last digit. */
  @Test
  void distanceFromTheWorldsOriginCostsNoDigits() {
    double[] near = new double[6];
    double[] far = new double[6];
    SpringDamper spring = spring(Expression.of(1e9), 0, 0.5, 0);
    at(slider(0, spring), 0.500000001, 0, near);
    at(slider(1e6, spring), 0.500000001, 0, far);
    assertThat(far).containsExactly(near);
  }

  @Test
  void halfATurnOfABushingIsRefused() {
    BodyFrame onRoot = new BodyFrame(-1, Vector3.ZERO, Rotation.IDENTITY);
    BodyFrame onBody = new BodyFrame(0, Vector3.ZERO, Rotation.IDENTITY);
    List<Expression> matrix = Collections.nCopies(36, Expression.of(1));
    Bushing bushing =
        new Bushing(
            "mount",
            onRoot,
            onBody,
            matrix,
            matrix,
            matrix.subList(0, 6),
            Bushing.Law.ENERGY,
            Origin.NONE);
    Joint hinge = new Revolute("turn", attachment(), new Vector3(0, 0, 1), 0, 0, Origin.NONE);
    ForceSet forces = at(body(hinge, 0, bushing), Math.PI, 0, new double[6]);
    assertThat(forces.defect().code()).isEqualTo(MessageCode.FORCE_WITHOUT_DIRECTION);
    assertThat(forces.defect().part()).isEqualTo("force mount");
  }

  @CsvSource({"0, Infinity", "-1, NaN"})
  @ParameterizedTest
  void forceThatIsNotFiniteIsNamed(double q, String value) {
    Expression x = new CoordinatePosition(SLIDE);
    Expression root = new Expression.Power(x, Expression.of(-0.5));
    JointForce force = new JointForce("push", SLIDE, root, Origin.NONE);
    ForceSet forces = at(slider(0, force), q, 0, new double[6]);
    assertThat(forces.defect().code()).isEqualTo(MessageCode.FORCE_NOT_FINITE);
    assertThat(forces.defect().part()).isEqualTo("force push");
    assertThat(forces.defect().cause()).contains(value);
  }

  @Test
  void parametersHoldUntilTheNextOnes() {
    SpringDamper spring = spring(new ParameterValue(0), 0, 1, 0);
    TreeMotion motion = new TreeMotion(new TreeGeometry(slider(0, spring)));
    ForceSet forces = new ForceSet(motion);
    motion.sweep(0, new double[] {3}, new double[] {0});
    double[] wrench = new double[6];
    forces.apply(0, wrench, new double[1]);
    assertThat(wrench[3]).isEqualTo(-2);
    assertThat(forces.parameters(new double[] {10})).isTrue();
    forces.apply(0, wrench, new double[1]);
    assertThat(wrench[3]).isEqualTo(-22);
  }

  @Test
  void parameterThatGivesNoCoefficientIsRefusedByName() {
    Expression k = new Quotient(Expression.of(1), new ParameterValue(0));
    ForceSet forces = new ForceSet(new TreeMotion(new TreeGeometry(slider(0, spring(k, 0, 1, 0)))));
    assertThat(forces.parameters(new double[] {0})).isFalse();
    assertThat(forces.defect().code()).isEqualTo(MessageCode.FORCE_COEFFICIENT);
    assertThat(forces.defect().cause()).contains("stiffness").contains("Infinity");
  }

  @Test
  void coefficientThatWouldChangeIsWrongUse() {
    SpringDamper spring = spring(new Time(), 0, 1, 0);
    TreeMotion motion = new TreeMotion(new TreeGeometry(slider(0, spring)));
    assertThatThrownBy(() -> new ForceSet(motion))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("coefficients of force strut");
  }

  private static UserForceElement user() {
    return new UserForceElement("mine", "Mine", List.of(), Origin.NONE);
  }

  @Test
  void userForceWithoutALoaderIsWrongUse() {
    TreeMotion motion = new TreeMotion(new TreeGeometry(slider(0, user())));
    assertThatThrownBy(() -> new ForceSet(motion))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("force mine is the class Mine");
  }

  @Test
  void userForceThatAsksForWhatIsNotThereIsTold() {
    TreeMotion motion = new TreeMotion(new TreeGeometry(slider(0, user())));
    UserForce asking =
        new UserForce() {
          @Override
          public void declare(ForceDeclaration model) {
            model.coordinate("hinge", 0);
          }

          @Override
          public void apply(ForceState state, ForceLoads loads) {}
        };
    assertThatThrownBy(() -> new ForceSet(motion, element -> asking))
        .hasMessage(
            "S-068 force \"mine\" (Mine) asks for the joint of the tree \"hinge\", which the model"
                + " does not have");
  }

  @Test
  void userForceThatThrowsEndsTheRunByName() {
    TreeMotion motion = new TreeMotion(new TreeGeometry(slider(0, user())));
    UserForce throwing =
        new UserForce() {
          @Override
          public void declare(ForceDeclaration model) {}

          @Override
          public void apply(ForceState state, ForceLoads loads) {
            throw new ArithmeticException("no tyre");
          }
        };
    ForceSet forces = new ForceSet(motion, element -> throwing);
    motion.sweep(0, new double[1], new double[1]);
    assertThat(forces.apply(0, new double[6], new double[1])).isZero();
    assertThat(forces.defect().code()).isEqualTo(MessageCode.USER_FORCE_FAILED);
    assertThat(forces.defect().cause()).contains("no tyre");
  }

  @Test
  void userForceReadsOnlyWhatItDeclared() {
    TreeMotion motion = new TreeMotion(new TreeGeometry(slider(0, user())));
    UserForce reading =
        new UserForce() {
          private int point;

          @Override
          public void declare(ForceDeclaration model) {
            point = model.pointAt("block", 0, 0, 0, ForceDeclaration.Reads.POSITION);
          }

          @Override
          public void apply(ForceState state, ForceLoads loads) {
            state.velocity(point, new double[3]);
          }
        };
    ForceSet forces = new ForceSet(motion, element -> reading);
    motion.sweep(0, new double[1], new double[1]);
    assertThat(forces.apply(0, new double[6], new double[1])).isZero();
    assertThat(forces.defect().cause()).contains("VELOCITY");
  }
}
