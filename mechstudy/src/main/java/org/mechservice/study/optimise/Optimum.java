package org.mechservice.study.optimise;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The result of an optimisation.
 *
 * @param problem what was asked
 * @param method the method that each start used
 * @param starts one for each start, in order
 * @param best the best point of all; not feasible if none is
 * @param promise by how much linear models of the aims and of all rows of extremes would lower the
 *     objective within 1e-3 of the variables' ranges, relative to its size: next to nothing at a
 *     local optimum; empty if there are no such models
 */
public record Optimum(
    DesignProblem problem, Method method, List<Start> starts, Trial best, OptionalDouble promise) {
  /** Part of a variable's range within which it counts as at its bound. */
  private static final double AT_BOUND = 1e-6;

  /**
   * Promise that counts as nothing; differences of runs at usual tolerances have errors of 1e-5.
   */
  private static final double OPTIMAL = 1e-4;

  /** Scaled size of a constraint that counts as zero. */
  private static final double ACTIVE = 1e-4;

  public Optimum {
    starts = List.copyOf(starts);
  }

  /**
   * One start.
   *
   * @param trials its points in order; none is left out
   * @param ended why it ended before its method was done; empty if it was done
   */
  public record Start(List<Trial> trials, Optional<String> ended) {
    public Start {
      trials = List.copyOf(trials);
    }

    /** Returns the best point; empty if there is none. */
    public Optional<Trial> best() {
      Optional<Trial> best = Optional.empty();
      for (Trial trial : trials) {
        if (best.isEmpty() || trial.isBetterThan(best.get())) {
          best = Optional.of(trial);
        }
      }
      return best;
    }
  }

  /** Returns whether the best point is a local optimum by the promise; empty if that is unknown. */
  public Optional<Boolean> isLocal() {
    return promise.isEmpty()
        ? Optional.empty()
        : Optional.of(best.isFeasible() && promise.getAsDouble() <= OPTIMAL);
  }

  /** Returns the points of all starts. */
  public List<Trial> history() {
    List<Trial> all = new ArrayList<>();
    starts.forEach(start -> all.addAll(start.trials()));
    return all;
  }

  /** Returns how many runs were made. */
  public int runs() {
    return history().size();
  }

  /** Returns how many of them failed. */
  public int failures() {
    return (int) history().stream().filter(trial -> trial.failure().isPresent()).count();
  }

  /** Returns which bound a variable is at: -1 the lower, 1 the upper, 0 none. */
  public int bound(int variable) {
    double part = problem.variables().get(variable).part(best.point()[variable]);
    return part <= AT_BOUND ? -1 : part >= 1 - AT_BOUND ? 1 : 0;
  }

  /** Returns whether a constraint holds with equality, within 1e-4 of its size. */
  public boolean isActive(int aim) {
    return problem.aims().get(aim).isConstraint() && scaled(aim) >= -ACTIVE;
  }

  /** Returns whether a constraint does not hold. */
  public boolean isViolated(int aim) {
    return switch (problem.aims().get(aim).kind()) {
      case AT_MOST_ZERO -> scaled(aim) > Trial.FEASIBLE;
      case ZERO -> Math.abs(scaled(aim)) > Trial.FEASIBLE;
      case MINIMISE, RESIDUAL -> false;
    };
  }

  private double scaled(int aim) {
    double scale = problem.aims().get(aim).scale();
    return best.values()[aim] / (scale == 0 ? startScale(aim) : scale);
  }

  /** As {@link Trials} scales it: by its size at the first point of the start. */
  private double startScale(int aim) {
    double first =
        starts.get(best.start() - 1).trials().stream()
            .filter(trial -> trial.failure().isEmpty())
            .mapToDouble(trial -> Math.abs(trial.values()[aim]))
            .findFirst()
            .orElse(1);
    return first == 0 ? 1 : first;
  }
}
