package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.guard.ModelClassLoader;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.compile.ModelCompiler;
import org.mechservice.sim.emit.GeneratedClass;
import org.mechservice.sim.equations.coordinates.GeneratedCutCoordinatesTest;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.dynamics.event.WrittenValues;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.text.Origin;

/** Code for what events watch and assign and for outputs, against the same driven by data. */
class GeneratedValuesTest {
  private static final double TIME = 0.4;

  static Stream<Named<Mechanism>> mechanisms() {
    return Stream.concat(
        IntStream.rangeClosed(1, 12)
            .mapToObj(
                seed ->
                    Named.of(
                        "tree " + seed,
                        seed % 2 == 0
                            ? RandomMechmlTrees.driven(seed, 2 + seed % 5)
                            : RandomMechmlTrees.ofAllJoints(seed, 2 + seed % 5))),
        LoopAgreement.scenes().limit(6));
  }

  private static BuildOptions options(boolean compact) {
    return new BuildOptions(
        "DSR", "auto", compact, EnumSet.of(ColumnGroup.OUTPUTS), Scenes.SETTINGS);
  }

  private static Model model(MechmlModel file, boolean compact) {
    GeneratedModel generated = ModelFactory.generate(file, options(compact));
    assertThat(generated.formulationReason().contains("compact form")).isEqualTo(compact);
    assertThat(generated.fromData()).isEmpty();
    ClassLoader users = GeneratedValuesTest.class.getClassLoader();
    return GeneratedUserForcesTest.loaded(generated, new TreeMap<>(), users);
  }

  private static ModelEvents events(Model model) {
    return ModelParts.of(model).events().orElseThrow();
  }

  @ParameterizedTest
  @MethodSource("mechanisms")
  void eventsAgreeWithThoseDrivenByData(Mechanism mechanism) {
    MechmlModel file = RandomMechmlEvents.on(mechanism, 1);
    ModelEvents data = events(model(file, true));
    ModelEvents code = events(model(file, false));
    double[] y = RandomMechmlTrees.state(3, mechanism);
    int count = file.settings().events().size();
    double[] expected = new double[count];
    double[] actual = new double[count];
    data.values(TIME, y, expected);
    code.values(TIME, y, actual);
    // Other operations in another order: rounding times depth.
    assertThat(actual).containsExactly(expected, within(1e-12));
    boolean[] all = new boolean[count];
    Arrays.fill(all, true);
    double[] after = y.clone();
    data.change(all, TIME, y);
    code.change(all, TIME, after);
    assertThat(after).containsExactly(y, within(1e-12));
  }

  @ParameterizedTest
  @MethodSource("mechanisms")
  void outputsAgreeWithThoseDrivenByData(Mechanism mechanism) {
    MechmlModel file = RandomMechmlEvents.on(mechanism, 1);
    ResultColumns data = ModelParts.of(model(file, true)).columns();
    ResultColumns code = ModelParts.of(model(file, false)).columns();
    double[] y = RandomMechmlTrees.state(3, mechanism);
    double[] expected = new double[file.outputs().size() + 1];
    double[] actual = new double[expected.length];
    data.values(ColumnGroup.OUTPUTS, TIME, y, expected, 1);
    code.values(ColumnGroup.OUTPUTS, TIME, y, actual, 1);
    assertThat(actual).containsExactly(expected, within(1e-12));
    assertThat(code.columns(ColumnGroup.OUTPUTS)).isEqualTo(data.columns(ColumnGroup.OUTPUTS));
  }

  @Test
  void theClassFileHasTheBitsOfTheCompiledSource() {
    MechmlModel file = RandomMechmlEvents.on(RandomMechmlTrees.ofAllJoints(1, 5), 1);
    GeneratedClass plan =
        ValuesClass.derive(file, Links.of(file.mechanism()), options(false)).plan().orElseThrow();
    String name = "org.mechservice.model." + plan.simpleName();
    Map<String, byte[]> written = Map.of(name, plan.classFile());
    Map<String, byte[]> compiled = ModelCompiler.compile(name, plan.source(), new TreeMap<>());
    double[] y = RandomMechmlTrees.state(3, file.mechanism());
    assertThat(outputs(name, written, y, file.outputs().size()))
        .containsExactly(outputs(name, compiled, y, file.outputs().size()));
  }

  /** Somebody who compiles what is written has the equations, the data, events and outputs. */
  @ParameterizedTest
  @MethodSource("mechanisms")
  void theWrittenSourcesAreAllClassesOfTheModel(Mechanism mechanism) {
    MechmlModel file = RandomMechmlEvents.on(mechanism, 1);
    GeneratedModel generated = ModelFactory.generate(file, options(false));
    CompiledModel written = ModelFactory.compile(file, options(false), generated);
    CompiledModel compiled = ModelFactory.compileSource(file, options(false), generated);
    assertThat(compiled.classFiles().keySet()).isEqualTo(written.classFiles().keySet()).hasSize(3);
    double[] y = RandomMechmlTrees.state(3, mechanism);
    double[] expected = new double[file.settings().events().size()];
    double[] actual = new double[expected.length];
    events(written.newInstance()).values(TIME, y, expected);
    events(compiled.newInstance()).values(TIME, y, actual);
    assertThat(actual).containsExactly(expected);
  }

  private static double[] outputs(
      String name, Map<String, byte[]> classFiles, double[] y, int count) {
    double[] outputs = new double[count];
    instance(name, classFiles).outputs(TIME, y, outputs);
    return outputs;
  }

  private static WrittenValues instance(String name, Map<String, byte[]> classFiles) {
    try {
      ClassLoader users = GeneratedValuesTest.class.getClassLoader();
      Class<?> type = new ModelClassLoader(new TreeMap<>(classFiles), users).loadClass(name);
      return (WrittenValues) type.getConstructor().newInstance();
    } catch (ReflectiveOperationException e) {
      throw new LinkageError("the generated class", e);
    }
  }

  /** Where an angle stands after whole turns is known from what came before. */
  @Test
  void anglesOfCutJointsAreLeftToTheDataThatCountTheirTurns() {
    Mechanism wheels = GeneratedCutCoordinatesTest.wheels(List.of(), List.of());
    Expression angle = new Expression.CoordinatePosition(new ClosureCoordinate(0, 0));
    MechmlModel plain = Scenes.model(wheels);
    MechmlModel file =
        new MechmlModel(
            wheels,
            plain.settings(),
            plain.simulations(),
            List.of(),
            List.of(new Output("turned", angle, "rad", Origin.NONE)),
            List.of(),
            List.of());
    BuildOptions options = new BuildOptions("DSR", Set.of(ColumnGroup.OUTPUTS), Scenes.SETTINGS);
    assertThat(ModelFactory.generate(file, options).fromData())
        .extracting(Omission::what, Omission::why)
        .containsExactly(
            tuple(
                "outputs",
                "an angle of a cut joint is among what they depend on, whose whole turns the data"
                    + " count"));
  }

  @Test
  void expressionsOfMoreOperationsThanFitSurelyAreLeftToTheData() {
    MechmlModel file = RandomMechmlEvents.on(RandomMechmlTrees.ofAllJoints(1, 120), 1);
    assertThat(ValuesClass.derive(file, Links.of(file.mechanism()), options(false)).fromData())
        .contains("all together they take more than 20000 operations");
  }
}
