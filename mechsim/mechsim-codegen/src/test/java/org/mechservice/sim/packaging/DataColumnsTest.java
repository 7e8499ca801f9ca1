package org.mechservice.sim.packaging;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.jar.JarEntry;
import java.util.jar.JarInputStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.guard.SolverClasses;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.CompiledModel;
import org.mechservice.sim.model.KeptRows;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.RandomMechmlEvents;
import org.mechservice.sim.model.RandomMechmlForces;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.step.StepKind;

/** Columns that no code is generated for travel as data with the models that asked for them. */
@Tag("slow")
class DataColumnsTest {
  private static final RunSettings SETTINGS = new RunSettings(0, 0.2, 0.1, "DE", 1e-6, 1e-6);
  private static final long SEED = 2;
  private static final String ANALYSIS = "solver/analysis/column/";

  private static CompiledModel pendulum(boolean compact, ColumnGroup... columns) {
    BuildOptions options = new BuildOptions("DTR", "auto", compact, Set.of(columns), SETTINGS);
    MechmlModel model = Scenes.model(Scenes.pendulum());
    return ModelFactory.compile(model, options, ModelFactory.generate(model, options));
  }

  private static List<double[]> rows(CompiledModel model, List<Variable> names, ColumnGroup... of)
      throws IOException {
    KeptRows kept = new KeptRows();
    RunRequest request = new RunRequest(SETTINGS, Set.of(of));
    RunReport report =
        new RuntimeSolver().run(model.newInstance(), request, kept, new RunControl());
    assertThat(report.outcome()).isInstanceOf(Outcome.Completed.class);
    names.addAll(kept.columns());
    return kept.rows();
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void motionIsTheSameToTheBitWithColumnsAndWithout(boolean compact) throws IOException {
    List<Variable> with = new ArrayList<>();
    List<Variable> without = new ArrayList<>();
    List<double[]> extended =
        rows(pendulum(compact, ColumnGroup.REACTIONS), with, ColumnGroup.REACTIONS);
    List<double[]> plain = rows(pendulum(compact), without);
    assertThat(with.subList(0, without.size())).isEqualTo(without);
    assertThat(with).contains(new Variable("j3.fz", "N"), new Variable("j5.tx", "N·m"));
    assertThat(with).hasSize(without.size() + 5 * 6);
    for (int i = 0; i < plain.size(); i++) {
      assertThat(Arrays.copyOf(extended.get(i), without.size())).containsExactly(plain.get(i));
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void valuesOfForcesAreColumnsAlsoWhereSomethingHappensAlongTheRun(boolean compact) {
    Mechanism pushed = RandomMechmlForces.on(RandomMechmlTrees.driven(SEED, 4), SEED);
    assertThat(forceColumns(RandomMechmlEvents.on(pushed, SEED), compact))
        .isEqualTo(forceColumns(Scenes.model(pushed), compact))
        .isNotEmpty();
  }

  private static List<Variable> forceColumns(MechmlModel model, boolean compact) {
    BuildOptions options =
        new BuildOptions("DTR", "auto", compact, Set.of(ColumnGroup.FORCES), SETTINGS);
    Model built =
        ModelFactory.compile(model, options, ModelFactory.generate(model, options)).newInstance();
    return ModelParts.of(built).columns().columns(ColumnGroup.FORCES);
  }

  /** The runtime JAR has the whole solver, so a model JAR needs none of it. */
  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void modelJarHasNoClassOfTheSolver(boolean compact) throws IOException {
    assertThat(entries(ModelJars.model(pendulum(compact), "")))
        .noneMatch(name -> name.contains("solver"));
    assertThat(entries(ModelJars.model(pendulum(compact, ColumnGroup.REACTIONS), "")))
        .noneMatch(name -> name.contains("solver"))
        .contains("org/mechservice/model/FiveBarPendulum.class");
    assertThat(entries(ModelJars.model(pendulum(false, ColumnGroup.REACTIONS), "")))
        .contains("org/mechservice/model/FiveBarPendulumWithColumns.class");
  }

  @Test
  void standaloneJarHasColumnsOnlyIfAskedFor() throws IOException {
    assertThat(entries(ModelJars.standalone(pendulum(false), "")))
        .noneMatch(name -> name.contains(ANALYSIS));
    assertThat(entries(ModelJars.standalone(pendulum(false, ColumnGroup.REACTIONS), "")))
        .anyMatch(name -> name.contains(ANALYSIS + "ReactionColumns"));
  }

  @ParameterizedTest
  @EnumSource(names = {"REACTIONS", "MOMENTUM", "OUTPUTS"})
  void aJarCarriesTheClassesOfTheColumnsAskedForAlone(ColumnGroup group) throws IOException {
    CompiledModel model = pushed(group);
    assertThat(entries(ModelJars.standalone(model, "")))
        .filteredOn(ChosenClasses.ofColumns()::contains)
        .hasSize(1)
        .allMatch(path -> ChosenClasses.of(model).needed(path) != null);
  }

  @Test
  void aJarCarriesThePrintedStepsOfItsJointsAlone() throws IOException {
    CompiledModel model = pushed(ColumnGroup.MOMENTUM);
    Set<Object> kinds = new HashSet<>();
    for (Link link : Links.of(model.source().mechanism()).links()) {
      kinds.add(StepKind.of(link));
      link.axes().turn().ifPresent(turn -> kinds.add(StepKind.ofTurn(turn.axis())));
    }
    assertThat(kinds).hasSizeLessThan(StepKind.values().length);
    assertThat(entries(ModelJars.standalone(model, "")))
        .filteredOn(name -> name.matches(".*/step/printed/Printed(?!Steps).*"))
        .hasSameSizeAs(kinds);
  }

  /** Compact, so that none of the columns is code. */
  private static CompiledModel pushed(ColumnGroup group) {
    Mechanism pushed = RandomMechmlForces.on(RandomMechmlTrees.driven(SEED, 4), SEED);
    MechmlModel model = RandomMechmlEvents.on(pushed, SEED);
    BuildOptions options = new BuildOptions("DTR", "auto", true, Set.of(group), SETTINGS);
    return ModelFactory.compile(model, options, ModelFactory.generate(model, options));
  }

  /** The machine it runs on has nothing but the JAR. */
  @ParameterizedTest
  @EnumSource(names = {"REACTIONS", "FORCES", "MOMENTUM", "OUTPUTS"})
  void aStandaloneJarPutsOutTheColumnsItWasBuiltWith(ColumnGroup group, @TempDir Path folder)
      throws Exception {
    Path jar = folder.resolve("p.jar");
    Files.write(jar, ModelJars.standalone(pushed(group), "").bytes());
    Path rows = folder.resolve("rows.csv");
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-jar",
                jar.toString(),
                "--columns",
                group.label(),
                "--out",
                rows.toString())
            .redirectErrorStream(true)
            .start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor()).as(said).isZero();
    assertThat(Files.readAllLines(rows)).hasSizeGreaterThan(1);
  }

  @Test
  void theClassesOfColumnsAreClassesOfTheSolver() {
    assertThat(ChosenClasses.ofColumns())
        .isNotEmpty()
        .allSatisfy(p -> assertThat(SolverClasses.file(p)).isNotNull());
  }

  private static List<String> entries(JarImage jar) throws IOException {
    List<String> names = new ArrayList<>();
    try (JarInputStream stream = new JarInputStream(new ByteArrayInputStream(jar.bytes()))) {
      for (JarEntry e = stream.getNextJarEntry(); e != null; e = stream.getNextJarEntry()) {
        names.add(e.getName());
      }
    }
    return names;
  }
}
