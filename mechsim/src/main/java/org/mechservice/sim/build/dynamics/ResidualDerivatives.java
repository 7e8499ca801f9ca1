package org.mechservice.sim.build.dynamics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarVector;
import org.mechservice.solver.closure.CountedAngles;

/**
 * The derivatives of the residual M v' + b − τ of an open chain by v', v and q (RR-JF, NUMERICS
 * §2), each between a joint and those on its way to the root, O(n · depth): with Iᶜ, 2Bᶜ and fᶜ of
 * a link with all beyond it, for j on the way from k to the root (Singh, Russell and Wensing 2022;
 * Carpentier and Mansard 2018),
 *
 * <pre>
 * M_jk = S_jᵀ Iᶜ S_k
 * ∂F_j/∂v_k = S_jᵀ (2Bᶜ S_k + Iᶜ (ψ'_k + S'_k))      ∂F_k/∂v_j = S_kᵀ (2Bᶜ S_j + Iᶜ (ψ'_j + S'_j))
 * ∂F_j/∂q_k = S_jᵀ (2Bᶜ ψ'_k + Iᶜ ψ''_k + S_k ×* fᶜ)  ∂F_k/∂q_j = S_kᵀ (2Bᶜ ψ'_j + Iᶜ ψ''_j)
 * </pre>
 *
 * <p>These hold for columns fixed in the moving link. Those of a ball whose velocity is given in
 * the axes of its parent turn against the link: ∂F/∂q of its three columns gets ∂F/∂v [ω]× + M
 * [ω']×, its own rows less [Sᵀ fᶜ]×.
 *
 * <p>Where loops are closed, Jᵀ λ is a force like others, and so is what a rod needs at one end
 * because the other accelerates: how they change is differentiated with the applied forces.
 */
public final class ResidualDerivatives {
  /**
   * The derivatives as a program.
   *
   * @param program from the state, followed by its derivative, to the elements in the order of
   *     {@link org.mechservice.solver.dynamics.TreeStepModel}
   * @param tree velocity and parent of each place, as text
   * @param coupled places of elements beyond those of the tree, as text
   */
  public record Derived(Program program, String tree, String coupled) {}

  private final Program program = new Program();
  private final Expressions expressions = program.expressions();
  private final Links mechanism;
  private final Coordinates coordinates;
  private final TreePlaces places;
  private final ToParent toParent;

  /** What rods between bodies add to M, by velocities of the state. */
  private final Scalar[][] massOfRods;

  /**
   * @param derivative where inputs of accelerations begin, as {@link Coordinates} counts them
   */
  private ResidualDerivatives(Links mechanism, int derivative) {
    this.mechanism = mechanism;
    coordinates = new Coordinates(program, mechanism, derivative);
    places = new TreePlaces(mechanism);
    toParent = new ToParent(expressions, coordinates);
    massOfRods = new Scalar[mechanism.velocityCount()][mechanism.velocityCount()];
    for (Scalar[] row : massOfRods) {
      Arrays.fill(row, expressions.zero());
    }
  }

  /** Derives the program of an open chain. */
  public static Derived derive(Links mechanism) {
    int states = mechanism.positionCount() + mechanism.velocityCount();
    ResidualDerivatives tree = new ResidualDerivatives(mechanism, states);
    List<Integer> coupled = new ArrayList<>();
    tree.derive(
        (sweep, kinematics, loads) -> {},
        slopes -> {
          coupled.addAll(slopes.coupled());
          return new ElementPlaces.OfTree(tree.places.pattern(coupled));
        });
    String text = coupled.stream().map(String::valueOf).collect(Collectors.joining(" "));
    return new Derived(tree.program, tree.places.text(), text);
  }

