package org.mechservice.sim.packaging;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.guard.BytecodeVerifier;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.sim.user.IdleForces;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.symbol.MathFunction;

/** The list of what a fetched model may use knows all that generated classes use. */
@Tag("slow")
class PermittedModelsTest {
  private static final Path EXAMPLES = Path.of("../../examples");

  private static final Set<ColumnGroup> ALL = EnumSet.allOf(ColumnGroup.class);

  private int checked;

  @Test
  void classesOfAllExamplesArePermitted() throws IOException {
    SortedSet<String> refused = new TreeSet<>();
    for (Path file : files()) {
      check(file, refused);
    }
    assertThat(refused).isEmpty();
    assertThat(checked).isGreaterThan(500);
  }

  /** A joint force whose formula calls every function, with arguments that no one knows before. */
  @Test
  void allFunctionsArePermitted() throws IOException, MechmlException {
    String formula =
        MathFunction.inFormulas().stream()
            .map(
                f ->
                    f.symbol()
                        + "(slide.v+0.5"
                        + ", 0.3+slide.v*slide.v".repeat(f.arity() - 1)
                        + ")")
            .collect(Collectors.joining(" + "));
    String text =
        Files.readString(EXAMPLES.resolve("elements/jointForce.xml"))
            .replaceFirst("expression=\"[^\"]*\"", "expression=\"" + formula + "\"");
    assertThat(text).contains(formula);
    SortedSet<String> refused = new TreeSet<>();
    MechmlModel model = MechmlReader.read("functions.xml", text.getBytes(StandardCharsets.UTF_8));
    for (boolean compact : new boolean[] {false, true}) {
      check(Path.of("functions.xml"), model, Formulation.DTR, compact, refused);
    }
    assertThat(refused).isEmpty();
    assertThat(checked).isEqualTo(2);
  }

  private static List<Path> files() throws IOException {
    try (Stream<Path> all = Files.walk(EXAMPLES)) {
      return all.filter(file -> file.toString().endsWith(".xml"))
          .filter(file -> !file.toString().contains("target"))
          .sorted()
          .toList();
    }
  }

  private void check(Path file, SortedSet<String> refused) throws IOException {
    byte[] content = Files.readAllBytes(file);
    String name = file.getFileName().toString();
    List<MechmlModel> models = new ArrayList<>();
    try {
      MechmlModel first = MechmlReader.read(name, content);
      for (SimulationSettings simulation : first.simulations()) {
        models.add(
            MechmlReader.read(
                name,
                content,
                new ReadOptions(Optional.of(simulation.name()), new TreeMap<>(), new TreeSet<>())));
      }
    } catch (MechmlException e) {
      return; // a part of others, or not of this language
    }
    for (MechmlModel model : models) {
      for (Formulation formulation : Formulation.values()) {
        for (boolean compact : new boolean[] {false, true}) {
          check(file, model, formulation, compact, refused);
        }
      }
    }
  }

  private void check(
      Path file,
      MechmlModel model,
      Formulation formulation,
      boolean compact,
      SortedSet<String> refused) {
    RunSettings run = model.settings().run();
    RunSettings settings =
        run.withIntegrator(
            formulation.isResidual()
                ? IntegrationMethod.ODE15SR.label()
                : IntegrationMethod.SWITCHING.label());
    GeneratedModel generated;
    try {
      generated =
          ModelFactory.generate(
              model,
              new BuildOptions(
                  formulation.label(),
                  "auto",
                  compact,
                  CodeForm.AUTO,
                  ALL,
                  settings,
                  Optional.empty()));
    } catch (ModelBuildException e) {
      return; // the formulation does not fit
    }
    SortedMap<String, byte[]> classFiles = generated.classFiles();
    Set<String> ofUsers = IdleForces.of(model.mechanism()).keySet();
    BytecodeVerifier.checkModel(classFiles, ofUsers)
        .forEach(use -> refused.add(use.text() + " (" + file.getFileName() + ")"));
    checked++;
  }
}
