package org.mechservice.sim.equations.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.mechservice.sim.equations.coordinates.RelativeFrameMotion;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.force.law.PairLoad;
import org.mechservice.solver.force.law.PairLoad.Direction;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/** Loads between two frames, summed up: one, or those of a contact at each of its curves. */
final class PairTerm implements ForceTerm {
  private final RelativeFrameMotion frames;
  private final List<PairLoad> loads;

  PairTerm(RelativeFrameMotion frames, List<PairLoad> loads) {
    this.frames = frames;
    this.loads = List.copyOf(loads);
  }

  private Scalar sum(Function<PairLoad, Scalar> part) {
    return loads.stream().map(part).reduce(Scalar::plus).orElseThrow();
  }

  /** {@inheritDoc} One of several loads always has one. */
  @Override
  public Optional<Direction> direction() {
    return loads.get(0).direction();
  }

  @Override
  public void apply(Loads sum) {
    loads.forEach(load -> frames.addWrench(load.force(), load.moment(), sum));
  }

  @Override
  public Scalar potential() {
    return sum(PairLoad::potential);
  }

  @Override
  public Scalar power() {
    return sum(PairLoad::power);
  }

  /** {@inheritDoc} Of several loads, the largest of the first values and sums of the others. */
  @Override
  public List<Scalar> values() {
    if (loads.size() == 1) {
      return loads.get(0).values();
    }
    List<Scalar> values = new ArrayList<>();
    for (int i = 0; i < loads.get(0).values().size(); i++) {
      int value = i;
      values.add(i == 0 ? largest() : sum(load -> load.values().get(value)));
    }
    return values;
  }

  private Scalar largest() {
    return loads.stream()
        .map(load -> load.values().get(0))
        .reduce((a, b) -> a.expressions().function(MathFunction.MAX, a, b))
        .orElseThrow();
  }
}
