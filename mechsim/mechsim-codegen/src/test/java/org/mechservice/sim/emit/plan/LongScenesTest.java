package org.mechservice.sim.emit.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mechservice.sim.model.ModelAgreement.assertClose;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.emit.bytes.MethodSizes;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.Chains;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** Code of scenes so long that what calls all methods would be too long itself. */
class LongScenesTest {
  private static final double TIME = 0.4;
  private static final int STAR = 500;

  /** Code in the form asked for: by itself a large tree is left to its data. */
  private static BuildOptions options(String formulation, boolean compact) {
    String integrator = formulation.equals("RR") ? "ode15sR" : "DE";
    RunSettings settings = new RunSettings(0, 3, 0.01, integrator, 1e-5, 1e-5);
    EnumSet<ColumnGroup> columns = EnumSet.range(ColumnGroup.JOINTS, ColumnGroup.ENERGY);
    return new BuildOptions(formulation, "auto", compact, columns, settings).in(CodeForm.SHARED);
  }

  /** Returns the model as code, every method of which the virtual machine compiles. */
  private static GeneratedModel generated(MechmlModel file, BuildOptions options) {
    GeneratedModel generated = ModelFactory.generate(file, options);
    assertThat(generated.formulationReason()).doesNotContain("compact form");
    byte[] classFile = Objects.requireNonNull(generated.classFiles().get(generated.className()));
    assertThat(MethodSizes.longest(classFile)).isLessThan(8000);
    return generated;
  }

  private static Model code(MechmlModel file, BuildOptions options) {
    return ModelFactory.compile(file, options, generated(file, options)).newInstance();
  }

  private static Model data(MechmlModel file, String formulation) {
    BuildOptions compact = options(formulation, true);
    return ModelFactory.compile(file, compact, ModelFactory.generate(file, compact)).newInstance();
  }

  private static MechmlModel chainOfAThousandLinks() throws IOException, MechmlException {
    Path file = Path.of("..", "..", "examples", "extremes", "chain_1000.xml");
    return MechmlReader.read("chain_1000.xml", Files.readAllBytes(file));
  }

  @Test
  void aChainOfAThousandLinksIsLeftToThePrintedStepsUnlessAFormIsAskedFor() throws Exception {
    BuildOptions byItself = options("DTR", false).in(CodeForm.AUTO);
    assertThat(ModelFactory.generate(chainOfAThousandLinks(), byItself).formulationReason())
        .contains("compact form", "printed steps");
  }

  @ParameterizedTest
  @ValueSource(strings = {"DTR", "RR"})
  void aChainOfAThousandLinksIsCodeWithTheResultsOfItsData(String formulation) throws Exception {
    MechmlModel chain = chainOfAThousandLinks();
    Model code = code(chain, options(formulation, false));
    assertAgreement(code, data(chain, formulation), chain.mechanism());
  }

  @Tag("soak")
  @ParameterizedTest
  @CsvSource({"DTR, SHARED", "RR, SHARED", "DTR, STRAIGHT"})
  void spatialChainsOfAThousandLinksAreCodeWithTheResultsOfTheirData(
      String formulation, CodeForm form) {
    MechmlModel chain = Scenes.model(Chains.ofDifferentLinks(1000));
    Model code = code(chain, options(formulation, false).in(form));
    assertAgreement(code, data(chain, formulation), chain.mechanism());
  }

  @Tag("soak")
  @ParameterizedTest
  @ValueSource(strings = {"DTR", "RR"})
  void spatialChainsOfThreeThousandLinksAreCodeWithTheResultsOfTheirData(String formulation) {
    MechmlModel chain = Scenes.model(Chains.ofDifferentLinks(3000));
    Model code = code(chain, options(formulation, false));
    assertAgreement(code, data(chain, formulation), chain.mechanism());
  }

