package org.mechservice.solver.dynamics;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
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
 * A tree with one state and the accelerations another program gives for it; see README.md beside
 * the files.
 *
 * @param mechanism the tree
 * @param state [q; v], rad, m, rad/s, m/s
 * @param tau joint forces, N·m, N
 * @param accelerations joint accelerations, rad/s², m/s²
 */
public record PublishedChain(
    Mechanism mechanism, List<Double> state, List<Double> tau, List<Double> accelerations) {

  public static PublishedChain read(String name) {
    List<Body> bodies = new ArrayList<>();
    List<Joint> joints = new ArrayList<>();
    List<Double> q = new ArrayList<>();
    List<Double> v = new ArrayList<>();
    List<Double> tau = new ArrayList<>();
    for (String line : lines(name + ".csv")) {
      if (line.startsWith("#")) {
        continue;
      }
      String[] word = line.split(" ", -1);
      double[] x = new double[22];
      for (int i = 3; i < 22; i++) {
        x[i] = Double.parseDouble(word[i]);
      }
      int index = bodies.size();
      bodies.add(
          new Body(
              word[0],
              x[9],
              new Vector3(x[10], x[11], x[12]),
              new InertiaTensor(x[13], x[14], x[15], x[16], x[17], x[18]),
              Origin.NONE));
      Attachment attachment =
          new Attachment(
              Integer.parseInt(word[1]),
              new Vector3(x[6], x[7], x[8]),
              index,
              Vector3.ZERO,
              Rotation.IDENTITY);
      Vector3 axis = new Vector3(x[3], x[4], x[5]).normalized();
      joints.add(
          word[2].equals("R")
              ? new Revolute(word[0], attachment, axis, x[19], x[20], Origin.NONE)
              : new Prismatic(word[0], attachment, axis, x[19], x[20], Origin.NONE));
      q.add(x[19]);
      v.add(x[20]);
      tau.add(x[21]);
    }
    q.addAll(v);
    Root root = new Root("ground", Vector3.ZERO, Rotation.IDENTITY);
    Mechanism mechanism = new Mechanism(name, root, new Vector3(0, 0, -9.81), bodies, joints);
    List<Double> accelerations =
        lines(name + ".ref").stream().map(String::strip).map(Double::valueOf).toList();
    return new PublishedChain(mechanism, q, tau, accelerations);
  }

  static List<String> lines(String resource) {
    try (InputStream in = PublishedChain.class.getResourceAsStream(resource)) {
      if (in == null) {
        throw new IllegalArgumentException("no test resource " + resource);
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  public double[] y() {
    return state.stream().mapToDouble(Double::doubleValue).toArray();
  }

  public double[] jointForces() {
    return tau.stream().mapToDouble(Double::doubleValue).toArray();
  }

  public double[] expected() {
    return accelerations.stream().mapToDouble(Double::doubleValue).toArray();
  }
}
