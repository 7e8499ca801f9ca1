package org.mechservice.sim.equations.loop;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.NavigableMap;
import java.util.TreeMap;
import org.mechservice.sim.equations.recursion.CarriedEquations;
import org.mechservice.sim.equations.recursion.InertiaSweep;
import org.mechservice.sim.equations.recursion.ParentTransform;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.DegreeOfFreedom;
import org.mechservice.solver.step.LinkStep;
import org.mechservice.solver.step.LinkStep.Coupled;
import org.mechservice.solver.step.LinkStep.Elimination;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Multipliers of loop equations J x + γ = 0 by elimination along the tree: each equation is carried
 * inwards and eliminated in the link in which the ways of its bodies meet, or in the root (Popov
 * and Vereshchagin 1978; Sathya and Carpentier 2024). The solver's {@link
 * org.mechservice.solver.closure.ArticulatedLoops} does the same from data.
 *
 * <p>With K the wrench of a unit multiplier as a link feels it, κ = Sᵀ K, r the known part of the
 * equation: K −= U κ / D, Λ += κ κᵀ / D, r += κ u / D for each freedom of a joint; then
 *
 * <pre>
 * Iᴬ += K Kᵀ / Λ, p += K r / Λ, and by L = Λ_oe / Λ_ee: K_o −= L K_e, r_o −= L r_e   where e is eliminated
 * μ_e = −(r_e + K_e·A) / Λ_ee − Σ L μ_o                                              outwards
 * </pre>
 */
final class LoopMultipliers implements CarriedEquations {
  /**
   * Part of the sum of its terms below which a pivot is rounding, as in the data-driven factors.
   */
  private static final double SINGULAR = 64 * 0x1p-52;

  /** Result of a program if an equation depends on others at the state. */
  static final int LOCKED = 0;

  private final Program program;
  private final Expressions expressions;
  private final ParentTransform toParent;

  /** Equations in the order of elimination: outermost meeting links first. */
  private final List<LoopRows.Between> rows;

  /** K of each link, by place. */
  private final List<NavigableMap<Integer, Wrench>> carried;

  /** κ / D of each link and freedom, by place. */
  private final List<List<NavigableMap<Integer, Scalar>>> push = new ArrayList<>();

  /** Λ by place, then by later places; its diagonal; the same without subtractions. */
  private final List<NavigableMap<Integer, Scalar>> later = new ArrayList<>();

  private final Scalar[] pivot;
  private final Scalar[] whole;

  /** r, then μ. */
  private final Scalar[] right;

  LoopMultipliers(
      Program program, Links mechanism, ParentTransform toParent, List<LoopRows.Between> rows) {
    this.program = program;
    this.expressions = program.expressions();
    this.toParent = toParent;
    this.rows =
        rows.stream().sorted(Comparator.comparing((LoopRows.Between row) -> -row.meets())).toList();
    carried = wrenches(mechanism, this.rows);
    mechanism.links().forEach(link -> push.add(new ArrayList<>()));
    pivot = new Scalar[rows.size()];
    whole = new Scalar[rows.size()];
    right = new Scalar[rows.size()];
    for (int place = 0; place < pivot.length; place++) {
      pivot[place] = expressions.zero();
      whole[place] = expressions.zero();
      right[place] = this.rows.get(place).row().offset();
      later.add(new TreeMap<>());
    }
  }

  /** Returns for each link the wrenches of unit multipliers, by their places in a list. */
  static List<NavigableMap<Integer, Wrench>> wrenches(
      Links mechanism, List<LoopRows.Between> rows) {
    List<NavigableMap<Integer, Wrench>> wrenches = new ArrayList<>();
    mechanism.links().forEach(link -> wrenches.add(new TreeMap<>()));
    for (int place = 0; place < rows.size(); place++) {
      for (int link : rows.get(place).frames().links()) {
        wrenches.get(link).put(place, rows.get(place).loads().on(link));
      }
    }
    return wrenches;
  }

  private boolean meetsIn(int place, int link) {
    return rows.get(place).meets() == link;
  }

  private void addLater(int place, int after, Scalar element) {
    if (!element.isZero()) {
      later.get(place).merge(after, element, Scalar::plus);
    }
  }

