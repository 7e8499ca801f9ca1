package org.mechservice.sim.emit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.Omission;
import org.mechservice.sim.model.Scenes;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/** The text of a model class. */
class GeneratedSourceTest {
  private static final BuildOptions LEAN = new BuildOptions("auto", Set.of(), Scenes.SETTINGS);
  private static final BuildOptions WITH_BODIES =
      new BuildOptions("DTR", Set.of(ColumnGroup.BODIES), Scenes.SETTINGS);

  private static String source(Mechanism mechanism, BuildOptions options) {
    return ModelFactory.generate(Scenes.model(mechanism), options).source();
  }

  /**
   * A cart on rails with a pendulum, named as given.
   *
   * <pre>
   *   ground --P x-- cart --R y-- bob
   * </pre>
   */
  private static Mechanism cart(String model, String cart, String bob, String slide, String hinge) {
    Body cartBody =
        new Body(cart, 2, Vector3.ZERO, new InertiaTensor(1, 1, 1, 0, 0, 0), Origin.NONE);
    Body bobBody =
        new Body(bob, 1, new Vector3(0, 0, -1), new InertiaTensor(2, 2, 1, 0, 0, 0), Origin.NONE);
    List<Joint> joints = new ArrayList<>();
    joints.add(joint(slide, "P", Mechanism.ROOT, 0, new Vector3(1, 0, 0)));
    joints.add(joint(hinge, "R", 0, 1, new Vector3(0, 1, 0)));
    Root root = new Root("ground", new Vector3(0, 0, 1), Rotation.IDENTITY);
    return new Mechanism(model, root, new Vector3(0, 0, -10), List.of(cartBody, bobBody), joints);
  }

  private static Joint joint(String name, String type, int parent, int child, Vector3 axis) {
    Attachment attachment =
        new Attachment(parent, new Vector3(0, 0, 0.5), child, Vector3.ZERO, Rotation.IDENTITY);
    return Scenes.joint(name, type, attachment, axis, 0.25, 0);
  }

  @Test
  void thePendulumReadsAsItsGoldenFile() throws IOException {
    assertGolden("FiveBarPendulum.java.txt", source(Scenes.pendulum(), LEAN));
  }

  @Test
  void aCartWithPosesReadsAsItsGoldenFile() throws IOException {
    Mechanism cart = cart("cart", "cart", "bob", "slide", "hinge");
    assertGolden("cart.java.txt", source(cart, WITH_BODIES));
  }

  @Test
  void aGimbalWithMasslessRingsReadsAsItsGoldenFile() throws IOException {
    Mechanism gimbal = Scenes.scene("gimbal_q2_1.5707963267948966.json", "gimbal");
    assertGolden("gimbal.java.txt", source(gimbal, LEAN));
  }

  /** Run with -Dgolden.write=true to write the files anew, and read what changed. */
  private static void assertGolden(String file, String actual) throws IOException {
    if (Boolean.getBoolean("golden.write")) {
      Path folder = Path.of("src", "test", "resources", "org", "mechservice", "sim", "model");
      Files.writeString(folder.resolve(file), actual);
    }
    assertThat(actual).isEqualTo(Scenes.text(file));
  }

  @ParameterizedTest
  @ValueSource(strings = {"pend5", "pend5s", "driver41"})
  void linesFitTheScreen(String name) {
    assertThat(source(Scenes.timingModel(name).mechanism(), WITH_BODIES).lines())
        .allMatch(line -> line.length() <= 100);
  }

