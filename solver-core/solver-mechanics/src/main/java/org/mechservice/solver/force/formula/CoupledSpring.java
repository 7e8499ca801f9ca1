package org.mechservice.solver.force.formula;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntConsumer;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.PointPosition;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.force.applied.GradientSink;
import org.mechservice.solver.force.applied.NoJacobian;
import org.mechservice.solver.force.applied.OuterProduct;
import org.mechservice.solver.force.applied.ScalarLaw;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.force.ForceElement;

/**
 * A force F(x, x′) along a formula x of positions l: the loads F s ∇l with the slopes s = ∂x/∂l.
 * With the second derivatives H = ∂s/∂l, r the rates of the positions, and F_x, F_v the derivatives
 * of the law, the loads change by
 *
 * <pre>
 * Σ_l ∇l [ s_l Σ_m ((F_x s_m + F_v (H r)_m) δm + F_v s_m δm′) + F Σ_m H_lm δm ] + F s_l δ(∇l)
 * </pre>
 */
public final class CoupledSpring extends AppliedForce {
  private final ScalarLaw law;
  private final FormulaEvaluation formula;
  private final double[] parameters;

  /** Positions, and their rates; of what has none, the position itself stands there. */
  private final LeafInput[] positions;

  private final LeafInput[] rates;
  private final boolean[] moves;
  private final int time;

  private final double[] slope;
  private final double[] rate;
  private final double[] slopeRate;
  private final double[] unit;
  private final double[] bend;
  private final double[] held = new double[6];
  private final OuterProduct product = new OuterProduct(NoJacobian.INSTANCE);
  private final LoadSink loads = new LoadSink();
  private final SlopeSink slopes = new SlopeSink();
  private final Gradients ofPositions;
  private final Gradients ofRates;
  private final Sum sum;
  private final double[] byState = new double[2];
  private double position;
  private double velocity;
  private double force;

  /**
   * @param element the force
   * @param along x
   * @param law F
   */
  public CoupledSpring(ForceElement element, Expression along, TreeMotion motion, ScalarLaw law) {
    super(element);
    this.law = law;
    Mechanism mechanism = motion.tree().mechanism();
    formula = new FormulaEvaluation(List.of(along));
    parameters = mechanism.parameters().stream().mapToDouble(Parameter::value).toArray();
    List<Expression> leaves = formula.leaves();
    int count = leaves.size();
    positions = new LeafInput[count];
    rates = new LeafInput[count];
    moves = new boolean[count];
    time = leaves.indexOf(new Time());
    for (int i = 0; i < count; i++) {
      Expression leaf = leaves.get(i);
      positions[i] = LeafInput.of(leaf, motion, parameters);
      moves[i] = leaf instanceof CoordinatePosition || leaf instanceof PointPosition;
      rates[i] = moves[i] ? LeafInput.of(mechanism.rateOf(leaf), motion, parameters) : positions[i];
    }
    ofPositions = new Gradients(count);
    ofRates = new Gradients(count);
    sum = new Sum(motion.tree().linkCount, motion.tree().velocityCount);
    slope = new double[count];
    rate = new double[count];
    slopeRate = new double[count];
    unit = new double[count];
    bend = new double[count];
  }

  @Override
  public boolean parameters(double[] values) {
    System.arraycopy(values, 0, parameters, 0, parameters.length);
    return law.parameters(values, this);
  }

  @Override
  public boolean apply(double t, double[] wrench, double[] tau) {
    for (int i = 0; i < positions.length; i++) {
      formula.setLeaf(i, positions[i].value(t));
    }
    formula.derivatives();
    formula.gradient(0, slope);
    position = formula.value(0);
    velocity = 0;
    for (int i = 0; i < positions.length; i++) {
      rate[i] = moves[i] ? rates[i].value(t) : i == time ? 1 : 0;
      velocity += slope[i] * rate[i];
    }
    law.at(t);
    force = law.force(position, velocity);
    if (!Double.isFinite(force)) {
      return notFinite("force along the coupling", force);
    }
    for (int i = 0; i < positions.length; i++) {
      loads.to(wrench, tau, force * slope[i]);
      positions[i].gradient(loads);
    }
    return true;
  }

  @Override
  public boolean linearise(double t, ForceJacobian sink) {
    law.slopes(byState);
    formula.gradientChange(0, rate, slopeRate);
    product.to(sink);
    keepGradients();
    for (int l = 0; l < positions.length; l++) {
      double sum = slope[l] * (byState[0] + byState[1]) + slopeRate[l];
      if (!Double.isFinite(sum)) {
        return notFinite("derivative", sum);
      }
      unit[l] = 1;
      formula.gradientChange(0, unit, bend);
      unit[l] = 0;
      slopes.leaf = l;
      positions[l].gradient(slopes);
      positions[l].addCurvature(force * slope[l], sink);
    }
    return true;
  }

  private void keepGradients() {
    ofPositions.clear();
    ofRates.clear();
    for (int m = 0; m < positions.length; m++) {
      ofPositions.begins(m);
      positions[m].gradient(ofPositions);
      ofRates.begins(m);
      if (moves[m]) {
        rates[m].gradient(ofRates);
      }
    }
    ofPositions.begins(positions.length);
    ofRates.begins(positions.length);
  }

  @Override
  public void addByState(int state, double[] wrench, double[] tau) {
    double change = law.byState(state);
    for (int i = 0; i < positions.length && change != 0; i++) {
      loads.to(wrench, tau, change * slope[i]);
      positions[i].gradient(loads);
    }
  }

