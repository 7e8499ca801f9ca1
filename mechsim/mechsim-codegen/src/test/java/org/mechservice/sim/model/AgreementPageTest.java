package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Generated code against the data-driven form over random scenes: the largest difference over the
 * largest element, as a page; each bound is checked as well.
 */
@Tag("slow")
class AgreementPageTest {
  private static final Path PAGE = Path.of("..", "..", "docs", "reports", "generated-agreement.md");
  private static final double TIME = 0.4;
  private static final List<String> KINDS = List.of("trees", "with forces", "with user classes");
  private static final List<String> FORMULATIONS = List.of("DTR", "DSR", "RR", "RR-JF");

  /** Rounding times depth and condition; of RR times depth; of RR-JF that of its matrix too. */
  private static final List<Double> BOUNDS = List.of(1e-10, 1e-10, 1e-12, 1e-8);

  /** What was compared, and the largest difference. */
  private static final class Row {
    private int compared;
    private int without;
    private double largest;

    void add(double difference) {
      compared++;
      largest = Math.max(largest, difference);
    }
  }

  private static Mechanism scene(int seed, String kind) {
    int bodies = 2 + seed % 7;
    Mechanism tree =
        seed % 3 == 0
            ? RandomMechmlTrees.driven(seed, bodies)
            : seed % 3 == 1
                ? RandomMechmlTrees.ofAllJoints(seed, bodies)
                : RandomMechmlTrees.tree(seed, bodies);
    Mechanism forced = kind.equals("trees") ? tree : RandomMechmlForces.on(tree, seed);
    return kind.equals("with user classes") ? GeneratedUserForcesTest.pulled(forced) : forced;
  }

  private static ExplicitModel generated(Mechanism mechanism, String formulation) {
    String integrator = formulation.startsWith("RR") ? "ode15sR" : "DE";
    RunSettings settings = new RunSettings(0, 3, 0.01, integrator, 1e-5, 1e-5);
    MechmlModel model = Scenes.model(mechanism);
    BuildOptions options = new BuildOptions(formulation, EnumSet.of(ColumnGroup.ENERGY), settings);
    GeneratedModel generated = ModelFactory.generate(model, options);
    assertThat(generated.formulationReason()).doesNotContain("compact form");
    ClassLoader users = GeneratedUserForcesTest.class.getClassLoader();
    return (ExplicitModel)
        ModelParts.of(GeneratedUserForcesTest.loaded(generated, new TreeMap<>(), users))
            .equations();
  }

  private static void compare(Mechanism mechanism, String formulation, Row row) {
    double[] y = RandomMechmlTrees.state(3, mechanism);
    double[] yDot = new Random(7).doubles(y.length, -2, 2).toArray();
    double[] expected = new double[y.length];
    double[] actual = new double[y.length];
    LinearisedResidualModel reference =
        new LinearisedResidualModel(
            mechanism,
            Scenes.SETTINGS,
            GeneratedUserForcesTest.FORCES,
            LinearisedResidualModel.Mode.FULL);
    ExplicitModel model = generated(mechanism, formulation);
    if (formulation.startsWith("D")) {
      int result =
          new DataDrivenModel(mechanism, Scenes.SETTINGS, GeneratedUserForcesTest.FORCES)
              .derivative(TIME, y, expected);
      if (result != ExplicitModel.REGULAR) {
        row.without++;
        return;
      }
      assertThat(model.derivative(TIME, y, actual)).isEqualTo(ExplicitModel.REGULAR);
    } else if (formulation.equals("RR")) {
      reference.residual(TIME, y, yDot, expected);
      ((ResidualModel) ModelParts.of(model).equations()).residual(TIME, y, yDot, actual);
    } else {
      LinearisedModel implicit = (LinearisedModel) ModelParts.of(model).equations();
      if (!reference.linearise(TIME, y, yDot) || !reference.factor(1e-2)) {
        row.without++;
        return;
      }
      assertThat(implicit.linearise(TIME, y, yDot) && implicit.factor(1e-2)).isTrue();
      Arrays.setAll(expected, i -> yDot[i]);
      Arrays.setAll(actual, i -> yDot[i]);
      reference.solve(expected);
      implicit.solve(actual);
    }
    row.add(difference(actual, expected));
  }

  private static double difference(double[] actual, double[] expected) {
    double scale = Arrays.stream(expected).map(Math::abs).max().orElse(0);
    double largest = 0;
    for (int i = 0; i < actual.length; i++) {
      largest = Math.max(largest, Math.abs(actual[i] - expected[i]));
    }
    return scale == 0 ? largest : largest / scale;
  }

  private static List<String> compared(int scenes) {
    List<String> lines = new ArrayList<>();
    for (String kind : KINDS) {
      for (String formulation : FORMULATIONS) {
        Row row = new Row();
        for (int seed = 1; seed <= scenes; seed++) {
          compare(scene(seed, kind), formulation, row);
        }
        double bound = BOUNDS.get(FORMULATIONS.indexOf(formulation));
        assertThat(row.largest).as("%s %s", kind, formulation).isLessThanOrEqualTo(bound);
        // Singular mass matrices are rare: none of 500 scenes of any kind has one.
        assertThat(row.compared)
            .as("%s %s", kind, formulation)
            .isGreaterThanOrEqualTo(scenes * 9 / 10);
        lines.add(
            String.format(
                Locale.ROOT,
                "| %s | %s | %d | %d | %.1e | %.0e |",
                kind,
                formulation,
                row.compared,
                row.without,
                row.largest,
                bound));
      }
    }
    return lines;
  }

  @Test
  void aSliceOfTheScenesAgrees() {
    assertThat(compared(6)).hasSize(KINDS.size() * FORMULATIONS.size());
  }

  @Tag("soak")
  @Test
  void pageOfFiveHundredScenes() throws IOException {
    List<String> lines = new ArrayList<>();
    lines.add("# Generated code and the data-driven form");
    lines.add("");
    lines.add(
        "Written on %s by `mvn verify -Psoak`, %s %s, Java %s: random open chains of 2 to 8 bodies,"
                .formatted(
                    LocalDate.now(ZoneOffset.UTC),
                    System.getProperty("os.name"),
                    System.getProperty("os.arch"),
                    System.getProperty("java.version"))
            + " seeds 1 to 500, all joint types, driven joints, forces of every kind. DTR, DSR: y'; RR: the residual;"
            + " RR-JF: the solution of an implicit step. The largest difference over the largest"
            + " element; scenes whose mass matrix is singular in the state have none.");
    lines.add("");
    lines.add("| scenes | formulation | compared | singular | largest difference | bound |");
    lines.add("|---|---|---:|---:|---:|---:|");
    lines.addAll(compared(500));
    Files.writeString(PAGE, String.join("\n", lines) + "\n");
  }
}
