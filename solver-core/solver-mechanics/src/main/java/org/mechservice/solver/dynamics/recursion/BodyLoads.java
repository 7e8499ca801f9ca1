package org.mechservice.solver.dynamics.recursion;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.links.Axes;
import org.mechservice.solver.links.BodyPlacement;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.step.StepBlock;

/** The wrenches on bodies in the frames of the links that carry them. */
final class BodyLoads {
  private static final int POSE = 12;

  private final int[] treeLink;
  private final int[] carrier;

  /** Rotation, row by row, and point of each body: 12. */
  private final double[] pose;

  private final int[] blocks;

  BodyLoads(TreeGeometry tree, Links links, int[] blocks) {
    this.blocks = blocks;
    List<BodyPlacement> places = links.bodies();
    treeLink = tree.linkOfBody;
    carrier = new int[places.size()];
    pose = new double[POSE * places.size()];
    for (int body = 0; body < carrier.length; body++) {
      BodyPlacement place = places.get(body);
      carrier[body] = place.link();
      double[][] rows = Axes.elements(place.toFrame());
      for (int k = 0; k < 9; k++) {
        pose[POSE * body + k] = rows[k / 3][k % 3];
      }
      int at = 3 * treeLink[body];
      boolean moves = tree.kind[treeLink[body]] != LinkKind.FIXED;
      Vector3 own =
          new Vector3(tree.bodyOrigin[at], tree.bodyOrigin[at + 1], tree.bodyOrigin[at + 2]);
      // the reference point of a body that moves is the computing origin
      Vector3 reference = moves ? Vector3.ZERO : place.origin().minus(place.toFrame().apply(own));
      pose[POSE * body + 9] = reference.x();
      pose[POSE * body + 10] = reference.y();
      pose[POSE * body + 11] = reference.z();
    }
  }

  /** Writes the applied wrenches of all links; without any, they stay as they were: zero. */
  void load(double[] wrench, double[] w) {
    if (wrench.length == 0) {
      return;
    }
    for (int block : blocks) {
      Arrays.fill(w, block + StepBlock.LOAD, block + StepBlock.LOAD + 6, 0);
    }
    for (int body = 0; body < carrier.length; body++) {
      if (carrier[body] != Links.ROOT) {
        add(body, wrench, 6 * treeLink[body], w, blocks[carrier[body]] + StepBlock.LOAD);
      }
    }
  }

  /**
   * Adds a wrench on a body's own link in the computing frame of the link that carries the body.
   *
   * @param wrench [moment; force] in link axes at the reference point, from {@code from}
   */
  void add(int body, double[] wrench, int from, double[] sum, int at) {
    int r = POSE * body;
    double fx = turned(r, wrench, from + 3);
    double fy = turned(r + 3, wrench, from + 3);
    double fz = turned(r + 6, wrench, from + 3);
    double x = pose[r + 9];
    double y = pose[r + 10];
    double z = pose[r + 11];
    sum[at] += turned(r, wrench, from) + y * fz - z * fy;
    sum[at + 1] += turned(r + 3, wrench, from) + z * fx - x * fz;
    sum[at + 2] += turned(r + 6, wrench, from) + x * fy - y * fx;
    sum[at + 3] += fx;
    sum[at + 4] += fy;
    sum[at + 5] += fz;
  }

  private double turned(int row, double[] v, int at) {
    return pose[row] * v[at] + pose[row + 1] * v[at + 1] + pose[row + 2] * v[at + 2];
  }
}
