package org.mechservice.sim.equations.derivatives;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.recursion.ParentTransform;
import org.mechservice.sim.equations.recursion.RigidComposite;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The elements between the velocities of a link and those of itself and its ancestors: quantities
 * of its columns are transformed inwards, link by link, and multiplied by the columns there.
 *
 * <p>Three passes lead to the root: with Iᶜ S and the change of a moment, with the wrenches of
 * ∂/∂v, and with those of ∂/∂q. Each step of a pass is a section that ends with its outputs, so
 * compiled code needs few registers. A single section per link would load all values of the pass
 * first and keep all elements until its end.
 */
final class LinkRows {
  private final Program program;
  private final List<Link> links;
  private final Coordinates coordinates;
  private final TreeOrder places;
  private final ElementSums elements;
  private final ParentTransform toParent;
  private final List<List<JointColumns.Column>> columns = new ArrayList<>();

  LinkRows(
      Program program,
      Links mechanism,
      Coordinates coordinates,
      TreeOrder places,
      ElementSums elements) {
    this.program = program;
    this.links = mechanism.links();
    this.coordinates = coordinates;
    this.places = places;
    this.elements = elements;
    this.toParent = new ParentTransform(coordinates);
  }

  /**
   * Derives the elements of the next link.
   *
   * @param own its columns; empty if it has no velocities in the state
   * @param composite the link with all links beyond it
   * @param force their inertia wrench, about the link's origin
   */
  void derive(List<JointColumns.Column> own, RigidComposite composite, Wrench force) {
    columns.add(own);
    if (!own.isEmpty()) {
      Rows rows = new Rows(columns.size() - 1, own);
      rows.masses(composite);
      rows.velocities(composite);
      rows.positions(composite, force);
    }
  }

  /** The rows of one link. */
  private final class Rows {
    private final int link;
    private final List<JointColumns.Column> own;

    /** The link and its ancestors. */
    private final List<Integer> way = new ArrayList<>();

    /** Elements between each of them and the link's columns. */
    private final List<Block> upper = new ArrayList<>();

    Rows(int link, List<JointColumns.Column> own) {
      this.link = link;
      this.own = own;
      for (int i = link; i != Links.ROOT; i = links.get(i).parent()) {
        way.add(i);
        upper.add(new Block(columns.get(i).size(), own.size()));
      }
    }

    /** Derives M, and the rows of C and K. */
    void masses(RigidComposite composite) {
      Wrench[] inertia = wrenches(column -> composite.times(column.itself()));
      ScalarVector[] change =
          own.stream()
              .map(column -> composite.changedBack(column.itself()))
              .toArray(ScalarVector[]::new);
      withItself(inertia);
      for (int step = 1; step < way.size(); step++) {
        Link below = stepTo(step);
        for (int k = 0; k < inertia.length; k++) {
          inertia[k] = toParent.wrench(below, inertia[k]);
          change[k] = toParent.vector(below, change[k]);
        }
        withAncestor(step, inertia, change);
      }
    }

    private void withItself(Wrench[] inertia) {
      Block block = upper.get(0);
      int[] at = places.of(link);
      for (int j = 0; j < at.length; j++) {
        for (int k = 0; k <= j; k++) {
          Scalar mass = own.get(k).itself().dot(inertia[j]);
          block.mass[j][k] = mass;
          block.mass[k][j] = mass;
          elements.putOutMass(at[j], at[k], j == k ? withArmature(mass) : mass);
        }
      }
    }

    /** The armature of a ball does not turn with it, so that the block has none. */
    private Scalar withArmature(Scalar mass) {
      double armature = links.get(link).armature();
      return armature == 0 ? mass : mass.plus(mass.expressions().constant(armature));
    }

    private void withAncestor(int step, Wrench[] inertia, ScalarVector[] change) {
      int ancestor = way.get(step);
      List<JointColumns.Column> others = columns.get(ancestor);
      Block lower = new Block(own.size(), others.size());
      for (int j = 0; j < others.size(); j++) {
        JointColumns.Column other = others.get(j);
        for (int k = 0; k < own.size(); k++) {
          Scalar mass = other.itself().dot(inertia[k]);
          upper.get(step).mass[j][k] = mass;
          lower.mass[k][j] = mass;
          lower.velocity[k][j] =
              other.both().dot(inertia[k]).plus(other.itself().angular().dot(change[k]));
          lower.position[k][j] =
              other.second().dot(inertia[k]).plus(other.first().angular().dot(change[k]));
          elements.putOutMass(places.of(link)[k], places.of(ancestor)[j], mass);
        }
      }
      lower.turn(links.get(ancestor));
      putOut(lower.velocity, link, ancestor, elements::putOutByVelocity);
      putOut(lower.position, link, ancestor, elements::putOutByPosition);
    }

