package org.mechservice.solver.force.law.printed;

import org.mechservice.solver.force.law.CoordinateLaw;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.force.law.PrintedLaw;

/**
 * The printed laws. Printed from its formula; do not edit. PrintedLawsTest compares it with the
 * formula and
 * prints it anew with -Dgolden.write=true.
 */
public final class PrintedLaws {
  private PrintedLaws() {}

  /**
   * Returns a new instance of a law.
   *
   * @param smooth whether its smoothing is positive, otherwise zero; of no effect if it has none
   */
  public static PrintedLaw of(PairLaw law, boolean smooth) {
    return switch (law) {
      case SPRING -> new PrintedSpring();
      case ROPE -> smooth ? new PrintedSmoothRope() : new PrintedRope();
      case BUFFER -> smooth ? new PrintedSmoothBuffer() : new PrintedBuffer();
      case BUSHING -> new PrintedBushing();
      case LINEAR_BUSHING -> new PrintedLinearBushing();
      case CONTACT -> smooth ? new PrintedSmoothContact() : new PrintedContact();
      case CONTACT_OF_CENTRE -> smooth ? new PrintedSmoothContactOfCentre() : new
          PrintedContactOfCentre();
      case INVERSE_SQUARE -> new PrintedInverseSquare();
      case ROTATION_FRICTION -> new PrintedRotationFriction();
      default -> throw new IllegalStateException(law + " is not printed");
    };
  }

  /**
   * Returns a new instance of a law.
   *
   * @param smooth whether its smoothing is positive, otherwise zero; of no effect if it has none
   */
  public static PrintedLaw of(CoordinateLaw law, boolean smooth) {
    return switch (law) {
      case SPRING -> new PrintedJointSpring();
      case UPPER_STOP -> smooth ? new PrintedSmoothJointUpperStop() : new PrintedJointUpperStop();
      case LOWER_STOP -> smooth ? new PrintedSmoothJointLowerStop() : new PrintedJointLowerStop();
      case FRICTION -> new PrintedJointFriction();
      default -> throw new IllegalStateException(law + " is not printed");
    };
  }
}
