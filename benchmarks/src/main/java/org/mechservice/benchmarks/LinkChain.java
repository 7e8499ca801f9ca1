package org.mechservice.benchmarks;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/** A hanging chain of equal bars, turning about y and about z in turn. */
public final class LinkChain {
  private static final double LENGTH = 0.1;
  private static final double MASS = 0.2;

  private LinkChain() {}

  /** Returns a chain. */
  public static Mechanism of(int links) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    double across = MASS * LENGTH * LENGTH / 12;
    for (int i = 0; i < links; i++) {
      bodies.add(
          new Body(
              "link" + i,
              MASS,
              new Vector3(0.5 * LENGTH, 0, 0),
              new InertiaTensor(1e-5, across, across, 0, 0, 0),
              Origin.NONE));
      Vector3 onParent = i == 0 ? Vector3.ZERO : new Vector3(LENGTH, 0, 0);
      Vector3 axis = i % 2 == 0 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
      Attachment attachment = new Attachment(i - 1, onParent, i, Vector3.ZERO, Rotation.IDENTITY);
      joints.add(new Revolute("joint" + i, attachment, axis, 0.1, 0.2, Origin.NONE));
    }
    Root root = new Root("Ground", Vector3.ZERO, Rotation.IDENTITY);
    return new Mechanism("Chain" + links, root, new Vector3(0, 0, -9.81), bodies, joints);
  }

  /**
   * Returns a tree of bars whose joints turn, every fourth slides, about random axes; each bar is
   * on one of the eight before it.
   */
  public static Mechanism tree(int links) {
    Random random = new Random(links);
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    for (int i = 0; i < links; i++) {
      bodies.add(
          new Body(
              "link" + i,
              MASS,
              direction(random).times(0.5 * LENGTH),
              new InertiaTensor(3e-4, 4e-4, 5e-4, 1e-5, 2e-5, 3e-5),
              Origin.NONE));
      int parent = i == 0 ? Mechanism.ROOT : random.nextInt(Math.max(0, i - 8), i);
      Vector3 onParent = direction(random).times(LENGTH);
      Attachment attachment =
          new Attachment(parent, onParent, i, Vector3.ZERO, Rotation.about(direction(random), 1));
      joints.add(
          i % 4 == 3
              ? new Prismatic("joint" + i, attachment, direction(random), 0.1, 0.2, Origin.NONE)
              : new Revolute("joint" + i, attachment, direction(random), 0.1, 0.2, Origin.NONE));
    }
    Root root = new Root("Ground", Vector3.ZERO, Rotation.IDENTITY);
    return new Mechanism("Tree" + links, root, new Vector3(0, 0, -9.81), bodies, joints);
  }

  private static Vector3 direction(Random random) {
    return new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
        .normalized();
  }
}
