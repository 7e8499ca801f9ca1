package org.mechservice.sim.equations.loop;

import java.util.ArrayList;
import java.util.List;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import org.mechservice.sim.equations.force.AppliedForces;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.kinematics.JointSubspace;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.sim.equations.kinematics.LinkPlaces;
import org.mechservice.sim.equations.recursion.AccelerationSweep;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.InertiaSweep;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.equations.recursion.ParentTransform;
import org.mechservice.sim.equations.recursion.VelocityRows;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.Twist;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Loop equations and accelerations of a large mechanism with few loops as programs, in the layout
 * of {@link LoopTerms.Recursive}. The number of operations grows like the number of links times the
 * square of the number of equations that pass through a link; no mass matrix is formed. Each link
 * has sections of its own, so that equal links share their code.
 */
public final class LoopRecursion {
  private final Program program = new Program();
  private final Links mechanism;
  private final Coordinates coordinates;
  private final LinkKinematics kinematics;
  private final JointSubspace subspace;
  private final ParentTransform toParent;
  private final SparseMatrix pattern;
  private final int equations;

  private LoopRecursion(Links mechanism, int equations) {
    this.mechanism = mechanism;
    this.coordinates = new Coordinates(program, mechanism);
    this.kinematics = new LinkKinematics(program, mechanism, coordinates, true);
    this.subspace = new JointSubspace(program.expressions(), coordinates);
    this.pattern = new LoopEquations(new TreeGeometry(mechanism.mechanism())).jacobian;
    this.toParent = new ParentTransform(coordinates);
    this.equations = equations;
  }

  /**
   * Derives the program from [q; v] to Φ, Φ' and the elements of J.
   *
   * @param equations number of equations of the loops, all between two bodies
   */
  public static Program loops(Links mechanism, int equations) {
    LoopRecursion code = new LoopRecursion(mechanism, equations);
    code.putOutLoops(code.rows(Optional.empty()));
    return code.program;
  }

  /**
   * Derives the program from [q; v] to the accelerations; guards return results of forces, or any
   * result if an equation or a joint is singular.
   *
   * @param equations number of equations of the loops, all between two bodies
   * @return a program without outputs if a joint of the open tree never moves an inertia
   */
  public static Program accelerations(Links mechanism, int equations) {
    LoopRecursion code = new LoopRecursion(mechanism, equations);
    code.putOutAccelerations();
    return code.program;
  }

  private List<LoopRows.Between> rows(Optional<ForceSweep> sweep) {
    VelocityRows none = new VelocityRows(program.expressions(), mechanism, coordinates);
    return new LoopRows(program, mechanism, coordinates, kinematics, none, sweep).between();
  }

  private void putOutLoops(List<LoopRows.Between> rows) {
    Scalar[] rate = new Scalar[equations];
    program.section("Residuals of the loops.", "loops");
    List<NavigableMap<Integer, Scalar>> sides = new ArrayList<>();
    mechanism.links().forEach(link -> sides.add(new TreeMap<>()));
    Scalar one = program.expressions().one();
    for (int row = 0; row < equations; row++) {
      put(row, rows.get(row).row().value());
      rate[row] = rows.get(row).row().rate();
      for (int link : rows.get(row).frames().way1()) {
        sides.get(link).put(row, one.negated());
      }
      for (int link : rows.get(row).frames().way2()) {
        sides.get(link).put(row, one);
      }
    }
    for (int i = 0; i < sides.size(); i++) {
      if (!sides.get(i).isEmpty()) {
        Link link = mechanism.links().get(i);
        program.section(
            "Rows: " + link.title() + ".\nJ = s.(m + (p - r) x f), Phi' += J v", link.bodyLabel());
        int index = i;
        sides.get(i).forEach((row, side) -> putOutRow(row, rows.get(row), index, side, rate));
      }
    }
    program.section("Rates of the loops.", "rates");
    for (int row = 0; row < equations; row++) {
      put(equations + row, rate[row]);
    }
  }

  /** Outputs the elements of J at a link, and adds them times the velocities to the rate. */
  private void putOutRow(
      int row, LoopRows.Between equation, int index, Scalar side, Scalar[] rate) {
    Link link = mechanism.links().get(index);
    LinkPlaces.Place place = kinematics.place(equation.meets(), index);
    ScalarVector force = equation.frames().inAncestor(equation.byShift());
    ScalarVector lever = equation.frames().point2().minus(place.origin());
    Wrench wrench =
        new Wrench(equation.frames().inAncestor(equation.byTurn()).plus(lever.cross(force)), force);
    List<Twist> motions = subspace.of(link);
    List<Scalar> velocities = velocities(link);
    for (int k = 0; k < motions.size(); k++) {
      Twist inAncestor =
          new Twist(
              place.axes().times(motions.get(k).angular()),
              place.axes().times(motions.get(k).linear()));
      Scalar element = inAncestor.dot(wrench).times(side);
      rate[row] = rate[row].plus(element.times(velocities.get(k)));
      if (!link.isDriven()) {
        int column = link.velocity() - mechanism.positionCount() + k;
        put(LoopTerms.Recursive.elementAt(equations) + pattern.elementAt(row, column), element);
      }
    }
  }

  /** Returns the velocities of a link, in the order of its subspace. */
  private List<Scalar> velocities(Link link) {
    return link.isBall()
        ? coordinates.ballVelocity(link).components()
        : List.of(coordinates.velocity(link));
  }

  private void put(int index, Scalar value) {
    if (!value.isZero()) {
      program.output(index, value);
    }
  }

  private void putOutAccelerations() {
    ForceSweep motion = new ForceSweep(program, mechanism, coordinates);
    Wrench[] needed = motion.sweep();
    Loads loads = new AppliedForces(program, mechanism, coordinates).loads(true);
    for (int i = 0; i < needed.length; i++) {
      needed[i] = needed[i].minus(loads.on(i));
    }
    LoopMultipliers multipliers =
        new LoopMultipliers(program, mechanism, toParent, rows(Optional.of(motion)));
    InertiaSweep inertias =
        new InertiaSweep(program, mechanism, coordinates, needed, loads, multipliers, true);
    if (!inertias.sweep()) {
      return;
    }
    multipliers.solve();
    int shift = -mechanism.positionCount();
    new AccelerationSweep(program, mechanism, coordinates, inertias, multipliers, shift, true)
        .sweep();
  }
}
