package org.mechservice.report.page;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.report.measure.EqualError;
import org.mechservice.report.measure.Point;
import org.mechservice.report.measure.SceneFindings;
import org.mechservice.report.measure.Spectrum;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.solver.api.run.Stiffness;
import org.mechservice.solver.catalogue.IntegrationMethod;

/** The recommendation in words, with its numbers. */
final class Advice {
  /** Usual errors: for a first look, for engineering work, for comparisons. */
  private static final double[] WANTED = {1e-3, 1e-6, 1e-9};

  /** Time constants or radians of a run from which stability may limit explicit steps at all. */
  private static final double FEW_STEPS = 50;

  private final SceneFindings found;

  Advice(SceneFindings found) {
    this.found = found;
  }

  /**
   * The cheapest way to an error.
   *
   * @param error wanted
   * @param point the cheapest point measured that has it
   * @param method its method
   * @param runnerUp the next cheapest of another method; empty if there is none
   */
  record Choice(double error, Point point, SimulationMethod method, Optional<Point> runnerUp) {}

  /** Returns the choices for the errors that the reference resolves and a method reaches. */
  List<Choice> choices() {
    List<Choice> choices = new ArrayList<>();
    for (double error : WANTED) {
      if (error > found.floor()) {
        cheapest(error, "").ifPresent(best -> choices.add(choice(error, best)));
      }
    }
    return choices;
  }

  private Choice choice(double error, Point best) {
    String name = best.first().method();
    SimulationMethod method =
        found.methods().stream().filter(m -> m.name().equals(name)).findFirst().orElseThrow();
    return new Choice(error, best, method, cheapest(error, name));
  }

  private Optional<Point> cheapest(double error, String butNot) {
    return found.points().stream()
        .filter(point -> point.completed() && point.error() <= error && point.seconds() > 0)
        .filter(point -> !point.first().method().equals(butNot))
        .min(Comparator.comparingDouble(Point::seconds));
  }

  /** Returns one sentence per choice. */
  List<String> sentences() {
    List<String> sentences = new ArrayList<>();
    for (Choice choice : choices()) {
      Point point = choice.point();
      String line =
          String.format(
              Locale.ROOT,
              "<b>Error %s:</b> <b>%s</b> at tolerance %s, %s (%s), %d evaluations, error %s.",
              Html.tolerance(choice.error()),
              choice.method().name(),
              Html.tolerance(point.tolerance()),
              Html.seconds(point.seconds()),
              spread(point),
              point.first().evaluations(),
              Html.error(point.error()));
      String next = choice.runnerUp().map(second -> next(point, second)).orElse("");
      sentences.add(
          line
              + next
              + "<br><code>"
              + Html.escape(
                  choice.method().options()
                      + " --rtol "
                      + Html.tolerance(point.tolerance())
                      + " --atol "
                      + Html.tolerance(point.tolerance() * 0.01))
              + "</code>");
    }
    return sentences;
  }

  private static String spread(Point point) {
    return point.isRepeated()
        ? "quartiles "
            + Html.seconds(point.lowSeconds())
            + " – "
            + Html.seconds(point.highSeconds())
        : "a single run";
  }

  /** Returns the next best method, and whether the difference is significant. */
  private static String next(Point best, Point second) {
    return String.format(
        Locale.ROOT,
        " Next: %s, %s%s.",
        second.first().method(),
        Html.factor(second.seconds() / best.seconds()),
        best.overlaps(second) ? ", which the spread of the times does not tell apart" : "");
  }

