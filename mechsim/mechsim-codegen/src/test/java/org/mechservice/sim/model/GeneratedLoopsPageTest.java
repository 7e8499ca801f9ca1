package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Function;
import org.junit.jupiter.api.Named;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.equations.derivatives.ResidualDerivatives;
import org.mechservice.solver.api.capability.DependentStates;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.links.Links;

/** Agreement and speed of code for loops; the soak run writes them to a page of docs/reports. */
@Tag("soak")
class GeneratedLoopsPageTest {
  private static final Path PAGE = Path.of("..", "..", "docs", "reports", "generated-loops.md");
  private static final int SCENES = 500;
  private static final int ROUNDS = 400;
  private static final long NANOS_PER_ROUND = 1_500_000;
  private static final List<String> MODELS =
      List.of(
          "benchmarks/slider_crank_planar.xml",
          "extremes/fourbar_redundant.xml",
          "benchmarks/A03_andrews.xml",
          "five-point-suspension/variants/elements.xml");

  private final List<String> lines = new ArrayList<>();

  @Test
  void pageOfAgreementAndSpeed() throws IOException, MechmlException {
    line("# Generated code for loops: agreement and speed");
    line("");
    line(
        "Measured on %s by `mvn verify -Psoak`: %s %s, %d cores at load %.0f, Java %s.",
        LocalDate.now(ZoneOffset.UTC),
        System.getProperty("os.name"),
        System.getProperty("os.arch"),
        Runtime.getRuntime().availableProcessors(),
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
        System.getProperty("java.version"));
    agreement();
    speed();
    derivatives();
    Files.writeString(PAGE, String.join("\n", lines) + "\n");
  }

  private void line(String format, Object... values) {
    lines.add(values.length == 0 ? format : String.format(Locale.ROOT, format, values));
  }

  private void agreement() {
    line("");
    line("## Agreement");
    line("");
    line(
        "%d seeded trees of 2 to 7 bodies with joints of all types, driven ones among them, forces"
            + " of every kind on half of them, closed by one or two of: cut joints of all types,"
            + " also driven, rods with and without mass, points on planes and lines, relations of"
            + " coordinates. Differences between generated code and data over the largest element.",
        SCENES);
    line("");
    line("| what | compared | median | largest | bound |");
    line("|---|---|---|---|---|");
    List<LoopAgreement> all =
        LoopAgreement.scenes().limit(SCENES).map(Named::getPayload).map(LoopAgreement::of).toList();
    row("accelerations, projection", all, LoopAgreement::projection, LoopAgreement.PROJECTION);
    row("residual, projection", all, LoopAgreement::reduced, LoopAgreement.REDUCED);
    row("accelerations, penalty, loops open", all, LoopAgreement::penalty, LoopAgreement.PENALTY);
    row("residual, penalty, loops open", all, LoopAgreement::residual, LoopAgreement.RESIDUAL);
    row("implicit step, projection", all, LoopAgreement::reducedStep, LoopAgreement.STEP);
    row("implicit step, penalty", all, LoopAgreement::step, LoopAgreement.STEP);
    row("energies and power, loops open", all, LoopAgreement::energy, LoopAgreement.RESIDUAL);
  }

  private void row(
      String what,
      List<LoopAgreement> all,
      Function<LoopAgreement, OptionalDouble> figure,
      double bound) {
    double[] sorted =
        all.stream().map(figure).flatMapToDouble(OptionalDouble::stream).sorted().toArray();
    double largest = sorted[sorted.length - 1];
    assertThat(largest).as(what).isLessThanOrEqualTo(bound);
    line(
        "| %s | %d | %.1e | %.1e | %.0e |",
        what, sorted.length, sorted[sorted.length / 2], largest, bound);
  }

