package org.mechservice.solver.force.user;

import java.util.Arrays;
import org.mechservice.solver.api.ForceDeclaration.Reads;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.force.applied.TreeCoordinate;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Readings and loads of a user force. The readings are copies, so that differences can change them
 * one by one.
 */
final class UserForceReading implements ForceState, ForceLoads {
  private final DeclaredPoint[] points;
  private final TreeCoordinate[] coordinates;
  private final int[] parameters;
  private final double[] parameterValues;
  private double time;

  /** Readings of the coordinates, and their loads. */
  final double[] position;

  final double[] rate;
  final double[] jointForce;

  /** Output values. */
  final double[] values;

  UserForceReading(UserForceNames names, int modelParameters) {
    points = names.points.toArray(DeclaredPoint[]::new);
    coordinates = names.coordinates.toArray(TreeCoordinate[]::new);
    parameters = names.parameters.stream().mapToInt(Integer::intValue).toArray();
    parameterValues = new double[modelParameters];
    position = new double[coordinates.length];
    rate = new double[coordinates.length];
    jointForce = new double[coordinates.length];
    values = new double[names.values.size()];
  }

  void parameters(double[] all) {
    System.arraycopy(all, 0, parameterValues, 0, parameterValues.length);
  }

  /** Sets all readings from a swept motion. */
  void read(double t, TreeMotion motion) {
    time = t;
    for (DeclaredPoint point : points) {
      point.read(motion);
    }
    for (int c = 0; c < coordinates.length; c++) {
      int at = coordinates[c].position();
      position[c] = at < 0 ? 0 : motion.q[at];
      rate[c] = motion.v[coordinates[c].velocity()];
    }
  }

  /** Sets all loads to zero. */
  void clear() {
    for (DeclaredPoint point : points) {
      Arrays.fill(point.load, 0);
    }
    Arrays.fill(jointForce, 0);
  }

  @Override
  public double time() {
    return time;
  }

  @Override
  public double parameter(int parameter) {
    return parameterValues[parameters[parameter]];
  }

  @Override
  public double coordinate(int coordinate) {
    if (coordinates[coordinate].position() < 0) {
      throw new IllegalStateException(
          "coordinate " + coordinate + " is a rotation without a position of its own");
    }
    return position[coordinate];
  }

  @Override
  public double rate(int coordinate) {
    return rate[coordinate];
  }

  private DeclaredPoint reading(int point, Reads what) {
    DeclaredPoint declared = points[point];
    if (!declared.reads.contains(what)) {
      throw new IllegalStateException(
          "point " + point + " was not declared to be read for its " + what);
    }
    return declared;
  }

  @Override
  public void position(int point, double[] out) {
    System.arraycopy(reading(point, Reads.POSITION).position, 0, out, 0, 3);
  }

  @Override
  public void velocity(int point, double[] out) {
    System.arraycopy(reading(point, Reads.VELOCITY).velocity, 0, out, 0, 3);
  }

  @Override
  public void rotation(int point, double[] out) {
    System.arraycopy(reading(point, Reads.ROTATION).rotation, 0, out, 0, 9);
  }

  @Override
  public void angularVelocity(int point, double[] out) {
    System.arraycopy(reading(point, Reads.ANGULAR_VELOCITY).angularVelocity, 0, out, 0, 3);
  }

  @Override
  public void addForce(int point, double x, double y, double z) {
    add(points[point].load, 0, x, y, z);
  }

  @Override
  public void addTorque(int point, double x, double y, double z) {
    add(points[point].load, 3, x, y, z);
  }

  private static void add(double[] load, int at, double x, double y, double z) {
    load[at] += x;
    load[at + 1] += y;
    load[at + 2] += z;
  }

  @Override
  public void addJointForce(int coordinate, double force) {
    jointForce[coordinate] += force;
  }

  @Override
  public void setValue(int value, double x) {
    values[value] = x;
  }
}
