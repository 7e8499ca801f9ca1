package org.mechservice.study.gradient;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.sim.gradient.ModelFunctions;
import org.mechservice.sim.gradient.ProgramCode;
import org.mechservice.sim.gradient.VariationalEquations;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.ode.solve.IntegrationException;
import org.mechservice.study.ModelInputs;

/**
 * Random models: forward and adjoint derivatives against each other and against differences of
 * sixth order of whole runs; and of the equations, derivatives along directions against their
 * adjoint and against those of many directions at once.
 */
final class RandomGradientsTest {
  private static final Path PAGE = Path.of("..", "docs", "reports", "random-gradients.md");
  private static final int SOAKED = 200;

  /**
   * Steps of the differences as parts of the value: 6 h⁶ leaves 1e-11, and errors of 1e-11 of the
   * values, of a hundred steps at 1e-12 and events at some 1e-13 s, become 1e-8.
   */
  private static final double STEP = 4e-3;

  private static final double[] WEIGHTS = {3 / 4.0, -3 / 20.0, 1 / 60.0};

  /** Of the largest derivative of a result, by parameters as parts of their size. */
  private static final double BY_DIFFERENCES = 1e-6;

  /** Two integrations at 1e-12, one of them backwards with tolerances of a tenth. */
  private static final double BY_ADJOINT = 1e-8;

  /** Rounding of sums of some thousand products, whose terms may cancel in part. */
  private static final double ROUNDING = 1e-11;

  /** What was found of a scene: largest errors as parts of the largest derivative. */
  private record Errors(
      String kind, int models, int slopes, double adjoint, double differences, double dot) {
    Errors with(Errors other) {
      return new Errors(
          kind,
          models + other.models,
          slopes + other.slopes,
          Math.max(adjoint, other.adjoint),
          Math.max(differences, other.differences),
          Math.max(dot, other.dot));
    }
  }

  /**
   * @param most parameters by which differences are taken
   */
  private static Errors errors(long seed, int most) throws Exception {
    RandomScene scene = RandomScene.of(seed);
    Gradients gradients = Gradients.of(scene.model(), scene.by(), scene.results());
    Gradient forward = gradients.compute(GradientMethod.FORWARD);
    Gradient back = gradients.compute(GradientMethod.ADJOINT);
    double[] sizes =
        scene.by().stream().mapToDouble(name -> Math.abs(value(scene, name))).toArray();
    int results = scene.results().size();
    double[] largest = new double[results];
    double adjoint = 0;
    for (int i = 0; i < results; i++) {
      for (int k = 0; k < sizes.length; k++) {
        double slope = sizes[k] * Math.abs(forward.derivatives()[i][k]);
        largest[i] = Math.max(largest[i], slope);
      }
      for (int k = 0; k < sizes.length; k++) {
        double off = forward.derivatives()[i][k] - back.derivatives()[i][k];
        adjoint = Math.max(adjoint, sizes[k] * Math.abs(off) / largest[i]);
      }
    }
    double differences = 0;
    Random random = new Random(~seed);
    int compared = 0;
    for (int k : random.ints(most, 0, sizes.length).distinct().toArray()) {
      String name = scene.by().get(k);
      if (name.contains(".")) {
        continue;
      }
      compared++;
      double value = value(scene, name);
      double h = STEP * sizes[k];
      double[] sum = new double[results];
      for (int side = 0; side < WEIGHTS.length; side++) {
        double[] above = values(gradients, name, value + (side + 1) * h);
        double[] below = values(gradients, name, value - (side + 1) * h);
        for (int i = 0; i < results; i++) {
          sum[i] += WEIGHTS[side] * (above[i] - below[i]) / h;
        }
      }
      gradients.set(name, value);
      for (int i = 0; i < results; i++) {
        double off = sizes[k] * Math.abs(sum[i] - forward.derivatives()[i][k]);
        differences = Math.max(differences, off / largest[i]);
      }
    }
    return new Errors(scene.kind(), 1, compared * results, adjoint, differences, dot(scene, seed));
  }

  private static double[] values(Gradients gradients, String name, double value) {
    return gradients.set(name, value).compute(GradientMethod.FORWARD).values();
  }

  private static double value(RandomScene scene, String name) {
    return scene.model().parameters().stream()
        .filter(p -> p.name().equals(name))
        .mapToDouble(ModelParameter::value)
        .findFirst()
        .orElse(1);
  }

