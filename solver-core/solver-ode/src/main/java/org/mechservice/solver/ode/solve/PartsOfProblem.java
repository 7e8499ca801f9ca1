package org.mechservice.solver.ode.solve;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.solver.linear.BandLayout;
import org.mechservice.solver.linear.BlockLayout;
import org.mechservice.solver.linear.DenseLayout;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.BlockSystem;
import org.mechservice.solver.ode.CompletedSystem;
import org.mechservice.solver.ode.ErrorWeightGroups;
import org.mechservice.solver.ode.PiecewiseSystem;
import org.mechservice.solver.ode.ProjectedSystem;
import org.mechservice.solver.ode.SavedSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.SystemParts;
import org.mechservice.solver.ode.UnitNormGroups;

/**
 * Parts of a problem that are given one by one; they take precedence over those of the wrapped
 * system. Immutable.
 */
final class PartsOfProblem implements SystemParts {
  /** The parts that integrators ask every problem for. */
  private static final List<Class<?>> KINDS =
      List.of(
          BandedSystem.class,
          BlockSystem.class,
          SparseSystem.class,
          PiecewiseSystem.class,
          CompletedSystem.class,
          ProjectedSystem.class,
          ErrorWeightGroups.class,
          UnitNormGroups.class,
          SavedSystem.class);

  static final PartsOfProblem NONE =
      new PartsOfProblem(
          new SystemParts() {
            @Override
            public <T> Optional<T> part(Class<T> kind) {
              return Optional.empty();
            }
          },
          Map.of());

  private final SystemParts others;
  private final Map<Class<?>, Object> own;

  private PartsOfProblem(SystemParts others, Map<Class<?>, Object> own) {
    this.others = others;
    this.own = own;
  }

  static PartsOfProblem of(SystemParts system) {
    return new PartsOfProblem(system, Map.of());
  }

  @Override
  public <T> Optional<T> part(Class<T> kind) {
    Object given = own.get(kind);
    return given == null ? others.part(kind) : Optional.of(kind.cast(given));
  }

  <T> PartsOfProblem with(Class<T> kind, T part) {
    Map<Class<?>, Object> more = new HashMap<>(own);
    more.put(kind, part);
    if (part instanceof UnitNormGroups groups && kind == UnitNormGroups.class) {
      more.put(ErrorWeightGroups.class, groups);
    }
    return new PartsOfProblem(others, Map.copyOf(more));
  }

  /**
   * Requires a kind of part that integrators ask for.
   *
   * @param further kinds, of one form of problem
   * @throws IllegalArgumentException if it is another
   */
  static void requireKind(Class<?> kind, List<Class<?>> further) {
    if (!KINDS.contains(kind) && !further.contains(kind)) {
      String known =
          Stream.concat(KINDS.stream(), further.stream())
              .map(Class::getSimpleName)
              .sorted()
              .collect(Collectors.joining(", "));
      throw new IllegalArgumentException(
          "no integrator asks this problem for a part of kind "
              + kind.getSimpleName()
              + "; the kinds are "
              + known);
    }
  }

  PartsOfProblem without(Class<?> kind) {
    Map<Class<?>, Object> fewer = new HashMap<>(own);
    fewer.remove(kind);
    return new PartsOfProblem(others, Map.copyOf(fewer));
  }

  PartsOfProblem withBand(int dimension, int lower, int upper) {
    return with(BandedSystem.class, new Band(new BandLayout(dimension, lower, upper)));
  }

  PartsOfProblem withPattern(SparseSystem pattern) {
    return with(SparseSystem.class, pattern);
  }

  PartsOfProblem withBreakpoints(double... places) {
    List<Double> all = Arrays.stream(places).boxed().toList();
    return with(PiecewiseSystem.class, () -> all);
  }

  /**
   * Returns how a matrix of derivatives is stored: as a band or in blocks if declared so, else
   * full.
   */
  static MatrixLayout layout(SystemParts parts, int dimension) {
    Optional<BandedSystem> band = parts.part(BandedSystem.class);
    if (band.isPresent()) {
      return new BandLayout(dimension, band.get().lowerBandwidth(), band.get().upperBandwidth());
    }
    return parts
        .part(BlockSystem.class)
        .<MatrixLayout>map(blocks -> new BlockLayout(dimension, blocks.blockSize()))
        .orElseGet(() -> new DenseLayout(dimension));
  }

  /** A band that was declared. */
  private record Band(BandLayout layout) implements BandedSystem {
    @Override
    public int lowerBandwidth() {
      return layout.lower();
    }

    @Override
    public int upperBandwidth() {
      return layout.upper();
    }
  }
}