  /** Returns the derivative of the load along a position by a position. */
  private double byPosition(int on, int by) {
    double change = byState[0] * slope[by] + byState[1] * slopeRate[by];
    return slope[on] * change + force * bend[by];
  }

  /** Returns the derivative of the load along a position by the rate of a position. */
  private double byRate(int on, int by) {
    return slope[on] * byState[1] * slope[by];
  }

  @Override
  public double potentialEnergy() {
    return law.potentialEnergy();
  }

  @Override
  public double power() {
    double byTime = time < 0 ? 0 : slope[time];
    return law.power() - force * byTime;
  }

  @Override
  public void values(double[] out, int at) {
    out[at] = position;
    out[at + 1] = velocity;
    out[at + 2] = -force;
  }

  @Override
  public void accepted() {
    for (LeafInput input : positions) {
      input.accepted();
    }
  }

  @Override
  public void couplings(Couplings couplings) {
    for (LeafInput on : positions) {
      IntConsumer taker =
          link -> {
            for (LeafInput by : positions) {
              by.links(other -> couplings.couple(link, other));
            }
          };
      on.links(taker);
    }
  }

  /** Adds a force along a position to the loads. */
  private static final class LoadSink implements GradientSink {
    private double[] wrench = new double[0];
    private double[] tau = new double[0];
    private double force;

    void to(double[] wrench, double[] tau, double force) {
      this.wrench = wrench;
      this.tau = tau;
      this.force = force;
    }

    @Override
    public void byLink(int link, double[] byPlace, double[] byVelocity) {
      for (int i = 0; i < 6; i++) {
        wrench[6 * link + i] += force * byPlace[i];
      }
    }

    @Override
    public void byCoordinate(int coordinate, double byPlace, double byVelocity) {
      tau[coordinate] += force * byPlace;
    }
  }

  /**
   * The gradients of the positions and rates, kept while the pairs of them are added up: each is
   * six numbers of a link, or one of a coordinate.
   */
  private static final class Gradients implements GradientSink {
    private static final int SIZE = 12;

    private final int[] begin;
    private int[] target = new int[8];
    private double[] numbers = new double[8 * SIZE];
    private int count;

    Gradients(int leaves) {
      begin = new int[leaves + 1];
    }

    void clear() {
      count = 0;
    }

    void begins(int leaf) {
      begin[leaf] = count;
    }

    private int added(int ofTarget) {
      if (count == target.length) {
        target = Arrays.copyOf(target, 2 * count);
        numbers = Arrays.copyOf(numbers, 2 * count * SIZE);
      }
      target[count] = ofTarget;
      Arrays.fill(numbers, count * SIZE, (count + 1) * SIZE, 0);
      return SIZE * count++;
    }

    @Override
    public void byLink(int link, double[] byPlace, double[] byVelocity) {
      int at = added(link);
      System.arraycopy(byPlace, 0, numbers, at, 6);
      System.arraycopy(byVelocity, 0, numbers, at + 6, 6);
    }

    @Override
    public void byCoordinate(int coordinate, double byPlace, double byVelocity) {
      int at = added(-1 - coordinate);
      numbers[at] = byPlace;
      numbers[at + 6] = byVelocity;
    }
  }

  /** Sums of gradients, by link and by coordinate; passes them on once. */
  private static final class Sum {
    private final double[] sums;
    private final boolean[] touched;
    private final int links;
    private final int[] list;
    private int count;
    private final double[] place = new double[6];
    private final double[] velocity = new double[6];

    Sum(int links, int coordinates) {
      this.links = links;
      sums = new double[Gradients.SIZE * (links + coordinates)];
      touched = new boolean[links + coordinates];
      list = new int[links + coordinates];
    }

    void add(Gradients gradients, int leaf, double factor) {
      for (int k = gradients.begin[leaf]; k < gradients.begin[leaf + 1] && factor != 0; k++) {
        int target = gradients.target[k];
        int slot = target >= 0 ? target : links - 1 - target;
        if (!touched[slot]) {
          touched[slot] = true;
          list[count++] = slot;
          Arrays.fill(sums, Gradients.SIZE * slot, Gradients.SIZE * (slot + 1), 0);
        }
        for (int i = 0; i < Gradients.SIZE; i++) {
          sums[Gradients.SIZE * slot + i] += factor * gradients.numbers[Gradients.SIZE * k + i];
        }
      }
    }

    /** Passes the sums on and is empty again. */
    void to(GradientSink sink) {
      for (int k = 0; k < count; k++) {
        int slot = list[k];
        int at = Gradients.SIZE * slot;
        touched[slot] = false;
        if (slot >= links) {
          sink.byCoordinate(slot - links, sums[at], sums[at + 6]);
        } else {
          System.arraycopy(sums, at, place, 0, 6);
          System.arraycopy(sums, at + 6, velocity, 0, 6);
          sink.byLink(slot, place, velocity);
        }
      }
      count = 0;
    }
  }

  /** Adds the derivatives of the loads along one position by all positions. */
  private final class SlopeSink implements GradientSink {
    private int leaf;

    private void sum() {
      for (int m = 0; m < positions.length; m++) {
        sum.add(ofPositions, m, byPosition(leaf, m));
        if (moves[m]) {
          sum.add(ofRates, m, byRate(leaf, m));
        }
      }
    }

    @Override
    public void byLink(int link, double[] byPlace, double[] byVelocity) {
      System.arraycopy(byPlace, 0, held, 0, 6);
      sum();
      product.wrench(link, held, 1);
      sum.to(product);
    }

    @Override
    public void byCoordinate(int coordinate, double byPlace, double byVelocity) {
      sum();
      product.force(coordinate, byPlace);
      sum.to(product);
    }
  }
}