  /**
   * Returns the largest error of wᵀ(F_y dy + F_t dt + F_p dp) against the adjoint of w, and of
   * tangents of many directions and of few against those of one.
   */
  private static double dot(RandomScene scene, long seed) throws Exception {
    ModelInputs inputs =
        ModelInputs.of(
            scene.model(), scene.by().stream().filter(name -> !name.contains(".")).toList());
    int p = inputs.names().size();
    int[] chosen = new int[p];
    Arrays.setAll(chosen, k -> k);
    ModelFunctions functions =
        new ModelFunctions(
            inputs.model().content(),
            inputs.model().request().settings(),
            scene.results().stream().map(r -> r.column()).distinct().toList(),
            chosen);
    VariationalEquations equations = functions.equations();
    int n = equations.states();
    Random random = new Random(seed + 17);
    double[] y = functions.start();
    double[] seedOfOne = random.doubles(n + 1 + p, -1, 1).toArray();
    double[] weights = random.doubles(n, -1, 1).toArray();
    double[] out = new double[2 * n];
    double[] slopes = new double[n + 1 + p];
    assertThat(equations.tangent(0.1, y, seedOfOne, out)).isEqualTo(ProgramCode.REGULAR);
    assertThat(equations.adjoint(0.1, y, weights, slopes)).isEqualTo(ProgramCode.REGULAR);
    double forward = 0;
    double back = 0;
    double size = 0;
    for (int i = 0; i < n; i++) {
      forward += weights[i] * out[n + i];
      size += Math.abs(weights[i] * out[n + i]);
    }
    for (int i = 0; i < slopes.length; i++) {
      back += slopes[i] * seedOfOne[i];
      size += Math.abs(slopes[i] * seedOfOne[i]);
    }
    double error = Math.abs(forward - back) / size;
    for (int count : new int[] {1, 2 * p}) {
      int[] units = random.ints(count, 0, p).toArray();
      double[] seeds = random.doubles((long) count * n, -1, 1).toArray();
      double[] all = new double[(count + 1) * n];
      equations.directions(units);
      equations.tangents(0.1, y, seeds, all);
      for (int k = 0; k < count; k++) {
        double[] one = Arrays.copyOf(Arrays.copyOfRange(seeds, k * n, (k + 1) * n), n + 1 + p);
        one[n + 1 + units[k]] = 1;
        equations.tangent(0.1, y, one, out);
        double largest = 0;
        double off = 0;
        for (int i = 0; i < n; i++) {
          largest = Math.max(largest, Math.abs(out[n + i]));
          off = Math.max(off, Math.abs(out[n + i] - all[(k + 1) * n + i]));
        }
        error = Math.max(error, off / largest);
      }
    }
    return error;
  }

  private static void assertSmall(Errors errors, String of) {
    assertThat(errors.adjoint).as("%s, adjoint", of).isLessThan(BY_ADJOINT);
    assertThat(errors.differences).as("%s, differences", of).isLessThan(BY_DIFFERENCES);
    assertThat(errors.dot).as("%s, equations", of).isLessThan(ROUNDING);
  }

  /**
   * Compares until so many models have been compared.
   *
   * @param most parameters of each by which differences are taken
   * @param worst overwritten with what was found of each kind
   * @return number of models that were refused by name: a joint comes to rest where its force
   *     jumps, or bounces ever faster, and the run ends
   */
  private static int compare(int models, int most, Map<String, Errors> worst) throws Exception {
    int refused = 0;
    int compared = 0;
    for (long seed = 0; compared < models; seed++) {
      try {
        Errors errors = errors(seed, most);
        assertSmall(errors, "seed " + seed);
        worst.merge(errors.kind, errors, Errors::with);
        compared++;
      } catch (IllegalArgumentException e) {
        assertThat(e).hasMessageContaining("only touched");
        refused++;
      } catch (IntegrationException e) {
        assertThat(RandomScene.of(seed).kind())
            .as(e.getMessage())
            .isIn("impact", "dry friction", "stop");
        refused++;
      }
    }
    return refused;
  }

  @Test
  void forwardAdjointAndDifferencesAgreeOnTenModels() throws Exception {
    assertThat(compare(10, 1, new TreeMap<>())).isLessThan(5);
  }

  @Test
  @Tag("soak")
  void forwardAdjointAndDifferencesAgreeOnTwoHundred() throws Exception {
    Map<String, Errors> worst = new TreeMap<>();
    write(worst, compare(SOAKED, 3, worst));
  }

  private static void write(Map<String, Errors> worst, int refused) throws IOException {
    StringBuilder page = new StringBuilder();
    page.append("# Gradients of random models\n\n")
        .append(SOAKED)
        .append(
            " models of one to four joints with 3 to 14 parameters, over 0.6 s at tolerances of"
                + " 1e-12, seeds from 0 on: last value, root mean square and value at a time. Written on ")
        .append(LocalDate.now(ZoneOffset.UTC))
        .append(" by `RandomGradientsTest` under `mvn verify -Psoak`, ")
        .append(System.getProperty("os.name"))
        .append(' ')
        .append(System.getProperty("os.arch"))
        .append(", Java ")
        .append(System.getProperty("java.version"))
        .append(
            ", which also asserts the bounds;"
                + " every build runs ten of them. Errors are parts of the largest derivative of a"
                + " result, by parameters as parts of their size; the last column compares the"
                + " derivatives of the equations along directions with their adjoint (the dot"
                + " product identity) and with those of many directions at once. ")
        .append(refused)
        .append(
            " further models were refused by name: a joint comes to rest where its force jumps"
                + " (S-216, or the run ends there), or impacts follow each other ever faster.\n\n")
        .append(
            "| kind | models | slopes by differences | adjoint against forward | forward against"
                + " differences of sixth order | equations |\n|---|---|---|---|---|---|\n");
    worst.forEach(
        (kind, errors) ->
            page.append(
                String.format(
                    Locale.ROOT,
                    "| %s | %d | %d | %.1e | %.1e | %.1e |%n",
                    kind,
                    errors.models,
                    errors.slopes,
                    errors.adjoint,
                    errors.differences,
                    errors.dot)));
    page.append(
        String.format(
            Locale.ROOT,
            "| bound | | | %.0e | %.0e | %.0e |%n",
            BY_ADJOINT,
            BY_DIFFERENCES,
            ROUNDING));
    Files.writeString(PAGE, page.toString());
  }
}