  /** Accelerations or the residual, and poses, near a stretched chain at rest. */
  private static void assertAgreement(Model code, Model data, Mechanism mechanism) {
    double[] y =
        new Random(3)
            .doubles(mechanism.positionCount() + mechanism.velocityCount(), -0.01, 0.01)
            .toArray();
    double[] yDot = new Random(7).doubles(y.length, -0.1, 0.1).toArray();
    if (code instanceof ResidualModel residual) {
      double[] expected = new double[y.length];
      double[] actual = new double[y.length];
      residual.residual(TIME, y, yDot, actual);
      ((ResidualModel) ModelParts.of(data).equations()).residual(TIME, y, yDot, expected);
      // Nothing is solved for: rounding times depth.
      assertClose(actual, expected, 1e-12);
    } else {
      double[] expected = new double[y.length];
      double[] actual = new double[y.length];
      assertThat(((ExplicitModel) ModelParts.of(code).equations()).derivative(TIME, y, actual))
          .isEqualTo(ExplicitModel.REGULAR);
      ((ExplicitModel) ModelParts.of(data).equations()).derivative(TIME, y, expected);
      // Other operations in another order: rounding times depth and condition.
      assertClose(actual, expected, 1e-10);
    }
    double[] expected = new double[BodyPoses.NUMBERS_PER_BODY * mechanism.bodies().size()];
    double[] actual = new double[expected.length];
    ((BodyPoses) ModelParts.of(code).equations()).poses(TIME, y, actual);
    ((BodyPoses) ModelParts.of(data).equations()).poses(TIME, y, expected);
    assertClose(actual, expected, 1e-12);
  }

  /** Two angles of each Hooke joint, four numbers of a ball between them: none are in a row. */
  @Test
  void anglesThatAreTooManyForOneMethodHaveMethodsOfTheirOwn() {
    Mechanism star = hookeJointsAndBalls(STAR);
    MechmlModel file = Scenes.model(star);
    BuildOptions options = options("DTR", false);
    GeneratedModel generated = generated(file, options);
    assertThat(generated.source()).contains("derivativeAngles1(", "derivativeAngles2(");
    Model code = ModelFactory.compile(file, options, generated).newInstance();
    double[] y = RandomMechmlTrees.state(1, star);
    assertThat(derivative(code, y))
        .containsExactly(
            derivative(ModelFactory.compileSource(file, options, generated).newInstance(), y));
    double[] expected = derivative(data(file, "DTR"), y);
    // Bodies side by side: rounding.
    assertClose(derivative(code, y), expected, 1e-13);
  }

  private static double[] derivative(Model model, double[] y) {
    double[] yDot = new double[y.length];
    ((ExplicitModel) ModelParts.of(model).equations()).derivative(TIME, y, yDot);
    return yDot;
  }

  /** Two or three constants of each number, and every body has 14 numbers of its own. */
  @Tag("soak")
  @Test
  void aSceneOfMoreNumbersThanAClassFileHoldsIsLeftToTheDataAndToldWhy() {
    MechmlModel tree = Scenes.model(hookeJointsAndBalls(4000));
    GeneratedModel generated =
        ModelFactory.generate(tree, options("DTR", false).in(CodeForm.STRAIGHT));
    assertThat(generated.formulationReason())
        .contains("no code is generated yet for so large a scene (S-085 the generated class");
    assertThat(generated.classFiles()).isNotEmpty();
  }

  /** Bodies side by side on the ground, by turns on two crossing axes and on balls. */
  private static Mechanism hookeJointsAndBalls(int count) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double own = 1 + i / (7.0 * count);
      InertiaTensor inertia = new InertiaTensor(own, 2 * own, 2.5 * own, 0.1 * own, 0.2, 0.3);
      Vector3 center = new Vector3(own, 2 * own, 3 * own);
      bodies.add(new Body("b" + i, own, center, inertia, Origin.NONE));
      Attachment ground =
          new Attachment(Mechanism.ROOT, new Vector3(i, 0, 0), i, Vector3.ZERO, Rotation.IDENTITY);
      Vector3 x = new Vector3(1, 0, 0);
      Vector3 y = new Vector3(0, 1, 0);
      JointStart u = JointStart.atZero(JointType.U);
      JointStart s = JointStart.atZero(JointType.S);
      joints.add(
          i % 2 == 0
              ? new Universal("j" + i, ground, x, y, u, false, Origin.NONE)
              : new Spherical("j" + i, ground, s, false, Origin.NONE));
    }
    Root root = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
    return new Mechanism("star", root, new Vector3(0, 0, -9.81), bodies, joints);
  }
}
