package org.mechservice.sim.equations.derivatives;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.mechservice.sim.equations.force.AppliedForces;
import org.mechservice.sim.equations.force.MassiveRodTerms;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.sim.equations.loop.LoopRows;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.JointSweep;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.equations.recursion.RigidComposite;
import org.mechservice.sim.equations.recursion.VelocityRows;
import org.mechservice.solver.closure.equations.UnwrappedAngles;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The derivatives of the residual M v' + b − τ of an open chain by v', v and q (RR-JF), each
 * between a joint and its ancestors, O(n · depth): with Iᶜ, 2Bᶜ and fᶜ of a link with all links
 * beyond it, for j on the way from k to the root (Singh, Russell and Wensing 2022; Carpentier and
 * Mansard 2018),
 *
 * <pre>
 * M_jk = S_jᵀ Iᶜ S_k
 * ∂F_j/∂v_k = S_jᵀ (2Bᶜ S_k + Iᶜ (ψ'_k + S'_k))      ∂F_k/∂v_j = S_kᵀ (2Bᶜ S_j + Iᶜ (ψ'_j + S'_j))
 * ∂F_j/∂q_k = S_jᵀ (2Bᶜ ψ'_k + Iᶜ ψ''_k + S_k ×* fᶜ)  ∂F_k/∂q_j = S_kᵀ (2Bᶜ ψ'_j + Iᶜ ψ''_j)
 * </pre>
 *
 * <p>These equations hold for columns fixed in the moving link. The columns of a ball whose
 * velocity is in the axes of its parent rotate relative to the link: ∂F/∂q of its three columns
 * gets ∂F/∂v [ω]× + M [ω']×, its own rows less [Sᵀ fᶜ]×.
 *
 * <p>With closed loops, Jᵀ λ is treated as a force, and so is the inertia force of a rod at one end
 * due to the acceleration of the other: they are differentiated with the applied forces.
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
  private final TreeOrder places;

  /** Terms of rods between bodies in M, by velocities of the state. */
  private final Scalar[][] massOfRods;

  /**
   * @param derivative first input of the accelerations, as in {@link Coordinates}
   */
  private ResidualDerivatives(Links mechanism, int derivative) {
    this.mechanism = mechanism;
    coordinates = new Coordinates(program, mechanism, derivative);
    places = new TreeOrder(mechanism);
    massOfRods = new Scalar[mechanism.velocityCount()][mechanism.velocityCount()];
    for (Scalar[] row : massOfRods) {
      Arrays.fill(row, expressions.zero());
    }
  }

  /** Derives the program of an open chain. */
  public static Derived derive(Links mechanism) {
    int states = mechanism.mechanism().stateCount();
    ResidualDerivatives tree = new ResidualDerivatives(mechanism, states);
    List<Integer> coupled = new ArrayList<>();
    tree.derive(
        (sweep, kinematics, loads) -> {},
        slopes -> {
          coupled.addAll(slopes.coupled());
          return new ElementLayout.OfTree(tree.places.pattern(coupled));
        });
    String text = coupled.stream().map(String::valueOf).collect(Collectors.joining(" "));
    return new Derived(tree.program, tree.places.text(), text);
  }

  /**
   * Derives the program of a mechanism with loops: from [q; v], followed by counted angles, v' and
   * λ, to the derivatives of M v' + b − τ + Jᵀ λ in the order of {@link
   * org.mechservice.solver.closure.equations.LoopTerms.OfDerivatives}.
   */
  public static Program ofLoops(Links mechanism) {
    // accelerations count like velocities, which come after the positions
    int accelerations = mechanism.velocityCount() + counted(mechanism);
    ResidualDerivatives closed =
        new ResidualDerivatives(MassiveRodTerms.withEnds(mechanism), accelerations);
    closed.derive(closed::addLoops, slopes -> new ElementLayout.Dense(closed.places));
    return closed.program;
  }

  /** Returns the number of inputs between the velocities and the accelerations. */
  private static int counted(Links mechanism) {
    return mechanism.mechanism().furtherStates().size()
        + UnwrappedAngles.of(mechanism.mechanism()).size();
  }

  /** Adds further loads besides the forces of the model. */
  private interface FurtherLoads {
    void addTo(ForceSweep sweep, LinkKinematics kinematics, Loads loads);
  }

  /** Adds −Jᵀ λ, and the coupling forces of rods. */
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

  private void derive(FurtherLoads further, Function<ForceSlopes, ElementLayout> placing) {
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
    ElementLayout layout = placing.apply(slopes);
    slopes.putOutFurther(program, applied.furtherRates(), layout.count());
    ElementSums elements = new ElementSums(program, places, layout, slopes, massOfRods);
    new JointSweep(program, mechanism, coordinates).sweep(forces, loads);
    RigidComposite[] composites = composites(columns);
    elements.putOutBetweenBranches();
    LinkRows rows = new LinkRows(program, mechanism, coordinates, places, elements);
    for (int i = 0; i < forces.length; i++) {
      Link link = mechanism.links().get(i);
      program.section(
          "Derivatives: "
              + link.title()
              + ".\nM = S_j.I S_k, and behind it C = S_k.(2 B S_j + I (psi' + S')_j), K = S_k.(2 B"
              + " psi'_j + I psi''_j)",
          link.bodyLabel());
      rows.derive(link.isDriven() ? List.of() : columns.of(link), composites[i], forces[i]);
    }
  }

  /** Sums inwards. */
  private RigidComposite[] composites(JointColumns columns) {
    RigidComposite[] composites = new RigidComposite[mechanism.links().size()];
    for (int i = 0; i < composites.length; i++) {
      Link link = mechanism.links().get(i);
      program.section("Momentum: " + link.title() + ".", link.bodyLabel());
      composites[i] = RigidComposite.of(coordinates.step(link).rigidInertia(), columns.velocity(i));
    }
    for (int i = composites.length - 1; i >= 0; i--) {
      Link link = mechanism.links().get(i);
      program.section(
          "Composite inertia and its change: " + link.title() + ".\nI_p += X I X', B_p += X B X'",
          link.bodyLabel());
      if (link.parent() != Links.ROOT) {
        int p = link.parent();
        composites[p] = composites[p].plus(coordinates.step(link).toParent(composites[i]));
      }
    }
    return composites;
  }
}
