package org.mechservice.solver.force.user;

import static org.mechservice.solver.spatial.Blocks.multiply;
import static org.mechservice.solver.spatial.Blocks.rotationAbout;

import org.mechservice.solver.force.formula.LeafInput;
import org.mechservice.solver.spatial.SinCos;

/**
 * One number that a user force reads. It can be shifted, and has a gradient by links and
 * coordinates.
 */
final class UserForceSensor {
  final LeafInput input;
  private final double[] readings;
  private final int index;
  private final boolean isRotation;
  private final double[] axis = new double[3];
  private final double[] sinCos = new double[2];
  private final double[] turn = new double[9];
  private final double[] turned = new double[9];

  /** Returns the sensor of a number among the readings. */
  UserForceSensor(LeafInput input, double[] readings, int index) {
    this(input, readings, index, false);
  }

  private UserForceSensor(LeafInput input, double[] readings, int index, boolean isRotation) {
    this.input = input;
    this.readings = readings;
    this.index = index;
    this.isRotation = isRotation;
    if (isRotation) {
      axis[index] = 1;
    }
  }

  /** Returns the sensor of a small rotation of a rotation matrix about a world axis. */
  static UserForceSensor rotation(LeafInput input, double[] matrix, int axis) {
    return new UserForceSensor(input, matrix, axis, true);
  }

  /**
   * Returns a step for central differences, at which truncation and rounding errors are about equal
   * for a function that changes over one unit or over the number's own size.
   */
  double step() {
    double size = isRotation ? 1 : Math.max(1, Math.abs(readings[index]));
    return StrictMath.cbrt(Math.ulp(size));
  }

  /** Shifts the reading. */
  void shift(double by) {
    if (!isRotation) {
      readings[index] += by;
      return;
    }
    SinCos.sinCos(by, sinCos, 0);
    rotationAbout(axis, 0, sinCos[0], sinCos[1], turn, 0);
    multiply(turn, 0, readings, 0, turned, 0);
    System.arraycopy(turned, 0, readings, 0, 9);
  }
}