    /** Derives the columns of C. */
    void velocities(RigidComposite composite) {
      program.section(title("C = S_j.(2 B S_k + I (psi' + S')_k)"), label());
      Wrench[] change =
          wrenches(
              column -> composite.changed(column.itself()).plus(composite.times(column.both())));
      for (int step = 0; step < way.size(); step++) {
        inwards(change, step);
        Block block = upper.get(step);
        dots(step, change, block.velocity);
        putOut(block.velocity, way.get(step), link, elements::putOutByVelocity);
      }
    }

    /** Derives the columns of K. */
    void positions(RigidComposite composite, Wrench force) {
      program.section(title("K = S_j.(2 B psi'_k + I psi''_k + S_k x* f)"), label());
      Wrench[] change =
          wrenches(
              column -> composite.changed(column.first()).plus(composite.times(column.second())));
      for (int step = 0; step < way.size(); step++) {
        inwards(change, step);
        Block block = upper.get(step);
        dots(step, change, block.position);
        block.turn(links.get(link));
        if (step == 0) {
          turnRows(block.position, force);
          for (int k = 0; k < change.length; k++) {
            change[k] = change[k].plus(own.get(k).itself().cross(force));
          }
        }
        putOut(block.position, way.get(step), link, elements::putOutByPosition);
      }
    }

    /** Subtracts [Sᵀ f]× from the rows of a ball whose columns rotate relative to it. */
    private void turnRows(Scalar[][] position, Wrench force) {
      Link ball = links.get(link);
      if (!ball.isBall() || ball.inverse() || ball.isDriven()) {
        return;
      }
      for (int c = 0; c < 3; c++) {
        Scalar f = own.get(c).itself().dot(force);
        int next = (c + 1) % 3;
        int last = (c + 2) % 3;
        position[next][last] = position[next][last].plus(f);
        position[last][next] = position[last][next].minus(f);
      }
    }

    private Wrench[] wrenches(Function<JointColumns.Column, Wrench> of) {
      return own.stream().map(of).toArray(Wrench[]::new);
    }

    /** Transforms wrenches to the frame of the link at a step. */
    private void inwards(Wrench[] wrenches, int step) {
      if (step > 0) {
        Link below = stepTo(step);
        for (int k = 0; k < wrenches.length; k++) {
          wrenches[k] = toParent.wrench(below, wrenches[k]);
        }
      }
    }

    /** Opens the section of a step and returns the link it comes from. */
    private Link stepTo(int step) {
      program.step("On to " + links.get(way.get(step)).title() + ".", label());
      return links.get(way.get(step - 1));
    }

    private void dots(int step, Wrench[] wrenches, Scalar[][] into) {
      List<JointColumns.Column> others = columns.get(way.get(step));
      for (int j = 0; j < others.size(); j++) {
        for (int k = 0; k < wrenches.length; k++) {
          into[j][k] = others.get(j).itself().dot(wrenches[k]);
        }
      }
    }

    private void putOut(Scalar[][] block, int rows, int columns, Put put) {
      int[] row = places.of(rows);
      int[] column = places.of(columns);
      for (int j = 0; j < row.length; j++) {
        for (int k = 0; k < column.length; k++) {
          put.element(row[j], column[k], block[j][k]);
        }
      }
    }

    private String title(String equation) {
      return "Derivatives: " + links.get(link).title() + ".\n" + equation;
    }

    private String label() {
      return links.get(link).bodyLabel();
    }
  }

  /** Outputs an element. */
  private interface Put {
    void element(int row, int column, Scalar value);
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

    /** Adds C [ω]× + M [ω']× to the columns of a ball that rotate relative to it. */
    void turn(Link columns) {
      if (!columns.isBall() || columns.inverse() || columns.isDriven()) {
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
  }
}
