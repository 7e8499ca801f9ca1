package org.mechservice.benchmarks;

import java.util.ArrayList;
import java.util.List;
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

/**
 * Reads a tree of bodies, one a line: name, parent, R or P, axis, joint in the parent, mass, centre
 * of mass, inertia xx yy zz xy xz yz, position and velocity; all frames parallel.
 */
final class TimingTable {
  private TimingTable() {}

  static Mechanism read(String text, String name) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    text.lines()
        .filter(line -> !line.startsWith("#"))
        .forEach(
            line -> {
              String[] cells = line.split(" ", -1);
              double[] x = new double[cells.length];
              for (int i = 3; i < x.length; i++) {
                x[i] = Double.parseDouble(cells[i]);
              }
              Attachment attachment =
                  new Attachment(
                      Integer.parseInt(cells[1]),
                      new Vector3(x[6], x[7], x[8]),
                      bodies.size(),
                      Vector3.ZERO,
                      Rotation.IDENTITY);
              Vector3 axis = new Vector3(x[3], x[4], x[5]).normalized();
              String joint = "j_" + cells[0];
              joints.add(
                  cells[2].equals("R")
                      ? new Revolute(joint, attachment, axis, x[19], x[20], Origin.NONE)
                      : new Prismatic(joint, attachment, axis, x[19], x[20], Origin.NONE));
              bodies.add(
                  new Body(
                      cells[0],
                      x[9],
                      new Vector3(x[10], x[11], x[12]),
                      new InertiaTensor(x[13], x[14], x[15], x[16], x[17], x[18]),
                      Origin.NONE));
            });
    Root root = new Root("Ground", Vector3.ZERO, Rotation.IDENTITY);
    return new Mechanism(name, root, new Vector3(0, 0, -9.81), bodies, joints);
  }
}
