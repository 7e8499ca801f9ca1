package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.compile.ModelCompiler;
import org.mechservice.sim.equations.loop.GeneratedLoopsTest;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.sim.user.UserFile;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.mechanism.Mechanism;

/** Code for loops that forces of users are put to, against the same closures driven by data. */
@Tag("slow")
class GeneratedLoopsWithUserForcesTest {
  private static final Path SUSPENSION = Path.of("..", "..", "examples", "five-point-suspension");
  private static final ClassLoader OWN = GeneratedLoopsWithUserForcesTest.class.getClassLoader();

  static Stream<Named<Mechanism>> scenes() {
    return pulled().limit(8);
  }

  static Stream<Named<Mechanism>> manyScenes() {
    return pulled().skip(8).limit(192);
  }

  private static Stream<Named<Mechanism>> pulled() {
    return LoopAgreement.scenes()
        .map(
            scene -> Named.of(scene.getName(), GeneratedUserForcesTest.pulled(scene.getPayload())));
  }

  private static MechmlModel suspension() throws IOException, MechmlException {
    String name = "five-point-suspension.xml";
    return MechmlReader.read(name, Files.readAllBytes(SUSPENSION.resolve(name)));
  }

  private static UserClasses suspensionClasses() throws IOException, MechmlException {
    List<UserFile> files = new ArrayList<>();
    for (String name : List.of("FpsFBody.java", "FpsSpringDamper.java")) {
      files.add(new UserFile(name, Files.readAllBytes(SUSPENSION.resolve(name))));
    }
    return UserClasses.admit(suspension().mechanism(), files, true)
        .forThisProcess(UserCode.NONE.unconfined());
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void equationsAgreeWithThoseDrivenByData(Mechanism mechanism) {
    LoopAgreement.of(mechanism, OWN).assertWithinBounds();
  }

  @Tag("soak")
  @ParameterizedTest
  @MethodSource("manyScenes")
  void equationsOfManyScenesAgreeWithThoseDrivenByData(Mechanism mechanism) {
    LoopAgreement.of(mechanism, OWN).assertWithinBounds();
  }

  @Test
  void theSuspensionOfThePaperMovesByCodeAsByData() throws IOException, MechmlException {
    LoopAgreement.of(suspension().mechanism(), suspensionClasses().loader()).assertWithinBounds();
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 3, 5})
  void theClassFileHasTheBitsOfTheCompiledSource(int seed) {
    Mechanism mechanism = GeneratedUserForcesTest.pulled(LoopAgreement.scene(seed));
    assertEqualBits(Scenes.model(mechanism), OWN);
  }

  @Test
  void theSuspensionsClassFileHasTheBitsOfItsCompiledSource() throws IOException, MechmlException {
    assertEqualBits(suspension(), suspensionClasses().loader());
  }

  private static void assertEqualBits(MechmlModel file, ClassLoader users) {
    GeneratedModel generated =
        ModelFactory.generate(file, LoopAgreement.options("RR", "penalty", false));
    SortedMap<String, byte[]> compiled =
        ModelCompiler.compile(generated.sourceName(), generated.source(), new TreeMap<>());
    Model direct = GeneratedUserForcesTest.loaded(generated, new TreeMap<>(), users);
    Model fromSource = GeneratedUserForcesTest.loaded(generated, compiled, users);
    assertThat(GeneratedLoopsTest.everything(direct))
        .containsExactly(GeneratedLoopsTest.everything(fromSource));
  }

  @ParameterizedTest
  @ValueSource(strings = {"DSR", "RR", "RR-JF"})
  void whatIsBuiltOfTheSuspensionNamesItsClasses(String formulation)
      throws IOException, MechmlException {
    GeneratedModel generated =
        ModelFactory.generate(
            suspension(), LoopAgreement.options(formulation, "projection", false));
    assertThat(generated.formulationReason())
        .doesNotContain("compact form")
        .endsWith("every evaluation calls the classes of forces \"fBody\", \"fFpsSpringDamper\"");
  }

  @ParameterizedTest
  @ValueSource(strings = {"projection", "penalty"})
  void derivativesOfTheResidualAreCode(String closure) {
    MechmlModel file =
        Scenes.model(
            GeneratedUserForcesTest.pulled(
                RandomMechmlLoops.on(RandomMechmlTrees.tree(1, 2), 1, 1)));
    GeneratedModel generated =
        ModelFactory.generate(file, LoopAgreement.options("RR-JF", closure, false));
    assertThat(generated.source()).contains("implements LoopTerms.OfDerivatives");
    assertThat(generated.fromData()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"projection", "penalty"})
  void aForceThatIsNotFiniteEndsTheEvaluationWithItsName(String closure) {
    Mechanism mechanism = GeneratedUserForcesTest.pulled(LoopAgreement.scene(1));
    ResidualModel model = LoopAgreement.code(mechanism, "RR", closure, ResidualModel.class);
    double[] y = new double[model.unknownCount()];
    model.initialState(y);
    Arrays.fill(y, mechanism.positionCount(), y.length, 1e200);
    assertThat(model.derivative(0, y, new double[y.length])).isEqualTo(Defects.DEFECT);
    assertThat(((Defects) model).lastDefect().part()).isEqualTo("force pull");
    assertThat(model.residual(0, y, new double[y.length], new double[y.length]))
        .isEqualTo(Defects.DEFECT);
    assertThat(((Defects) model).lastDefect().part()).isEqualTo("force pull");
  }

  @Test
  void anEvaluationAllocatesNothing() {
    Mechanism mechanism = GeneratedUserForcesTest.pulled(LoopAgreement.scene(1));
    ExplicitModel model = LoopAgreement.code(mechanism, "DSR", "penalty", ExplicitModel.class);
    double[] y = new double[model.description().stateCount()];
    double[] yDot = new double[y.length];
    model.initialState(y);
    ThreadMXBean thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    // The virtual machine itself may allocate while it compiles: the least of several counts.
    for (int round = 0; round < 5; round++) {
      long before = thread.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 50; i++) {
        model.derivative(0, y, yDot);
      }
      least = Math.min(least, thread.getCurrentThreadAllocatedBytes() - before);
    }
    assertThat(least).isZero();
  }
}