  @Override
  public void enter(int link, InertiaSweep sweep) {
    NavigableMap<Integer, Wrench> here = carried.get(link);
    for (int place = 0; place < pivot.length; place++) {
      Wrench own = here.get(place);
      if (own == null || !meetsIn(place, link)) {
        continue;
      }
      Scalar reciprocal = eliminate(place);
      later
          .get(place)
          .forEach(
              (after, factor) ->
                  here.computeIfPresent(after, (key, k) -> k.minus(own.times(factor))));
      sweep.add(link, own, reciprocal, right[place]);
    }
  }

  /** Replaces the later elements of Λ by L, and subtracts from those after; returns 1 / Λ. */
  private Scalar eliminate(int place) {
    program.guard(
        new Program.Guard(
            program.named("Lambda_" + place, pivot[place]),
            whole[place].times(SINGULAR),
            LOCKED,
            "a loop equation depends on others"));
    Scalar reciprocal =
        program.named("one_over_Lambda_" + place, expressions.one().over(pivot[place]));
    NavigableMap<Integer, Scalar> elements = later.get(place);
    elements.forEach(
        (after, element) -> {
          Scalar factor = element.times(reciprocal);
          pivot[after] = pivot[after].minus(factor.times(element));
          right[after] = right[after].minus(factor.times(right[place]));
          elements
              .tailMap(after, false)
              .forEach((next, other) -> addLater(after, next, factor.times(other).negated()));
        });
    elements.replaceAll((after, element) -> element.times(reciprocal));
    return reciprocal;
  }

  @Override
  public void eliminate(int link, DegreeOfFreedom freedom, Elimination of) {
    NavigableMap<Integer, Coupled> along = new TreeMap<>();
    NavigableMap<Integer, Scalar> pushed = new TreeMap<>();
    carried
        .get(link)
        .forEach(
            (place, k) -> {
              Coupled coupled = LinkStep.couple(freedom, of.share(), k, expressions.zero());
              if (!meetsIn(place, link) && !coupled.along().isZero()) {
                along.put(place, coupled);
                pushed.put(place, coupled.along().times(of.reciprocal()));
              }
            });
    push.get(link).add(pushed);
    along.forEach(
        (place, coupled) -> {
          Scalar moved = coupled.along();
          Scalar share = pushed.getOrDefault(place, expressions.zero());
          Scalar part = moved.times(share);
          pivot[place] = pivot[place].plus(part);
          whole[place] = whole[place].plus(part);
          right[place] = right[place].plus(moved.times(of.rate()));
          along
              .tailMap(place, false)
              .forEach((after, other) -> addLater(place, after, other.along().times(share)));
          carried.get(link).put(place, coupled.rest());
        });
  }

  @Override
  public void pass(int index, Link link) {
    NavigableMap<Integer, Wrench> parent = carried.get(link.parent());
    carried
        .get(index)
        .forEach(
            (place, k) -> {
              if (!meetsIn(place, index)) {
                parent.merge(place, toParent.wrench(link, k), Wrench::plus);
              }
            });
  }

  @Override
  public void solve() {
    program.section("Equations that meet in the root.", "root");
    for (int place = 0; place < pivot.length; place++) {
      if (meetsIn(place, Links.ROOT)) {
        eliminate(place);
      }
    }
    for (int place = pivot.length - 1; place >= 0; place--) {
      if (meetsIn(place, Links.ROOT)) {
        right[place] = multiplier(place, right[place]);
      }
    }
  }

  private Scalar multiplier(int place, Scalar known) {
    Scalar sum = known.over(pivot[place]).negated();
    for (var factor : later.get(place).entrySet()) {
      sum = sum.minus(factor.getValue().times(right[factor.getKey()]));
    }
    return program.named("mu_" + place, sum);
  }

  @Override
  public Scalar push(int link, int freedom, Scalar rate) {
    Scalar sum = rate;
    for (var factor : push.get(link).get(freedom).entrySet()) {
      sum = sum.plus(factor.getValue().times(right[factor.getKey()]));
    }
    return sum;
  }

  @Override
  public void moved(int link, ScalarVector alpha, ScalarVector acceleration) {
    NavigableMap<Integer, Wrench> here = carried.get(link);
    for (int place = pivot.length - 1; place >= 0; place--) {
      Wrench k = here.get(place);
      if (k != null && meetsIn(place, link)) {
        Scalar felt = k.moment().dot(alpha).plus(k.force().dot(acceleration));
        right[place] = multiplier(place, right[place].plus(felt));
      }
    }
  }
}
