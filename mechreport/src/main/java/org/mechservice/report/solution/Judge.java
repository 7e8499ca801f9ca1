package org.mechservice.report.solution;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The reference of runs and its interval: the published one if there is one, otherwise one computed
 * by the codes; cut at the time from which it cannot resolve relevant errors.
 *
 * @param reference empty if there is none
 * @param grid output times that meet it
 * @param said sentences on how the reference was made and on its doubts
 * @param doubt one sentence of warning to the reader; empty if there is none
 */
public record Judge(Optional<Reference> reference, RunGrid grid, List<String> said, String doubt) {
  /** Floor above which eight digits cannot be judged. */
  private static final double CUT = 1e-9;

  /** A reference for a bound is known to this part of it. */
  private static final double OF_BOUND = 1e-3;

  /** Largest difference allowed between the codes' solution and the published reference. */
  private static final double AGREES = 1e-6;

  /** Largest difference of the codes, in units of the effect of one unit in the last place. */
  private static final double EXPLAINED = 1e4;

  /** A floor above this, at a time that is kept all the same, is a warning. */
  private static final double USEFUL = 1e-7;

  /**
   * Codes on two formulations that differ from a reference by so many times what they differ by.
   */
  private static final double OUTLIER = 1e3;

  public Judge {
    said = List.copyOf(said);
  }

  /** Returns whether the reader must be warned. */
  public boolean doubtful() {
    return !doubt.isEmpty();
  }

  /**
   * Finds a scene's judge.
   *
   * @param published the reference that comes with the product
   * @param sources formulations to make one from
   * @param uniform output times if there is no other reason
   */
  public static Judge of(
      Optional<PublishedReference> published,
      List<ReferenceMaker.Source> sources,
      ReferenceMaker maker,
      StateDistance distance,
      RunGrid uniform) {
    return of(published, maker.make(sources, times(published, uniform)), distance, uniform);
  }

  /** Returns the times a reference is to be made for: where one came with the product, its own. */
  public static double[] times(Optional<PublishedReference> published, RunGrid uniform) {
    return meeting(published).isPresent() ? published.orElseThrow().times() : uniform.times();
  }

  private static Optional<RunGrid> meeting(Optional<PublishedReference> published) {
    return published.flatMap(reference -> RunGrid.meeting(reference.times()));
  }

  /**
   * Finds a scene's judge.
   *
   * @param published the reference that comes with the product
   * @param made the codes' solution at {@link #times}
   * @param uniform output times if there is no other reason
   */
  public static Judge of(
      Optional<PublishedReference> published,
      Optional<Reference> made,
      StateDistance distance,
      RunGrid uniform) {
    Optional<RunGrid> meeting = meeting(published);
    if (meeting.isEmpty()) {
      return made.map(reference -> cut(reference, uniform)).orElseGet(() -> none(uniform));
    }
    PublishedReference given =
        made.map(reference -> published.orElseThrow().at(reference.times()))
            .orElseGet(published::orElseThrow);
    return join(given, made, distance, meeting.get());
  }

  /**
   * Takes a reference for runs that are to keep a bound: it need tell no errors far below that.
   *
   * @param made empty if no code has made one
   * @param grid output times that meet it
   */
  public static Judge ofBound(Optional<Reference> made, RunGrid grid, double bound) {
    double known = Math.max(CUT, OF_BOUND * bound);
    return made.map(reference -> cut(reference, grid, known)).orElseGet(() -> none(grid));
  }

  /** Trusts the published reference without checking it by the codes. */
  public static Judge trusting(PublishedReference published) {
    RunGrid grid = RunGrid.meeting(published.times()).orElseThrow();
    return cut(given(published), grid);
  }

  /** Returns the published reference. */
  public static Reference given(PublishedReference published) {
    return new Reference(
        published.times(),
        published.states(),
        published.floor(),
        published.floor(),
        Optional.empty(),
        List.of("Reference: the one that comes with the product. " + published.how() + "."));
  }

  private static Judge none(RunGrid grid) {
    String why = "No reference code solved the scene in its time, so errors are not known.";
    return new Judge(Optional.empty(), grid, List.of(), why);
  }