  /**
   * Derives the program of a mechanism with loops: from [q; v], followed by counted angles, v' and
   * λ, to the derivatives of M v' + b − τ + Jᵀ λ in the order of {@link
   * org.mechservice.solver.closure.LoopTerms.OfDerivatives}.
   */
  public static Program ofLoops(Links mechanism) {
    // accelerations count like velocities, which come after the positions
    int accelerations = mechanism.velocityCount() + counted(mechanism);
    ResidualDerivatives closed =
        new ResidualDerivatives(MassiveRodTerms.withEnds(mechanism), accelerations);
    closed.derive(closed::addLoops, slopes -> new ElementPlaces.Dense(closed.places));
    return closed.program;
  }

  private static int counted(Links mechanism) {
    return CountedAngles.of(mechanism.mechanism()).size();
  }

  /** Adds loads that depend on more than the forces of the model. */
  private interface FurtherLoads {
    void addTo(ForceSweep sweep, LinkKinematics kinematics, Loads loads);
  }

  /** Adds −Jᵀ λ, and what rods need of both their ends. */
  private void addLoops(ForceSweep sweep, LinkKinematics kinematics, Loads loads) {
    VelocityRows rows = new VelocityRows(expressions, mechanism, coordinates);
    program.section("Rods.", "rods");
    MassiveRodTerms rods = new MassiveRodTerms(expressions, mechanism, kinematics, rows);
    ScalarVector none = ScalarVector.zero(expressions);
    Wrench[] needed = new Wrench[mechanism.links().size()];
    Arrays.fill(needed, new Wrench(none, none));
    rods.addNeeded(sweep, needed);
    for (int i = 0; i < needed.length; i++) {
      Wrench acts = needed[i].times(-1);
      loads.add(i, none, acts.force(), acts.moment());
    }
    rods.addMass(massOfRods);
    int lambda = mechanism.positionCount() + 2 * mechanism.velocityCount() + counted(mechanism);
    new LoopRows(program, mechanism, coordinates, kinematics, rows, Optional.empty())
        .addForces(row -> expressions.input(lambda + row).negated(), loads);
  }

  private void derive(FurtherLoads further, Function<ForceSlopes, ElementPlaces> placing) {
    ForceSweep sweep = new ForceSweep(program, mechanism, coordinates);
    Wrench[] forces = sweep.sweep();
    AppliedForces applied = new AppliedForces(program, mechanism, coordinates);
    Loads loads = applied.loads(true);
    further.addTo(sweep, applied.kinematics(), loads);
    for (int i = 0; i < forces.length; i++) {
      forces[i] = forces[i].minus(loads.on(i));
    }
    JointColumns columns = new JointColumns(expressions, coordinates, applied.kinematics(), sweep);
    program.section("Derivatives of the forces.", "forces");
    ForceSlopes slopes =
        new ForceSlopes(expressions, mechanism, coordinates, places, loads, columns);
    slopes.derive();
    Elements elements = new Elements(placing.apply(slopes), slopes);
    new JointSweep(program, mechanism, coordinates).sweep(forces, loads);
    RigidComposite[] composites = composites(columns);
    List<List<JointColumns.Column>> all = new ArrayList<>();
    elements.putOutBetweenBranches();
    for (int i = 0; i < forces.length; i++) {
      Link link = mechanism.links().get(i);
      program.section(
          "Derivatives: "
              + link.title()
              + ".\nM = S_j.I S_k, C = S_j.(2 B S_k + I (psi' + S')_k), K = S_j.(2 B psi'_k + I"
              + " psi''_k + S_k x* f), and back",
          link.bodyLabel());
      all.add(link.isDriven() ? List.of() : columns.of(link));
      new LinkRows(i, all, composites[i], forces[i]).derive(elements);
    }
  }