  @Test
  void theSameModelGivesTheSameText() {
    Mechanism mechanism = Scenes.timingModel("driver41").mechanism();
    assertThat(source(mechanism, WITH_BODIES)).isEqualTo(source(mechanism, WITH_BODIES));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "*/ } static { System.exit(1); } /*",
        "\\u002a/ static { throw new Error(); }",
        "\\u000a int x;",
        "\"); System.exit(2); (\"",
        "\\\" + 1 + \\\"",
        "a\\",
        "<b>&{@link Object}",
        "class",
        "System",
        "Math",
        "0",
        "_",
        "größe µ \uD83D\uDE00",
        "y",
        "w",
        "b_x",
        " ",
        "x\u2028y"
      })
  void namesFromStrangersStayNames(String name) {
    Mechanism mechanism = cart(name, name, name + "_x", name + "_y", name);
    MechmlModel model = Scenes.model(mechanism);
    CompiledModel compiled =
        ModelFactory.compile(model, WITH_BODIES, ModelFactory.generate(model, WITH_BODIES));
    ExplicitModel instance = (ExplicitModel) ModelParts.of(compiled.newInstance()).equations();
    assertThat(instance.description().name()).isEqualTo(name);
    assertThat(instance.description().joints().get(0).name()).isEqualTo(name + "_y");
    assertThat(((BodyPoses) ModelParts.of(instance).equations()).bodies())
        .containsExactly(name, name + "_x");
    assertThat(compiled.classFiles()).hasSize(1);
    double[] yDot = new double[4];
    double[] other = new double[4];
    double[] y = {0.1, 0.2, 0.3, 0.4};
    assertThat(instance.derivative(0, y, yDot)).isEqualTo(ExplicitModel.REGULAR);
    MechmlModel plain = Scenes.model(cart("plain", "a", "b", "c", "d"));
    CompiledModel plainModel =
        ModelFactory.compile(plain, LEAN, ModelFactory.generate(plain, LEAN));
    ((ExplicitModel) ModelParts.of(plainModel.newInstance()).equations()).derivative(0, y, other);
    assertThat(yDot).containsExactly(other);
  }

  @Test
  void namesWithControlCharactersAreRefused() {
    MechmlModel model = Scenes.model(cart("m", "a\nb", "c", "d", "e"));
    assertThatThrownBy(() -> ModelFactory.generate(model, LEAN))
        .isInstanceOf(ModelBuildException.class)
        .hasMessage(
            "S-083 the name \"a?b\" contains a control character (shown as ?); leave it out");
  }

  /** Class and source hold names that are longer together than one constant may be. */
  @ParameterizedTest
  @ValueSource(strings = {"b", "\u2211", "\ud83d\ude97"})
  void longNamesAreKept(String part) throws ReflectiveOperationException {
    String name = part.repeat(70_001);
    MechmlModel model = Scenes.model(cart(name + "?", "c", name, "d", name + "!"));
    GeneratedModel generated = ModelFactory.generate(model, WITH_BODIES);
    for (CompiledModel compiled :
        List.of(
            ModelFactory.compile(model, WITH_BODIES, generated),
            ModelFactory.compileSource(model, WITH_BODIES, generated))) {
      Model instance = compiled.newInstance();
      assertThat(instance.description().name()).isEqualTo(name + "?");
      assertThat(instance.description().joints().get(1).name()).isEqualTo(name + "!");
      assertThat(((BodyPoses) ModelParts.of(instance).equations()).bodies())
          .containsExactly("c", name);
    }
  }

  @Test
  void formulationsAndIntegratorsThatAreNotHereAreRefusedByName() {
    MechmlModel model = Scenes.model(Scenes.pendulum());
    Map<String, String> refusals =
        Map.of(
            "RR-JF",
            "S-081 formulation RR-JF is a residual F(t, y, y') = 0, which integrator DE does"
                + " not take; use ode15sR, or DTR or DSR",
            "XYZ",
            "S-081 there is no formulation \"XYZ\"; use DTR, DSR, RR, RR-JF or auto");
    refusals.forEach(
        (formulation, message) ->
            assertThatThrownBy(
                    () ->
                        ModelFactory.generate(
                            model, new BuildOptions(formulation, Set.of(), Scenes.SETTINGS)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(message));
    RunSettings unknown = new RunSettings(0, 1, 0.1, "ode45", 1e-5, 1e-5);
    assertThatThrownBy(
            () -> ModelFactory.generate(model, new BuildOptions("auto", Set.of(), unknown)))
        .hasMessage(
            "S-082 integrator \"ode45\" is not in this version; use ode113, DE, ode15s,"
                + " ode15sR or switching");
  }

  @Test
  void settingsTravelWithTheClass() {
    RunSettings all = new RunSettings(1, 2, 0.5, "ode113", 1e-7, 1e-9, 0.25, 1e-3, 5);
    RunSettings bounded =
        new RunSettings(1, 2, 0.5, "DE", 1e-7, 1e-9, Double.POSITIVE_INFINITY, 1e-3, 0);
    RunSettings strict = bounded.withAccuracy(Accuracy.STRICT);
    for (RunSettings settings : List.of(all, bounded, strict)) {
      BuildOptions options = new BuildOptions("auto", Set.of(), settings);
      MechmlModel model = Scenes.model(Scenes.pendulum());
      CompiledModel compiled =
          ModelFactory.compile(model, options, ModelFactory.generate(model, options));
      assertThat(compiled.newInstance().description().defaults()).isEqualTo(settings);
      CompiledModel ofSource =
          ModelFactory.compileSource(model, options, ModelFactory.generate(model, options));
      assertThat(ofSource.newInstance().description().defaults()).isEqualTo(settings);
    }
  }

  @Test
  void leftOutIsWhatTheClassDoesNotHave() {
    GeneratedModel pendulum = ModelFactory.generate(Scenes.model(Scenes.pendulum()), LEAN);
    assertThat(pendulum.leftOut())
        .extracting(Omission::what)
        .contains(
            "quaternions", "poses of the bodies", "test for singular joints", "sliding joints")
        .doesNotContain("gravity");
    assertThat(pendulum.source()).doesNotContain("poses(", "return REGULAR - 1", "if (");
    GeneratedModel gimbal =
        ModelFactory.generate(
            Scenes.model(Scenes.scene("gimbal_q2_1.5707963267948966.json", "gimbal")), LEAN);
    assertThat(gimbal.leftOut())
        .extracting(Omission::what)
        .contains("inertia of bodies i1, i2")
        .doesNotContain("test for singular joints");
    assertThat(gimbal.source()).contains("if (");
  }

  @Test
  void nothingIsCalledLeftOutThatColumnsOrFormulasBringIn() {
    Mechanism cart = cart("cart", "cart", "bob", "slide", "hinge");
    assertThat(ModelFactory.generate(Scenes.model(cart), WITH_BODIES).leftOut())
        .extracting(Omission::what)
        .doesNotContain("quaternions");
    Joint slide = joint("slide", "P", Mechanism.ROOT, 0, new Vector3(1, 0, 0));
    Expression wave = new Expression.Call(MathFunction.SIN, List.of(new Expression.Time()));
    Mechanism pushed =
        new Mechanism(
            "pushed",
            cart.root(),
            cart.gravity(),
            cart.bodies().subList(0, 1),
            List.of(slide),
            List.of(),
            List.of(StartRole.PREFERRED),
            List.of(),
            List.of(new JointForce("push", new JointCoordinate(0, 0), wave, Origin.NONE)),
            List.of());
    GeneratedModel generated = ModelFactory.generate(Scenes.model(pushed), LEAN);
    assertThat(generated.source()).contains("SinCos.sinCos(t");
    assertThat(generated.leftOut())
        .extracting(Omission::what)
        .contains("quaternions")
        .doesNotContain("sines and cosines");
  }
}