  /**
   * Returns the paragraph on the spectrum; empty if the spectrum does not matter for this scene.
   */
  Optional<String> stiffness() {
    Optional<Spectrum.Mode> fastest = found.spectrum().flatMap(Spectrum::fastest);
    if (fastest.isEmpty()) {
      return Optional.empty();
    }
    Spectrum spectrum = found.spectrum().orElseThrow();
    Spectrum.Mode mode = fastest.get();
    double timeConstants = spectrum.stiffness().timeConstants(spectrum.interval());
    double radians = spectrum.stiffness().radians(spectrum.interval());
    double size = Math.max(timeConstants, radians);
    if (spectrum.verdict() == Stiffness.Verdict.STIFF && fewestExplicit() < timeConstants) {
      return Optional.of(passing(mode, timeConstants));
    }
    String where = " It sits at joint <b>" + Html.escape(mode.joint()) + "</b>.";
    return Optional.of(
        switch (spectrum.verdict()) {
          case NOT_STIFF ->
              "<b>Not stiff.</b> The fastest motion of the linearised equations has modulus "
                  + Html.number(mode.modulus())
                  + " 1/s; "
                  + Html.digits(size)
                  + " time constants of it pass within the interval. Explicit methods "
                  + (size > FEW_STEPS
                      ? "take about as many steps for it, which are few: a run may note that"
                          + " stability limits them."
                      : "are not limited by it.");
          case STIFF ->
              "<b>Stiff.</b> The fastest motion decays with "
                  + Html.number(-mode.real())
                  + " 1/s (damping ratio "
                  + Html.digits(mode.damping())
                  + "): "
                  + Html.number(timeConstants)
                  + " time constants pass within the run, and an explicit method needs about as many"
                  + " steps whatever error is asked for. Ratio to the slowest motion: "
                  + Html.number(mode.modulus() / spectrum.slowest())
                  + "."
                  + where
                  + explicitAgainstImplicit();
          case OSCILLATORY ->
              "<b>Fast oscillation, little damping.</b> The fastest motion "
                  + (mode.imaginary() > 0 ? "swings with " : "moves away with ")
                  + Html.number(mode.modulus())
                  + (mode.imaginary() > 0 ? " rad/s" : " 1/s")
                  + " (damping ratio "
                  + Html.number(mode.damping())
                  + "): "
                  + Html.number(radians / (2 * Math.PI))
                  + " periods pass within the run. Where it is excited every method has to follow it;"
                  + " the higher order of explicit ones is then the advantage."
                  + where
                  + explicitAgainstImplicit();
        });
  }

  /**
   * Returns the paragraph on a fast decay that holds at times that were looked at and hardly
   * between them, as that of friction where a body starts to slide.
   */
  private String passing(Spectrum.Mode mode, double timeConstants) {
    return "<b>Not stiff.</b> At some times looked at the fastest motion decays with "
        + Html.number(-mode.real())
        + " 1/s at joint <b>"
        + Html.escape(mode.joint())
        + "</b>. It does not last: an explicit method took "
        + fewestExplicit()
        + " evaluations, where "
        + Html.number(timeConstants)
        + " time constants would ask for more.";
  }

  /** Returns the fewest evaluations of a run with an Adams method that came to the end. */
  private long fewestExplicit() {
    Set<String> adams =
        found.methods().stream()
            .filter(method -> isAdams(method.integrator()))
            .map(SimulationMethod::name)
            .collect(Collectors.toSet());
    return found.points().stream()
        .filter(point -> point.completed() && adams.contains(point.first().method()))
        .mapToLong(point -> point.first().evaluations())
        .min()
        .orElse(Long.MAX_VALUE);
  }

  private static boolean isAdams(String integrator) {
    return IntegrationMethod.find(integrator)
        .filter(method -> method.family() == IntegrationMethod.Family.ADAMS)
        .isPresent();
  }

  private String explicitAgainstImplicit() {
    Optional<String> best = Optional.empty();
    for (double error : new double[] {1e-6, 1e-4, 1e-3}) {
      double explicit = least(error, true);
      double implicit = least(error, false);
      if (best.isEmpty() && Double.isFinite(explicit) && Double.isFinite(implicit)) {
        String winner = explicit < implicit ? "explicit" : "implicit";
        double ratio = Math.max(explicit, implicit) / Math.min(explicit, implicit);
        best =
            Optional.of(
                " Measured at error "
                    + Html.tolerance(error)
                    + ": the best "
                    + winner
                    + " method wins by "
                    + Html.factor(ratio)
                    + ".");
      }
    }
    return best.orElse("");
  }

  private double least(double error, boolean explicit) {
    double least = Double.POSITIVE_INFINITY;
    for (SimulationMethod method : found.methods()) {
      if (method.integrator().startsWith("ode15") != explicit) {
        least =
            Math.min(
                least,
                EqualError.cost(found.pointsOf(method.name()), error, Point::seconds)
                    .orElse(Double.POSITIVE_INFINITY));
      }
    }
    return least;
  }
}