  /** Sums inwards. */
  private RigidComposite[] composites(JointColumns columns) {
    RigidComposite[] composites = new RigidComposite[mechanism.links().size()];
    for (int i = 0; i < composites.length; i++) {
      Link link = mechanism.links().get(i);
      program.section("Momentum: " + link.title() + ".", link.bodyLabel());
      composites[i] = RigidComposite.of(expressions, link, columns.velocity(i));
    }
    for (int i = composites.length - 1; i >= 0; i--) {
      Link link = mechanism.links().get(i);
      program.section(
          "Composite inertia and its change: " + link.title() + ".\nI_p += X I X', B_p += X B X'",
          link.bodyLabel());
      if (link.parent() != Links.ROOT) {
        int p = link.parent();
        composites[p] = composites[p].plus(toParent.composite(link, composites[i]));
      }
    }
    return composites;
  }

  /** Puts elements out, with what forces and rods add. */
  private final class Elements {
    private final ElementPlaces at;
    private final ForceSlopes slopes;

    Elements(ElementPlaces at, ForceSlopes slopes) {
      this.at = at;
      this.slopes = slopes;
    }

    /** Elements that neither body of which is on the way of the other. */
    void putOutBetweenBranches() {
      program.section("Derivatives of forces between branches.", "forces");
      Scalar zero = expressions.zero();
      for (int i = 0; i < places.size(); i++) {
        for (int j = 0; j < places.size(); j++) {
          if (!places.isOnWay(j, i) && !places.isOnWay(i, j)) {
            putOut(i, j, zero, zero);
            if (i > j) {
              putOutMass(i, j, zero);
            }
          }
        }
      }
    }

    void putOutMass(int row, int column, Scalar mass) {
      int i = places.get(row).velocity();
      int j = places.get(column).velocity();
      Scalar element = mass.plus(massOfRods[Math.max(i, j)][Math.min(i, j)]);
      if (!element.isZero()) {
        program.output(at.mass(row, column), element);
      }
    }

    /** Puts elements of C and K out. */
    void putOut(int row, int column, Scalar byVelocity, Scalar byPosition) {
      Scalar c = byVelocity.plus(slopes.byVelocity(row, column));
      if (!c.isZero()) {
        program.output(at.byVelocity(row, column), c);
      }
      Scalar k = byPosition.plus(slopes.byPosition(row, column));
      if (!k.isZero()) {
        program.output(at.byPosition(row, column), k);
      }
    }
  }

  /** The elements of a link's velocities with themselves and those on the way to the root. */
  private final class LinkRows {
    private final int link;
    private final List<List<JointColumns.Column>> columns;
    private final List<JointColumns.Column> own;
    private final Wrench[] inertia;
    private final Wrench[] velocity;
    private final Wrench[] position;
    private final ScalarVector[] change;
    private final Wrench force;

    LinkRows(
        int link, List<List<JointColumns.Column>> columns, RigidComposite composite, Wrench force) {
      this.link = link;
      this.columns = columns;
      this.own = columns.get(link);
      this.force = force;
      int count = own.size();
      inertia = new Wrench[count];
      velocity = new Wrench[count];
      position = new Wrench[count];
      change = new ScalarVector[count];
      for (int k = 0; k < count; k++) {
        JointColumns.Column column = own.get(k);
        inertia[k] = composite.times(column.itself());
        velocity[k] = composite.changed(column.itself()).plus(composite.times(column.both()));
        position[k] = composite.changed(column.first()).plus(composite.times(column.second()));
        change[k] = composite.changedBack(column.itself());
      }
    }

    void derive(Elements elements) {
      if (own.isEmpty()) {
        return;
      }
      withItself(elements);
      for (int k = 0; k < own.size(); k++) {
        position[k] = position[k].plus(own.get(k).itself().cross(force));
      }
      for (int i = link; mechanism.links().get(i).parent() != Links.ROOT; ) {
        Link below = mechanism.links().get(i);
        for (int k = 0; k < own.size(); k++) {
          inertia[k] = toParent.wrench(below, inertia[k]);
          velocity[k] = toParent.wrench(below, velocity[k]);
          position[k] = toParent.wrench(below, position[k]);
          change[k] = toParent.vector(below, change[k]);
        }
        i = below.parent();
        withAncestor(i, elements);
      }
    }

