package org.mechservice.solver.kinematics.pair;

import static org.mechservice.solver.spatial.Blocks.apply;
import static org.mechservice.solver.spatial.Blocks.cross;
import static org.mechservice.solver.spatial.Blocks.dot;

import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * A component of the shortest rotation that brings B to a pose of the joint, in any pose: φ times a
 * direction, up to half a turn. There the direction is one of many, the same for all components.
 * Workspace of one thread.
 */
sealed interface LargeTilt {
  /**
   * Returns the component, rad.
   *
   * @param gradient by [δθ; δρ]; the first three numbers are overwritten by a unit vector
   */
  double evaluate(RelativeMotion r, double[] gradient);

  private static double[] components(Vector3 v) {
    return new double[] {v.x(), v.y(), v.z()};
  }

  /**
   * φ u · k of the rotation by φ about u that B has made since zero, with the gradient k: to first
   * order φ u changes by δθ along u, which alone matters for its length.
   */
  final class OfFrame implements LargeTilt {
    private final double[] axis;
    private final double[] toB;
    private final double[] turned = new double[9];
    private final double[] e = new double[4];

    /**
     * @param axis k, unit vector in A's axes
     * @param toB rotation from A's axes to B's at zero
     */
    OfFrame(Vector3 axis, Rotation toB) {
      this.axis = components(axis);
      this.toB =
          new double[] {
            toB.xx(), toB.xy(), toB.xz(), toB.yx(), toB.yy(), toB.yz(), toB.zx(), toB.zy(), toB.zz()
          };
    }

    @Override
    public double evaluate(RelativeMotion r, double[] gradient) {
      for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
          turned[3 * i + j] =
              r.rotation[3 * i] * toB[j]
                  + r.rotation[3 * i + 1] * toB[3 + j]
                  + r.rotation[3 * i + 2] * toB[6 + j];
        }
      }
      EulerParameters.of(turned, 0, e, 0);
      double sine = Math.sqrt(dot(e, 1, e, 1));
      double along = dot(axis, 0, e, 1);
      System.arraycopy(axis, 0, gradient, 0, 3);
      return sine == 0 ? 0 : 2 * StrictMath.atan2(sine, e[0]) * (along / sine);
    }
  }

  /**
   * θ l · k of the angle θ by which an axis b of B leans from the axis a of A in the direction l, a
   * unit vector normal to a, and k another. With n = a × l, about which b leans, and m = b × n
   * reversed, the gradient is (k · l) n − (k · n) m: the direction k carried to b by the shortest
   * rotation, then crossed with b.
   */
  final class OfAxis implements LargeTilt {
    private final double[] axis;
    private final double[] normal;
    private final double[] axisB;

    /** The direction taken where the axes are opposite, the same for both components. */
    private final double[] anyLean;

    private final double[] b = new double[3];
    private final double[] lean = new double[3];
    private final double[] about = new double[3];

    /**
     * @param axis a, unit vector in A's axes
     * @param normal k, unit vector normal to it, in A's axes
     * @param axisB unit vector in B's axes
     */
    OfAxis(Vector3 axis, Vector3 normal, Vector3 axisB) {
      this.axis = components(axis);
      this.normal = components(normal);
      this.axisB = components(axisB);
      anyLean = components(JointFunctions.normalTo(axis));
    }

    @Override
    public double evaluate(RelativeMotion r, double[] gradient) {
      apply(r.rotation, 0, axisB, 0, b, 0);
      double cosine = dot(axis, 0, b, 0);
      for (int i = 0; i < 3; i++) {
        lean[i] = b[i] - cosine * axis[i];
      }
      double sine = Math.sqrt(dot(lean, 0, lean, 0));
      for (int i = 0; i < 3; i++) {
        lean[i] = sine > 0 ? lean[i] / sine : anyLean[i];
      }
      cross(axis, 0, lean, 0, about, 0);
      double alongLean = dot(normal, 0, lean, 0);
      double alongAbout = dot(normal, 0, about, 0);
      for (int i = 0; i < 3; i++) {
        double m = cosine * lean[i] - sine * axis[i];
        gradient[i] = alongLean * about[i] - alongAbout * m;
      }
      return StrictMath.atan2(sine, cosine) * alongLean;
    }
  }
}