  private void speed() throws IOException, MechmlException {
    line("");
    line("## Speed");
    line("");
    line(
        "y' by DSR, and the completion of dependent positions and velocities by projection, ns;"
            + " least of %d rounds of 1.5 ms. Operations of the terms are those of the generated"
            + " code; the closure's linear algebra, the same in both forms, comes on top.",
        ROUNDS);
    line("");
    line(
        "| model | closure | y', data | y', code | completed, data | completed, code | operations"
            + " |");
    line("|---|---|---|---|---|---|---|");
    for (String file : MODELS) {
      for (String closure : List.of("projection", "penalty")) {
        MechmlModel model = read(file);
        ExplicitModel data = model(model, closure, true);
        ExplicitModel code = model(model, closure, false);
        BuildOptions options = LoopAgreement.options("DSR", closure, false);
        line(
            "| %s | %s | %d | %d | %s | %s | %d |",
            file,
            closure,
            derivative(data),
            derivative(code),
            completion(data),
            completion(code),
            ModelFactory.generate(model, options).operations());
      }
    }
  }

  /** Of RR-JF. */
  private void derivatives() throws IOException, MechmlException {
    line("");
    line("## Derivatives and energies");
    line("");
    line(
        "RR-JF: derivatives of the residual with what the closure makes of them, and kinetic and"
            + " potential energy, ns; otherwise as above.");
    line("");
    line("| model | closure | derivatives, data | code | energies, data | code | operations |");
    line("|---|---|---|---|---|---|---|");
    for (String file : MODELS) {
      for (String closure : List.of("projection", "penalty")) {
        MechmlModel model = read(file);
        LinearisedModel data = residual(model, closure, true);
        LinearisedModel code = residual(model, closure, false);
        line(
            "| %s | %s | %d | %d | %d | %d | %d |",
            file,
            closure,
            linearisation(data),
            linearisation(code),
            energies(data),
            energies(code),
            ResidualDerivatives.ofLoops(Links.of(model.mechanism())).operationCount());
      }
    }
  }

  private static MechmlModel read(String file) throws IOException, MechmlException {
    Path path = Path.of("..", "..", "examples").resolve(file);
    return MechmlReader.read(path.getFileName().toString(), Files.readAllBytes(path));
  }

  private static LinearisedModel residual(MechmlModel file, String closure, boolean compact) {
    return LoopAgreement.model(
        file, LoopAgreement.options("RR-JF", closure, compact), LinearisedModel.class);
  }

  private static long linearisation(LinearisedModel model) {
    double[] y = new double[model.unknownCount()];
    double[] rates = new double[y.length];
    model.consistent(0, y, rates);
    return least(() -> model.linearise(0, y, rates));
  }

  private static long energies(LinearisedModel model) {
    double[] y = new double[model.description().stateCount()];
    double[] energy = new double[2];
    model.initialState(y);
    return least(() -> ((Energies) ModelParts.of(model).equations()).energy(0, y, energy));
  }

  private static ExplicitModel model(MechmlModel file, String closure, boolean compact) {
    return LoopAgreement.model(
        file, LoopAgreement.options("DSR", closure, compact), ExplicitModel.class);
  }

  private static long derivative(ExplicitModel model) {
    double[] y = new double[model.description().stateCount()];
    double[] yDot = new double[y.length];
    model.initialState(y);
    return least(() -> model.derivative(0, y, yDot));
  }

  private static String completion(ExplicitModel model) {
    if (!(model instanceof DependentStates dependent)) {
      return "-";
    }
    double[] y = new double[model.description().stateCount()];
    model.initialState(y);
    return Long.toString(least(() -> dependent.complete(0, y)));
  }

  private static long least(Runnable evaluation) {
    long best = Long.MAX_VALUE;
    int evaluations = 200;
    for (int round = 0; round < 2 * ROUNDS; round++) {
      long start = System.nanoTime();
      for (int i = 0; i < evaluations; i++) {
        evaluation.run();
      }
      long each = Math.max(1, (System.nanoTime() - start) / evaluations);
      best = Math.min(best, each);
      evaluations = (int) Math.max(1, NANOS_PER_ROUND / each);
    }
    return best;
  }
}