  private static Judge join(
      PublishedReference published,
      Optional<Reference> made,
      StateDistance distance,
      RunGrid grid) {
    List<String> said = new ArrayList<>();
    said.add("Reference: the one that comes with the product. " + published.how() + ".");
    double[] floor = published.floor().clone();
    Optional<double[]> amplification = made.flatMap(Reference::amplification);
    double apart = 0;
    if (made.isPresent()) {
      for (int i = 0; i < floor.length; i++) {
        apart = Math.max(apart, distance.of(made.get().states()[i], published.states()[i]));
        floor[i] = Math.max(floor[i], made.get().rounding()[i]);
      }
      said.add(
          String.format(Locale.ROOT, "The codes of this report differ from it by %.1e.", apart));
      said.addAll(made.get().sources());
    } else {
      said.add("None of the codes of this report solved the scene in its time.");
    }
    if (apart > AGREES) {
      return disagreeing(published, made.orElseThrow(), apart, grid);
    }
    List<Double> jumps = made.map(Reference::jumps).orElse(List.of());
    return cut(
        new Reference(
            published.times(), published.states(), floor, floor, amplification, jumps, said),
        grid);
  }

  /** Two codes on two formulations against one file: they are believed if they agree. */
  private static Judge disagreeing(
      PublishedReference published, Reference made, double apart, RunGrid grid) {
    boolean outlier = made.worstFloor() * OUTLIER < apart;
    String doubt =
        String.format(
            Locale.ROOT,
            outlier
                ? "The reference that comes with the product under this name differs by %.1e from"
                    + " two codes that agree to %.1e on two formulations: it belongs to another"
                    + " scene, or is wrong. Errors are those against the two codes."
                : "The reference that comes with the product differs by %.1e from the codes of"
                    + " this report, which are known to %.1e: one of them is wrong.",
            apart,
            made.worstFloor());
    Reference shipped =
        new Reference(
            published.times(),
            published.states(),
            published.floor(),
            published.floor(),
            made.amplification(),
            made.jumps(),
            List.of("Reference: the one that comes with the product. " + published.how() + "."));
    Judge kept = cut(outlier ? made : shipped, grid);
    return new Judge(kept.reference(), kept.grid(), kept.said(), doubt);
  }

  /** Keeps the times at which the reference can tell errors that matter, but two at least. */
  static Judge cut(Reference reference, RunGrid grid) {
    return cut(reference, grid, CUT);
  }

  private static Judge cut(Reference reference, RunGrid grid, double known) {
    int count = reference.times().length;
    while (count > 2 && unknownAt(reference, count - 1) > known) {
      count--;
    }
    List<String> said = new ArrayList<>(reference.sources());
    if (count < reference.times().length) {
      said.add(
          String.format(
              Locale.ROOT,
              "The interval is cut at %.4g s: at the next time the reference is known to %.1e only"
                  + "%s, and errors of %.0e could not be told.",
              reference.times()[count - 1],
              unknownAt(reference, count),
              grownTo(reference, count),
              known));
    }
    Reference kept = reference.upTo(count);
    String doubt = "";
    if (kept.worstFloor() > Math.max(USEFUL, known) || disagree(reference, known)) {
      doubt =
          String.format(
              Locale.ROOT,
              "The reference is doubtful: its codes differ by up to %.1e, more than rounding"
                  + " explains. Smaller errors mean nothing.",
              reference.worstFloor());
    } else if (!reference.isChecked()) {
      doubt =
          "The reference is doubtful: one code alone solved the scene, so what its errors are is"
              + " not known.";
    }
    RunGrid shorter = new RunGrid(grid.start(), grid.step(), grid.row(kept.end()) + 1);
    return new Judge(Optional.of(kept), shorter, said, doubt);
  }

  /** Returns the floor, or the growth of a unit in the last place of the start if that is more. */
  private static double unknownAt(Reference reference, int time) {
    double grown = reference.amplification().map(all -> all[time] * Math.ulp(1.0) / 2).orElse(0.0);
    return Math.max(reference.floor()[time], grown);
  }

  private static String grownTo(Reference reference, int time) {
    return reference
        .amplification()
        .map(all -> String.format(Locale.ROOT, " (a change of the start grows %.2g×)", all[time]))
        .orElse("");
  }

  /** Whether codes differ where they should not, by far more than a motion amplifies rounding. */
  private static boolean disagree(Reference reference, double known) {
    for (int i = 0; i < reference.floor().length; i++) {
      double explained = EXPLAINED * Math.max(reference.rounding()[i], Math.ulp(1.0));
      if (reference.floor()[i] > Math.max(known, explained)) {
        return true;
      }
    }
    return false;
  }
}