    private void withItself(Elements elements) {
      int n = own.size();
      Block block = new Block(n, n);
      for (int j = 0; j < n; j++) {
        Twist s = own.get(j).itself();
        for (int k = 0; k < n; k++) {
          block.mass[j][k] = own.get(Math.min(j, k)).itself().dot(inertia[Math.max(j, k)]);
          block.velocity[j][k] = s.dot(velocity[k]);
          block.position[j][k] = s.dot(position[k]);
        }
      }
      Link ball = mechanism.links().get(link);
      block.turn(ball);
      if (ball.isBall() && !ball.inverse()) {
        ScalarVector f =
            new ScalarVector(
                own.get(0).itself().dot(force),
                own.get(1).itself().dot(force),
                own.get(2).itself().dot(force));
        for (int c = 0; c < 3; c++) {
          int next = (c + 1) % 3;
          int last = (c + 2) % 3;
          block.position[next][last] = block.position[next][last].plus(f.at(c));
          block.position[last][next] = block.position[last][next].minus(f.at(c));
        }
      }
      block.putOut(places.of(link), places.of(link), elements);
      int[] at = places.of(link);
      for (int j = 0; j < n; j++) {
        for (int k = 0; k <= j; k++) {
          elements.putOutMass(at[j], at[k], block.mass[j][k]);
        }
      }
    }

    private void withAncestor(int ancestor, Elements elements) {
      List<JointColumns.Column> others = columns.get(ancestor);
      Block upper = new Block(others.size(), own.size());
      Block lower = new Block(own.size(), others.size());
      for (int j = 0; j < others.size(); j++) {
        JointColumns.Column other = others.get(j);
        for (int k = 0; k < own.size(); k++) {
          Scalar mass = other.itself().dot(inertia[k]);
          upper.mass[j][k] = mass;
          lower.mass[k][j] = mass;
          upper.velocity[j][k] = other.itself().dot(velocity[k]);
          upper.position[j][k] = other.itself().dot(position[k]);
          lower.velocity[k][j] =
              other.both().dot(inertia[k]).plus(other.itself().angular().dot(change[k]));
          lower.position[k][j] =
              other.second().dot(inertia[k]).plus(other.first().angular().dot(change[k]));
          elements.putOutMass(places.of(link)[k], places.of(ancestor)[j], mass);
        }
      }
      upper.turn(mechanism.links().get(link));
      lower.turn(mechanism.links().get(ancestor));
      upper.putOut(places.of(ancestor), places.of(link), elements);
      lower.putOut(places.of(link), places.of(ancestor), elements);
    }
  }

  /** Elements between the velocities of two links. */
  private final class Block {
    private final Scalar[][] mass;
    private final Scalar[][] velocity;
    private final Scalar[][] position;

    Block(int rows, int columns) {
      mass = new Scalar[rows][columns];
      velocity = new Scalar[rows][columns];
      position = new Scalar[rows][columns];
    }

    /** Adds C [ω]× + M [ω']× to the columns of a ball that turn against it. */
    void turn(Link columns) {
      if (!columns.isBall() || columns.inverse()) {
        return;
      }
      ScalarVector omega = coordinates.ballVelocity(columns);
      ScalarVector rate = coordinates.knownBallAcceleration(columns);
      for (int row = 0; row < mass.length; row++) {
        ScalarVector turned =
            vector(velocity[row]).cross(omega).plus(vector(mass[row]).cross(rate));
        for (int c = 0; c < 3; c++) {
          position[row][c] = position[row][c].plus(turned.at(c));
        }
      }
    }

    private static ScalarVector vector(Scalar[] row) {
      return new ScalarVector(row[0], row[1], row[2]);
    }

    void putOut(int[] rows, int[] columns, Elements elements) {
      for (int j = 0; j < rows.length; j++) {
        for (int k = 0; k < columns.length; k++) {
          elements.putOut(rows[j], columns[k], velocity[j][k], position[j][k]);
        }
      }
    }
  }
}
